// A validation case as a person writes it: geometry and process, material, and results of an experiment.
#pragma once

#include "core/metal/material/materials.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

/// Type of a key of the [case] table.
enum class CaseValue {
    number,   ///< one number
    list,     ///< one or more numbers
    rows,     ///< one or more rows of three numbers
    triple,   ///< exactly three numbers
    process,  ///< "gmaw" or "gtaw"; without it wire makes it GMAW
    word,     ///< a text; empty without it
    lossRate, ///< true, false, or a coefficient in W/(m² K); true means kDefaultLossCoefficient
};

/// Convection coefficient for `loss = true`, W/(m² K); radiation comes on top.
inline constexpr double kDefaultLossCoefficient = 15;

/// Highest temperature that a case may name, K.
inline constexpr double kHottest = 20000;
/// Default solidus (K): nothing melts.
inline constexpr double kNeverMelts = 20000;

/// One key of the [case] table of a kind. `fallback` without a value: the key must be there.
struct CaseKey {
    std::string_view key;
    CaseValue value;
    double minimum, maximum;
    std::optional<double> fallback;
    std::string_view note;
};

/// Values of [material] that a kind needs in addition to the density.
enum class CaseMatter {
    heat,    ///< conductivity and specific heat
    melting, ///< values of heat, and tension and viscosity of the flow, which default to those of a usual molten metal
    surface, ///< surface tension; no heat
    fluid,   ///< no heat
    viscous, ///< viscosity; no heat
};

/// One kind of case with the keys of its [case] table and the names of its results.
struct CaseKind {
    std::string_view name;
    std::span<const CaseKey> keys;
    CaseMatter matter;
    bool needsTime; ///< true if `time_s` is required
    /// Documented names of its numbers, after commas; X, XI_Y_Z and N are placeholders for numbers.
    std::string_view results;
};

/// Returns every kind there is, in the order of the documentation.
std::span<const CaseKind> caseKinds();

/// Measured values of an experiment for one result: one value, or one a time.
struct Measured {
    std::vector<double> values;
    double tolerancePercent = 0;
};

struct ValidationCase {
    std::filesystem::path file;
    std::string name;
    const CaseKind* kind = nullptr;
    double spacing = 0;          ///< m
    double time = 0;             ///< s; 0 if the kind decides
    double tolerancePercent = 0; ///< tolerance of the closed form, and of measured values without their own
    Material material;
    std::map<std::string, double, std::less<>> numbers;            ///< numbers of [case], units as in the key
    std::map<std::string, std::vector<double>, std::less<>> lists; ///< lists of [case]; rows one after the other
    std::map<std::string, std::string, std::less<>> words;         ///< texts of [case]; empty ones are not given
    std::string process;                                           ///< process of [case]; empty if the case has none
    std::map<std::string, Measured, std::less<>> measured;         ///< values of [measured]

    double number(std::string_view key) const { return numbers.find(key)->second; }
    const std::string& word(std::string_view key) const { return words.find(key)->second; }
    const std::vector<double>& list(std::string_view key) const { return lists.find(key)->second; }
};

/// Returns the name of the temperature at a depth, and at a point relative to a source; mm.
std::string temperatureName(double depth);
std::string temperatureName(double xi, double y, double z);

/// Returns true if the keys of a weld ask for wire.
bool hasWire(const ValidationCase& from);

/// Returns the names that this case's results can have, which are those that [measured] may give.
std::vector<std::string> resultNames(const ValidationCase& from);

/// Reads and checks a case. Throws InputError naming file and line for anything unknown, missing or out of range.
ValidationCase readValidationCase(const std::filesystem::path& file);

/// Returns the cases of a folder, by name. Throws InputError when the folder holds none.
std::vector<std::filesystem::path> validationCaseFiles(const std::filesystem::path& folder);

} // namespace meltpool
