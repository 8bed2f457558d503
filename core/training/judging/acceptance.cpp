#include "core/training/judging/acceptance.hpp"

#include "core/base/error.hpp"
#include "core/base/resources.hpp"
#include "core/base/text.hpp"
#include "core/base/toml_table.hpp"
#include "core/weld/gauge/weld_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace meltpool {

namespace {

constexpr NumberRange kLimits{-1000, 1000};    ///< mm or degrees
constexpr NumberRange kSlopes{-100, 100};      ///< mm per mm
constexpr NumberRange kSizes{0, 10'000};       ///< mm
constexpr NumberRange kLengths{1e-3, 100'000}; ///< mm
constexpr NumberRange kShares{0, 1};
constexpr std::array kKinds{WeldKind::fillet, WeldKind::butt, WeldKind::bead};

/// Reads a key whose value is one of some words.
template <class Choice, size_t count>
Choice choiceOf(TomlTable& table, std::string_view key,
                const std::array<std::pair<std::string_view, Choice>, count>& of) {
    const std::string word = table.text(key);
    std::string known;
    for (const auto& [name, choice] : of) {
        if (name == word) return choice;
        known += (known.empty() ? "" : ", ") + std::string(name);
    }
    table.fail(key, "is " + quote(word) + "; expected one of " + known);
}

std::string readName(TomlTable& table) {
    const std::string name = table.text("imperfection");
    if (const WeldFigure* known = findImperfection(name)) return std::string(known->key);
    std::string known;
    for (const WeldFigure& each : imperfections())
        known += (known.empty() ? "" : ", ") + std::string(each.key);
    table.fail("imperfection", "is " + quote(name) + "; expected one of " + known);
}

std::vector<WeldKind> readKinds(TomlTable& table) {
    const std::string text = table.text("applies_to");
    std::vector<WeldKind> kinds;
    for (const std::string_view word : splitText(text, ',')) {
        const auto* kind =
            std::find_if(kKinds.begin(), kKinds.end(), [&](WeldKind each) { return nameOf(each) == trimText(word); });
        if (kind == kKinds.end())
            table.fail("applies_to", "names " + quote(trimText(word)) + "; expected some of fillet, butt, bead");
        kinds.push_back(*kind);
    }
    return kinds;
}

/// A limit needs one of these keys; a key that ends in '_' is followed by the unit.
constexpr std::array<std::string_view, 4> kFormulaKeys{"const_", "per_b", "per_a", "per_t"};

/// `unit` ends the names of lengths and angles.
LimitFormula readFormula(TomlTable& table, const std::string& unit) {
    LimitFormula formula;
    const std::string most = "max_" + unit;
    formula.constant = table.number("const_" + unit, kLimits, 0);
    formula.perB = table.number("per_b", kSlopes, 0);
    formula.perA = table.number("per_a", kSlopes, 0);
    formula.perT = table.number("per_t", kSlopes, 0);
    if (table.has(most)) formula.most = table.number(most, kLimits);
    table.allow(most);
    return formula;
}

/// True if the table has a formula.
bool hasFormula(const TomlTable& table, const std::string& unit) {
    return std::any_of(kFormulaKeys.begin(), kFormulaKeys.end(), [&](std::string_view key) {
        return table.has(key.ends_with('_') ? std::string(key) + unit : std::string(key));
    });
}

SizeBounds readBounds(TomlTable& table, const std::string& size) {
    SizeBounds bounds;
    const std::string above = size + "_above_mm", from = size + "_from_mm", upTo = size + "_up_to_mm",
                      below = size + "_below_mm";
    for (const std::string* key : {&above, &from, &upTo, &below})
        table.allow(*key);
    if (table.has(above) && table.has(from)) table.fail(from, "conflicts with " + above + "; expected one of them");
    if (table.has(upTo) && table.has(below)) table.fail(below, "conflicts with " + upTo + "; expected one of them");
    bounds.lowIncluded = !table.has(above);
    bounds.highIncluded = !table.has(below);
    for (const std::string* key : {&above, &from})
        if (table.has(*key)) bounds.low = table.number(*key, kSizes);
    for (const std::string* key : {&upTo, &below})
        if (table.has(*key)) bounds.high = table.number(*key, {std::max(bounds.low, kSizes.minimum), kSizes.maximum});
    return bounds;
}

ShortAllowance readShort(TomlTable table, const std::string& unit) {
    ShortAllowance allowance;
    if (!hasFormula(table, unit))
        table.fail("const_" + unit,
                   "is missing; expected const_" + unit + ", per_b, per_a or per_t: the limit of short imperfections");
    allowance.formula = readFormula(table, unit);
    for (const std::string_view key : {"length_mm", "per_mm", "share"})
        table.allow(key);
    if (table.has("length_mm") != table.has("per_mm"))
        table.fail(table.has("per_mm") ? "length_mm" : "per_mm", "is missing; expected length_mm and per_mm together");
    if (!table.has("length_mm") && !table.has("share"))
        table.fail("share", "is missing; expected a share of the weld, or length_mm and per_mm");
    if (table.has("length_mm")) {
        allowance.length = table.number("length_mm", kLengths);
        allowance.per = table.number("per_mm", {allowance.length, kLengths.maximum});
    }
    if (table.has("share")) allowance.share = table.number("share", kShares);
    table.finish();
    return allowance;
}

AcceptanceItem readItem(TomlTable& table) {
    AcceptanceItem item;
    item.imperfection = readName(table);
    const std::string unit(findImperfection(item.imperfection)->unit);
    item.appliesTo = readKinds(table);
    item.kind = choiceOf(table, "limit",
                         std::array<std::pair<std::string_view, LimitKind>, 3>{{
                             {"not_permitted", LimitKind::notPermitted},
                             {"at_most", LimitKind::atMost},
                             {"at_least", LimitKind::atLeast},
                         }});
    if (item.kind == LimitKind::notPermitted) {
        if (hasFormula(table, unit)) table.fail("limit", "is not_permitted; expected no numbers with it");
    } else {
        if (!hasFormula(table, unit))
            table.fail("const_" + unit, "is missing; expected const_" + unit + ", per_b, per_a or per_t: the limit");
        item.formula = readFormula(table, unit);
    }
    item.t = readBounds(table, "t");
    item.b = readBounds(table, "b");
    item.leg = readBounds(table, "leg");
    table.allow("short");
    if (table.has("short")) {
        if (item.kind == LimitKind::atLeast) table.fail("short", "does not fit at_least; expected none");
        item.shortOnes = readShort(table.table("short"), unit);
    }
    table.finish();
    return item;
}

std::filesystem::path acceptanceFolder() {
    return resourceFolder() / "data" / "acceptance";
}

} // namespace

double LimitFormula::at(const LimitSizes& sizes) const {
    double limit = constant;
    // A size that the limit does not depend on may be unknown.
    for (const auto& [slope, size] : {std::pair(perB, sizes.b), std::pair(perA, sizes.a), std::pair(perT, sizes.t)})
        if (slope != 0) limit += slope * size;
    return limit > most ? most : limit;
}

double ShortAllowance::allowed(double weldLength) const {
    if (weldLength >= per) return length;
    return std::isfinite(length) ? std::min(length, share * weldLength) : share * weldLength;
}

bool SizeBounds::contains(double value) const {
    return (lowIncluded ? value >= low : value > low) && (highIncluded ? value <= high : value < high);
}

bool SizeBounds::bounded() const {
    return std::isfinite(low) || std::isfinite(high);
}

bool AcceptanceItem::appliesToKind(WeldKind weld) const {
    return std::find(appliesTo.begin(), appliesTo.end(), weld) != appliesTo.end();
}

bool AcceptanceItem::holdsFor(const LimitSizes& sizes) const {
    const auto holds = [](const SizeBounds& bounds, double size) { return std::isnan(size) || bounds.contains(size); };
    return holds(t, sizes.t) && holds(b, sizes.b) && holds(leg, sizes.leg);
}

Acceptance readAcceptance(const std::filesystem::path& file) {
    const toml::table parsed = parseTomlFile(file);
    TomlTable root(parsed, file);
    Acceptance acceptance;
    acceptance.file = file;
    acceptance.standard = root.text("standard");
    acceptance.edition = root.text("edition");
    acceptance.level = root.text("level");
    root.text("source", "none");
    for (TomlTable& table : root.tables("item"))
        acceptance.items.push_back(readItem(table));
    root.finish();
    if (acceptance.items.empty()) root.fail("item", "is missing; expected at least one [[item]]");
    return acceptance;
}

std::vector<std::string> acceptanceNames() {
    return tomlFileNames(acceptanceFolder(), "a folder with acceptance files");
}

Acceptance findAcceptance(const std::string& name) {
    if (std::filesystem::path(name).extension() == ".toml") return readAcceptance(name);
    std::string known;
    for (const std::string& each : acceptanceNames()) {
        if (each == name) return readAcceptance(acceptanceFolder() / (name + ".toml"));
        known += (known.empty() ? "" : ", ") + each;
    }
    throw InputError("unknown acceptance " + quote(name) + "; expected one of " + known +
                     ", or a file that ends in .toml");
}

} // namespace meltpool
