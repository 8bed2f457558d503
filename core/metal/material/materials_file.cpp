// Reads material files: TOML in SI in which every value names its source.
#include "core/base/error.hpp"
#include "core/base/resources.hpp"
#include "core/base/text.hpp"
#include "core/base/toml_table.hpp"
#include "core/metal/material/materials.hpp"

#include <algorithm>
#include <cctype>

namespace meltpool {

namespace {

constexpr NumberRange kTemperature{0, 10000};

/// Reads a `{ value = .., source = ".." }` with nothing else in it.
double readValue(TomlTable& parent, std::string_view key, NumberRange range, std::string& source) {
    TomlTable entry = parent.table(key);
    const double value = entry.number("value", range);
    source = entry.text("source");
    entry.finish();
    return value;
}

/// Reads a value, or `{ table = [[kelvin, value], ..], source = ".." }`.
Property readProperty(TomlTable& parent, std::string_view key, NumberRange range) {
    TomlTable entry = parent.table(key);
    Property property;
    if (entry.has("table")) {
        for (const auto& row : entry.rows("table", 2)) {
            if (!property.points.empty() && row[0] <= property.points.back().temperature)
                entry.fail("table", "temperatures must rise from row to row");
            if (row[0] < kTemperature.minimum || row[0] > kTemperature.maximum)
                entry.fail("table", "expected temperatures from 0 to 10000 K");
            if (row[1] < range.minimum || row[1] > range.maximum)
                entry.fail("table", "expected values from " + formatNumber(range.minimum) + " to " +
                                        formatNumber(range.maximum));
            property.points.push_back({row[0], row[1]});
        }
    } else {
        property.points.push_back({0, entry.number("value", range)});
    }
    property.source = entry.text("source");
    entry.finish();
    return property;
}

void readMelting(TomlTable& file, Material& material) {
    TomlTable melting = file.table("melting");
    std::string solidusSource;
    std::string liquidusSource;
    std::string latentSource;
    material.solidus = readValue(melting, "solidus", {1, 6000}, solidusSource);
    material.liquidus = readValue(melting, "liquidus", {1, 6000}, liquidusSource);
    material.latentHeat = readValue(melting, "latent_heat", {0, 1e7}, latentSource);
    if (material.liquidus < material.solidus) melting.fail("liquidus", "must not be below the solidus");
    material.meltingSource =
        "solidus: " + solidusSource + "; liquidus: " + liquidusSource + "; latent heat: " + latentSource;
    melting.finish();
}

void readPhases(TomlTable& file, Material& material) {
    constexpr NumberRange kDensity{1, 30000};
    constexpr NumberRange kConductivity{1e-4, 2000};
    constexpr NumberRange kSpecificHeat{1, 20000};
    TomlTable solid = file.table("solid");
    material.solidDensity = readProperty(solid, "density", kDensity);
    material.solidConductivity = readProperty(solid, "conductivity", kConductivity);
    material.solidSpecificHeat = readProperty(solid, "specific_heat", kSpecificHeat);
    solid.finish();
    TomlTable liquid = file.table("liquid");
    material.liquidDensity = readProperty(liquid, "density", kDensity);
    material.liquidConductivity = readProperty(liquid, "conductivity", kConductivity);
    material.liquidSpecificHeat = readProperty(liquid, "specific_heat", kSpecificHeat);
    material.viscosity = readProperty(liquid, "viscosity", {1e-6, 1e4});
    // Optional: only convection needs it; negative for water below 4 °C.
    material.expansion =
        liquid.has("expansion") ? readProperty(liquid, "expansion", {-1e-2, 1e-2}) : Property::constant(0, "none");
    liquid.finish();
    TomlTable surface = file.table("surface");
    material.surfaceTension = readProperty(surface, "tension", {1e-4, 10});
    if (surface.has("sulphur_percent")) {
        material.sulphur = readValue(surface, "sulphur_percent", {0, kMostSulphur}, material.sulphurSource);
        if (!(material.tensionAt(material.solidus) > 0))
            surface.fail("sulphur_percent",
                         "leaves no surface tension at the solidus; expected a metal that melts where "
                         "steel does, with less sulphur or more tension");
    }
    material.emissivity = readProperty(surface, "emissivity", {0, 1});
    surface.finish();
}

void readBoiling(TomlTable& file, Material& material) {
    TomlTable boiling = file.table("boiling");
    std::string pointSource;
    std::string heatSource;
    std::string massSource;
    material.boilingPoint = readValue(boiling, "point", {1, 10000}, pointSource);
    material.vaporisationHeat = readValue(boiling, "heat", {1, 1e8}, heatSource);
    material.molarMass = readValue(boiling, "molar_mass", {1e-3, 1}, massSource);
    if (material.boilingPoint <= material.liquidus) boiling.fail("point", "must be above the liquidus");
    material.boilingSource = "point: " + pointSource + "; heat: " + heatSource + "; molar mass: " + massSource;
    if (boiling.has("evaporates_from")) {
        std::string fromSource;
        material.evaporatesFrom = readValue(boiling, "evaporates_from", {1, material.boilingPoint}, fromSource);
        material.boilingSource += "; evaporates from: " + fromSource;
    }
    boiling.finish();
}

void readWelding(TomlTable& file, Material& material) {
    TomlTable welding = file.table("welding");
    material.alternatingCurrent = welding.flag("alternating_current", false);
    material.weldingSource = welding.text("source");
    welding.finish();
}

glm::vec3 readColour(TomlTable& looks, std::string_view key) {
    const std::vector<double> values = looks.numbers(key, {0, 1}, 3);
    if (values.size() != 3) looks.fail(key, "expected three numbers from 0 to 1: red, green, blue, linear");
    return {static_cast<float>(values[0]), static_cast<float>(values[1]), static_cast<float>(values[2])};
}

MaterialLooks readLooks(TomlTable& file) {
    TomlTable table = file.table("looks");
    const auto share = [&](std::string_view key) { return static_cast<float>(table.number(key, {0, 1})); };
    MaterialLooks looks;
    looks.solidColour = readColour(table, "solid_colour");
    looks.liquidColour = readColour(table, "liquid_colour");
    looks.solidRoughness = share("solid_roughness");
    looks.liquidRoughness = share("liquid_roughness");
    looks.metalness = share("metalness");
    looks.heatTint = share("heat_tint");
    // One number may serve all three states.
    const auto emissivity = [&](std::string_view key) {
        return share(!table.has(key) && table.has("visible_emissivity") ? "visible_emissivity" : key);
    };
    looks.liquidEmissivity = emissivity("liquid_emissivity");
    looks.cleanEmissivity = emissivity("clean_emissivity");
    looks.scaledEmissivity = emissivity("scaled_emissivity");
    looks.rippleFrequency = static_cast<float>(table.number("ripple_hz", {0, 1000}, 0));
    looks.rippleHeight = static_cast<float>(table.number("ripple_um", {0, 1000}, 25) * 1e-6);
    looks.millScale = static_cast<float>(table.number("mill_scale", {0, 1}, 0));
    looks.translucency = static_cast<float>(table.number("translucency", {0, 1}, 0));
    looks.refractiveIndex = static_cast<float>(table.number("refractive_index", {1, 3}, 1));
    looks.source = table.text("source");
    table.finish();
    return looks;
}

/// The key's small letters and digits alone, so that "Aluminium 6061" and "aluminium_6061" match.
std::string plainKey(std::string_view key) {
    std::string plain;
    for (const char c : key)
        if (std::isalnum(static_cast<unsigned char>(c)))
            plain += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return plain;
}

} // namespace

Material readMaterial(const std::filesystem::path& file) {
    const toml::table parsed = parseTomlFile(file);
    TomlTable table(parsed, file);
    Material material;
    material.key = file.stem().string();
    material.name = table.text("name");
    readMelting(table, material);
    readPhases(table, material);
    if (table.has("boiling")) readBoiling(table, material);
    if (table.has("welding")) readWelding(table, material);
    material.looks = readLooks(table);
    table.finish();
    return material;
}

std::vector<std::filesystem::path> materialFiles(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    std::error_code fault;
    for (const auto& entry : std::filesystem::directory_iterator(folder, fault))
        if (entry.path().extension() == ".toml") files.push_back(entry.path());
    if (fault) throw InputError(folder, 0, "cannot be listed; expected a folder with material files");
    std::sort(files.begin(), files.end());
    return files;
}

std::filesystem::path materialFolder() {
    return resourceFolder() / "data" / "materials";
}

Material shippedMaterial(const std::string& key) {
    std::string known;
    for (const auto& path : materialFiles(materialFolder())) {
        const std::string stem = path.stem().string();
        if (plainKey(stem) == plainKey(key)) return readMaterial(path);
        known += (known.empty() ? "" : ", ") + stem;
    }
    throw InputError("unknown material " + quote(key) + "; expected one of " + known);
}

} // namespace meltpool
