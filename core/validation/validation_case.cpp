#include "core/validation/validation_case.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/base/toml_table.hpp"
#include "core/validation/chart_case.hpp"
#include "core/validation/exact_solutions.hpp"
#include "core/validation/weld_case_keys.hpp"
#include "core/weld/process/processes.hpp"
#include "core/weld/process/shielding_gas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace meltpool {

namespace {

// Defaults for molten metal whose case gives neither, N/m and Pa s: values of metals are between 0.4 and 1.9, and 0.001
// and 0.007.
constexpr double kUsualTension = 1;
constexpr double kUsualViscosity = 0.004;
using namespace weld_case; // keys of the kinds that weld

constexpr std::array kStep{
    CaseKey{"wall_temperature_k", number, 1, kHot, kNeeded, "held surface"},
    CaseKey{"initial_temperature_k", number, 1, kHot, kNeeded, "metal at the start"},
    CaseKey{"at_mm", list, 0, 1000, kNeeded, "depths to compare"},
};
constexpr std::array kFlux{
    CaseKey{"flux_w_m2", number, -1e9, 1e9, kNeeded, "into the surface"},
    CaseKey{"initial_temperature_k", number, 1, kHot, kNeeded, "metal at the start"},
    CaseKey{"at_mm", list, 0, 1000, kNeeded, "depths to compare"},
};
constexpr std::array kStefan{
    CaseKey{"wall_temperature_k", number, 1, kHot, kNeeded, "held surface"},
    CaseKey{"initial_temperature_k", number, 1, kHot, kNeeded, "metal at the start"},
};
constexpr std::array kRosenthal{
    CaseKey{"power_w", number, 0.001, 1e6, kNeeded, "absorbed power"},
    CaseKey{"speed_mm_s", number, 0.01, 1000, kNeeded, "of the source along x"},
    CaseKey{"initial_temperature_k", number, 1, kHot, kNeeded, "plate"},
    CaseKey{"thickness_mm", number, 0.01, 1000, 0.0, "of the thin plate; not used by the thick one"},
    CaseKey{"at_mm", rows, -1000, 1000, kNeeded, "[xi, y, z] relative to the source, xi ahead, z down"},
    CaseKey{"field_rms_percent", number, 0, 1000, 0.0, "greatest rms error of the field; 0: not checked"},
    CaseKey{"field_max_percent", number, 0, 1000, 0.0, "greatest error at any point; 0: not checked"},
};
constexpr std::array kHydrostatic{CaseKey{"height_mm", number, 0.1, 1000, kNeeded, "of the column"}};
constexpr std::array kDamBreak{CaseKey{"width_mm", number, 0.1, 1000, kNeeded, "of the column, twice as high"}};
constexpr std::array kDroplet{CaseKey{"radius_mm", number, 0.01, 100, kNeeded, "of the drop"}};
constexpr std::array kSessile{
    CaseKey{"volume_mm3", number, 0.001, 1e6, kNeeded, "of the drop"},
    CaseKey{"contact_angle_deg", number, 5, 180, kNeeded, "against the wall"},
};
constexpr std::array kPoiseuille{
    CaseKey{"gap_mm", number, 0.01, 1000, kNeeded, "between the plates"},
    CaseKey{"body_force_n_m3", number, -1e9, 1e9, kNeeded, "along the plates"},
};
constexpr std::array kCavity{
    CaseKey{"width_mm", number, 0.1, 1000, kNeeded, "between hot and cold wall"},
    CaseKey{"height_mm", number, 0.1, 1000, kNeeded, "of the cavity"},
    CaseKey{"hot_k", number, 1, kHot, kNeeded, "hot wall"},
    CaseKey{"cold_k", number, 1, kHot, kNeeded, "cold wall"},
    CaseKey{"initial_k", number, 1, kHot, kNeeded, "metal at the start"},
    CaseKey{"times_s", list, 0.001, 1e6, kNeeded, "times to compare at, rising"},
};
constexpr std::string_view kDepthResults = "temperature_at_Xmm_k";
constexpr std::string_view kFrontResults = "front_mm, melted_mm, frozen_mm";
constexpr std::string_view kRosenthalResults =
    "temperature_at_XI_Y_Zmm_k, field_rms_percent, field_max_percent, settled_after_s";

constexpr std::array kKinds{
    CaseKind{"conduction_step", kStep, CaseMatter::heat, true, kDepthResults},
    CaseKind{"conduction_flux", kFlux, CaseMatter::heat, true, kDepthResults},
    CaseKind{"stefan_one_phase", kStefan, CaseMatter::heat, true, kFrontResults},
    CaseKind{"stefan_two_phase", kStefan, CaseMatter::heat, true, kFrontResults},
    CaseKind{"rosenthal_thick", kRosenthal, CaseMatter::heat, true, kRosenthalResults},
    CaseKind{"rosenthal_thin", kRosenthal, CaseMatter::heat, true, kRosenthalResults},
    CaseKind{"energy", kEnergy, CaseMatter::melting, true,
             "energy_change_j, source_j, wire_j, lost_j, balance_percent, molten_peak_share, molten_end_share, "
             "particles_missing, particles_lost_or_not_finite"},
    CaseKind{"hydrostatic", kHydrostatic, CaseMatter::fluid, true,
             "bottom_pressure_pa, density_error_percent, rest_speed_mm_s"},
    CaseKind{"dam_break", kDamBreak, CaseMatter::fluid, true, "front_N, front_error_mean_percent"},
    CaseKind{"droplet_pressure", kDroplet, CaseMatter::surface, true,
             "pressure_jump_pa, density_ratio, rest_speed_mm_s"},
    CaseKind{"droplet_oscillation", kDroplet, CaseMatter::surface, true, "frequency_hz, decay_per_s"},
    CaseKind{"sessile_drop", kSessile, CaseMatter::surface, true, "height_mm, rest_speed_mm_s"},
    CaseKind{"poiseuille", kPoiseuille, CaseMatter::viscous, true, "velocity_mm_s, profile_rms_percent"},
    CaseKind{"cavity_melting", kCavity, CaseMatter::heat, false,
             "melted_fraction, fastest_mm_s, rms_speed_mm_s, balance_percent"},
    CaseKind{"bead_on_plate", kBead, CaseMatter::melting, false,
             "current_a, voltage_v, arc_length_mm, toe_width_mm, fused_width_mm, height_mm, penetration_mm, "
             "edge_angle_deg, overlap_mm, section_mm2, deposited_mm2, fused_plate_mm2, heat_affected_width_mm, "
             "heat_affected_depth_mm, refused_filler"},
    CaseKind{"fillet", kFillet, CaseMatter::melting, false,
             "current_a, voltage_v, arc_length_mm, leg_mm, leg_lying_mm, leg_standing_mm, throat_mm, "
             "edge_angle_lying_deg, edge_angle_standing_deg, root_fusion_mm, penetration_mm, deposited_mm2, "
             "fused_width_mm, fused_plate_mm2, refused_filler"},
    CaseKind{"chart_tee", kChart, CaseMatter::melting, false, kChartResults},
    CaseKind{"chart_lap", kChart, CaseMatter::melting, false, kChartResults},
    CaseKind{"chart_butt", kChart, CaseMatter::melting, false, kChartResults},
    CaseKind{"arc_spot", kSpot, CaseMatter::melting, false,
             "current_a, voltage_v, arc_length_mm, diameter_mm, fused_diameter_mm, height_mm, penetration_mm, "
             "refused_filler"},
    CaseKind{"cooling", kCooling, CaseMatter::melting, false,
             "current_a, voltage_v, arc_length_mm, cooling_rate_k_s, t85_s, hottest_k, refused_filler"},
};

const CaseKind& findKind(TomlTable& file) {
    const std::string name = file.text("kind");
    std::string known;
    for (const CaseKind& kind : kKinds) {
        if (kind.name == name) return kind;
        known += (known.empty() ? "" : ", ") + std::string(kind.name);
    }
    file.fail("kind", "unknown kind " + quote(name) + "; expected one of " + known);
}

/// Reads solid and liquid: each from its own key, the key for both, the other phase's, or the shipped material.
void readPhases(TomlTable& table, const std::string& key, NumberRange range, Property& solid, Property& liquid,
                std::optional<double> fallback) {
    const auto given = [&](const std::string& name) {
        return table.has(name) ? std::optional(table.number(name, range)) : std::nullopt;
    };
    const auto both = given(key), ofSolid = given(key + "_solid"), ofLiquid = given(key + "_liquid");
    const auto choose = [&](Property& property, std::optional<double> own, std::optional<double> other) {
        std::optional<double> value = own ? own : both;
        if (!value && property.points.empty()) value = other ? other : fallback;
        if (value) property = Property::constant(*value);
    };
    choose(solid, ofSolid, ofLiquid);
    choose(liquid, ofLiquid, ofSolid);
    if (solid.points.empty()) table.number(key, range); // reports the missing key
}

void readMelting(TomlTable& table, Material& m) {
    m.latentHeat = table.number("latent_heat", {0, 1e7}, m.latentHeat);
    const bool sharp = !table.has("use"); // metal with only one of the two melts there
    const double other = sharp && table.has("liquidus_k") ? table.number("liquidus_k", {1, kNeverMelts}) : m.solidus;
    m.solidus = table.number("solidus_k", {1, kNeverMelts}, other);
    m.liquidus = table.number("liquidus_k", {1, kNeverMelts}, sharp ? m.solidus : m.liquidus);
    if (m.liquidus < m.solidus) table.fail("liquidus_k", "is below the solidus; expected the solidus or more");
}

Material readCaseMaterial(TomlTable& file, CaseMatter matter) {
    TomlTable table = file.table("material");
    Material m;
    m.key = m.name = "given by the case";
    m.solidus = m.liquidus = kNeverMelts;
    if (table.has("use")) {
        try {
            m = shippedMaterial(table.text("use"));
        } catch (const InputError& unknown) {
            table.fail("use", unknown.what());
        }
    }
    const bool heat = matter == CaseMatter::heat || matter == CaseMatter::melting;
    const auto unless = [](bool needed, double value) { return needed ? std::nullopt : std::optional(value); };
    readPhases(table, "density", {1, 30000}, m.solidDensity, m.liquidDensity, std::nullopt);
    readPhases(table, "conductivity", {1e-4, 2000}, m.solidConductivity, m.liquidConductivity, unless(heat, 1));
    readPhases(table, "specific_heat", {1, 20000}, m.solidSpecificHeat, m.liquidSpecificHeat, unless(heat, 1000));
    readMelting(table, m);
    const auto constant = [&](std::string_view key, NumberRange range, Property& property, bool needed, double usual) {
        if (needed && property.points.empty()) table.number(key, range); // reports the missing key
        if (table.has(key) || property.points.empty()) property = Property::constant(table.number(key, range, usual));
    };
    constexpr double kLeast = 1e-9; // least value of keys for which 0 would mean no effect
    const bool metal = matter == CaseMatter::melting;
    const bool surface = matter == CaseMatter::surface, viscous = matter == CaseMatter::viscous;
    constant("surface_tension", {surface ? kLeast : 0, 10}, m.surfaceTension, surface, metal ? kUsualTension : 0);
    m.sulphur = table.number("sulphur_percent", {0, kMostSulphur}, table.has("surface_tension") ? 0 : m.sulphur);
    if (m.sulphur > 0 && !(m.tensionAt(m.solidus) > 0))
        table.fail(table.has("sulphur_percent") ? "sulphur_percent" : "surface_tension",
                   "leaves no surface tension at the solidus with " + formatNumber(m.sulphur) +
                       " % of sulphur; expected some");
    constant("viscosity", {viscous ? kLeast : 0, 1e4}, m.viscosity, viscous, metal ? kUsualViscosity : 0);
    constant("expansion", {-1e-2, 1e-2}, m.expansion, false, 0);
    constant("emissivity", {0, 1}, m.emissivity, false, 0);
    table.finish();
    return m;
}

void readProcess(TomlTable& table, const std::string& name, const ChartDefaults& chart, ValidationCase& result) {
    const auto ofRow = chart.words.find(name);
    if (ofRow != chart.words.end()) result.process = ofRow->second;
    if (table.has(name)) result.process = table.text(name);
    const bool chartWeld = result.kind->name.starts_with("chart_");
    if (result.process.empty() || result.process == Gmaw::kName || result.process == Gtaw::kName) return;
    if (chartWeld && result.process == Smaw::kName) return;
    table.fail(name, "unknown process " + quote(result.process) +
                         (chartWeld ? "; expected gmaw, gtaw or smaw" : "; expected gmaw or gtaw"));
}

/// Reads one key of [case]; one that is not there has the value of the chart's row, or its own fallback.
void readCaseKey(TomlTable& table, const CaseKey& key, const ChartDefaults& chart, ValidationCase& result) {
    const std::string name(key.key);
    const NumberRange range{key.minimum, key.maximum};
    switch (key.value) {
    case number: {
        const auto ofRow = chart.numbers.find(name);
        const auto fallback = ofRow == chart.numbers.end() ? key.fallback : std::optional(ofRow->second);
        result.numbers[name] = fallback ? table.number(name, range, *fallback) : table.number(name, range);
        break;
    }
    case word: {
        const auto ofRow = chart.words.find(name);
        result.words[name] = table.text(name, ofRow == chart.words.end() ? std::string_view() : ofRow->second);
        break;
    }
    case list:
        result.lists[name] = table.numbers(name, range);
        break;
    case triple:
        result.lists[name] = table.numbers(name, range, 3);
        if (result.lists[name].size() != 3) table.fail(name, "expected exactly three numbers");
        break;
    case rows:
        for (const auto& row : table.rows(name, 3))
            for (const double value : row) {
                if (value < key.minimum || value > key.maximum) table.fail(name, "expected numbers from -1000 to 1000");
                result.lists[name].push_back(value);
            }
        break;
    case process:
        readProcess(table, name, chart, result);
        break;
    case lossRate:
        result.numbers[name] = table.isFlag(name) ? (table.flag(name, false) ? kDefaultLossCoefficient : 0)
                                                  : table.number(name, range, *key.fallback);
        break;
    }
}

/// Returns the present name of a result; [measured] may have a former one.
std::string presentName(TomlTable& measured, const ValidationCase& result, const std::string& key) {
    constexpr std::string_view kFormer = "width_mm", kPresent = "fused_width_mm";
    if (key != kFormer || result.kind->name != "bead_on_plate") return key;
    if (measured.has(kPresent)) measured.fail(key, "is the old name of fused_width_mm; expected only one of them");
    return std::string(kPresent);
}

void readMeasured(TomlTable& file, ValidationCase& result) {
    constexpr std::string_view kSuffix = "_tolerance_percent";
    TomlTable table = file.table("measured");
    const auto names = resultNames(result);
    std::string known;
    for (const std::string& name : names)
        known += (known.empty() ? "" : ", ") + name;
    for (const std::string& key : table.keys()) {
        if (key.ends_with(kSuffix)) continue;
        const std::string name = presentName(table, result, key);
        if (std::find(names.begin(), names.end(), name) == names.end())
            table.fail(key, "this case has no such result; expected one of " + known);
        Measured& measured = result.measured[name];
        measured.values = table.isList(key) ? table.numbers(key) : std::vector{table.number(key)};
        measured.tolerancePercent = table.number(key + std::string(kSuffix), {0, 1000}, result.tolerancePercent);
        const size_t expected = key == "melted_fraction" ? result.list("times_s").size() : 1;
        if (measured.values.size() != expected)
            table.fail(key, "expected " + std::to_string(expected) +
                                (expected == 1 ? " value" : " values, one for each of times_s"));
    }
    table.finish();
}

/// Checks that metal melts from a hot wall, or freezes from a cold one; of one phase all of it waits at its melting
/// point.
void checkStefan(TomlTable& table, const ValidationCase& result) {
    const Material& m = result.material;
    if (m.latentHeat <= 0) table.fail("", "a Stefan case needs latent_heat above 0 in [material]");
    if (m.solidus >= kNeverMelts) table.fail("", "a Stefan case needs solidus_k in [material]");
    const double wall = result.number("wall_temperature_k");
    const double initial = result.number("initial_temperature_k");
    if (wall >= m.solidus && wall <= m.liquidus)
        table.fail("wall_temperature_k",
                   "expected a wall above the liquidus (melting) or below the solidus (freezing)");
    const double melting = 0.5 * (m.solidus + m.liquidus);
    const bool melts = wall > melting;
    if (result.kind->name == "stefan_one_phase") {
        constexpr double kSlack = 1; // K, of a rounded melting point
        if (initial < m.solidus - kSlack || initial > m.liquidus + kSlack)
            table.fail("initial_temperature_k", "a single phase starts at its melting point; expected " +
                                                    formatNumber(melting) + ", or kind = \"stefan_two_phase\"");
    } else if (melts ? initial > m.solidus : initial < m.liquidus) {
        table.fail("initial_temperature_k", melts ? "expected metal at or below the solidus before a hot wall"
                                                  : "expected metal at or above the liquidus before a cold wall");
    }
}

/// Checks that points are in the plate and not on the source, where the exact temperature has no bound.
void checkRosenthal(TomlTable& table, const ValidationCase& result) {
    const bool thin = result.kind->name == "rosenthal_thin";
    const double thickness = result.number("thickness_mm");
    if (thin && !(thickness > 0)) table.fail("thickness_mm", "is missing; expected the thickness of the plate in mm");
    const auto& at = result.list("at_mm");
    for (size_t i = 0; i + 2 < at.size(); i += 3) {
        if (std::hypot(at[i], at[i + 1], thin ? 0 : at[i + 2]) < 1e-3)
            table.fail("at_mm", "expected points away from the source at [0, 0, 0]");
        if (at[i + 2] < 0 || (thin && at[i + 2] > thickness))
            table.fail("at_mm",
                       thin ? "expected z from 0 (surface) to the thickness" : "expected z from 0 (surface) down");
    }
}

/// Refuses an unknown gas or kind of short circuits, and keys that a process has no use for.
void checkProcess(TomlTable& table, const ValidationCase& result) {
    const std::string& gas = result.word("gas");
    const bool wireless = !result.process.empty() && result.process != Gmaw::kName;
    if (!gas.empty() && (wireless || findShieldingGas(gas) == nullptr))
        table.fail("gas", "is " + quote(gas) + "; expected ar_co2, co2, ar_o2, ar or none, and a gmaw arc");
    const std::string& shorts = result.word("short_circuits");
    if (!shorts.empty() && (wireless || !findShortCircuits(shorts)))
        table.fail("short_circuits", "is " + quote(shorts) + "; expected ordinary or controlled, and a gmaw arc");
    if (wireless)
        for (const char* key : {"wire_diameter_mm", "wire_feed_m_min", "voltage"})
            if (result.number(key) > 0)
                table.fail(key, "a " + result.process + " arc has no wire; expected gmaw, or the key left out");
    if (result.process != Gmaw::kName) return;
    if (result.number("wire_diameter_mm") <= 0)
        table.fail("wire_diameter_mm", "is missing; expected the diameter of the wire in mm");
    if (result.number("wire_feed_m_min") <= 0 && result.number("current_a") <= 0)
        table.fail("wire_feed_m_min", "is missing; expected the wire feed in m/min, or current_a in A");
}

/// Checks that an arc has its current, or wire and a voltage, or at least its power.
void checkArc(TomlTable& table, const ValidationCase& result) {
    checkProcess(table, result);
    if (result.number("power_w") <= 0 && result.number("current_a") <= 0 && !hasWire(result))
        table.fail("power_w", "is missing; expected power_w, or current_a, or voltage, wire_diameter_mm and "
                              "wire_feed_m_min");
    if (hasWire(result) && result.number("power_w") <= 0 && result.number("voltage") <= 0)
        table.fail("voltage", "is missing; expected the welding machine's voltage in V");
}

/// Checks that a fillet and a cooling rate have wire, and that temperatures fall.
void checkWeld(TomlTable& table, const ValidationCase& result) {
    const std::string_view kind = result.kind->name;
    checkArc(table, result);
    if (kind.starts_with("chart_")) checkChart(table, result);
    if (kind == "fillet" && !hasWire(result))
        table.fail("wire_diameter_mm", "is missing; expected a wire, because a fillet needs filler");
    if (kind != "cooling") return;
    if (result.number("cold_k") >= result.number("hot_k")) table.fail("cold_k", "expected less than hot_k");
    if (result.number("until_k") > result.number("cold_k")) table.fail("until_k", "expected at most cold_k, or 0");
    const double until = result.number("until_k") > 0 ? result.number("until_k") : result.number("cold_k");
    if (result.number("ambient_k") >= until) table.fail("ambient_k", "expected less than the last temperature");
}

/// Checks keys against each other.
void checkTogether(TomlTable& table, const ValidationCase& result) {
    const std::string_view kind = result.kind->name;
    if (kind.starts_with("rosenthal")) checkRosenthal(table, result);
    if (kind.starts_with("stefan")) checkStefan(table, result);
    if (kind == "energy" && result.number("on_s") > 0) checkArc(table, result);
    if (kind == "bead_on_plate" || kind == "fillet" || kind == "arc_spot" || kind == "cooling" ||
        kind.starts_with("chart_"))
        checkWeld(table, result);
    if (kind == "poiseuille" && result.number("body_force_n_m3") == 0)
        table.fail("body_force_n_m3", "is 0, so nothing flows; expected another force");
    if (kind == "cavity_melting") {
        const auto& times = result.list("times_s");
        if (!std::is_sorted(times.begin(), times.end())) table.fail("times_s", "expected rising times");
        if (result.number("hot_k") <= result.number("cold_k"))
            table.fail("hot_k", "expected a hot wall above the cold one");
    }
}

} // namespace

std::span<const CaseKind> caseKinds() {
    return kKinds;
}

std::string temperatureName(double depth) {
    return "temperature_at_" + formatNumber(depth) + "mm_k";
}

std::string temperatureName(double xi, double y, double z) {
    return "temperature_at_" + formatNumber(xi) + "_" + formatNumber(y) + "_" + formatNumber(z) + "mm_k";
}

bool hasWire(const ValidationCase& from) {
    if (!from.process.empty()) return from.process == Gmaw::kName;
    const bool fed = from.number("wire_feed_m_min") > 0 || (from.number("current_a") > 0 && from.number("voltage") > 0);
    return from.number("wire_diameter_mm") > 0 && fed;
}

std::vector<std::string> resultNames(const ValidationCase& from) {
    std::vector<std::string> names;
    const auto wireless = [&](std::string_view name) {
        constexpr std::array<std::string_view, 8> kWire{"toe_width_mm",   "diameter_mm",   "height_mm",
                                                        "edge_angle_deg", "overlap_mm",    "section_mm2",
                                                        "deposited_mm2",  "refused_filler"};
        const bool weld = from.kind->name == "bead_on_plate" || from.kind->name == "arc_spot";
        return weld && !hasWire(from) && std::find(kWire.begin(), kWire.end(), name) != kWire.end();
    };
    for (const std::string_view piece : splitText(from.kind->results, ',')) {
        const std::string_view name = trimText(piece);
        if (name == "temperature_at_Xmm_k") {
            for (const double depth : from.list("at_mm"))
                names.push_back(temperatureName(depth));
        } else if (name == "temperature_at_XI_Y_Zmm_k") {
            const auto& at = from.list("at_mm");
            for (size_t i = 0; i + 2 < at.size(); i += 3)
                names.push_back(temperatureName(at[i], at[i + 1], at[i + 2]));
        } else if (name == "front_N") {
            for (size_t i = 1; i <= exact::damBreakFront().size(); ++i)
                names.push_back("front_" + std::to_string(i));
        } else if (!wireless(name)) {
            names.emplace_back(name);
        }
    }
    return names;
}

ValidationCase readValidationCase(const std::filesystem::path& file) {
    const toml::table parsed = parseTomlFile(file);
    TomlTable table(parsed, file);
    ValidationCase result;
    result.file = file;
    result.name = table.text("name");
    result.kind = &findKind(table);
    result.spacing = table.number("spacing_mm", {0.001, 100}) * 1e-3;
    const NumberRange time{1e-6, 1e6};
    result.time = result.kind->needsTime ? table.number("time_s", time) : table.number("time_s", time, 0);
    result.tolerancePercent = table.number("tolerance_percent", {0, 1000}, 5);
    result.material = readCaseMaterial(table, result.kind->matter);
    TomlTable keys = table.table("case");
    const ChartDefaults chart = chartDefaults(keys, *result.kind);
    for (const CaseKey& key : result.kind->keys)
        readCaseKey(keys, key, chart, result);
    keys.finish();
    checkTogether(keys, result);
    if (table.has("measured")) readMeasured(table, result);
    table.finish();
    return result;
}

std::vector<std::filesystem::path> validationCaseFiles(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    for (const std::string& name : tomlFileNames(folder, "a folder of validation cases"))
        files.push_back(folder / (name + ".toml"));
    if (files.empty()) throw InputError(folder, 0, "holds no validation case; expected files that end in .toml");
    return files;
}

} // namespace meltpool
