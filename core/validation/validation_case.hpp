// A validation case as a person writes it: what to compute, with which material, and what an experiment gave.
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

/// What a key of the [case] table holds.
enum class CaseValue {
    number,   ///< one number
    list,     ///< one or more numbers
    rows,     ///< one or more rows of three numbers
    triple,   ///< exactly three numbers
    process,  ///< "gmaw" or "gtaw"; without it wire makes it GMAW
    lossRate, ///< true, false, or a coefficient in W/(m² K); true stands for kDefaultLossCoefficient
};

/// Convection coefficient that `loss = true` stands for, W/(m² K); radiation comes on top.
inline constexpr double kDefaultLossCoefficient = 15;

/// Solidus (K) where a case gives none: nothing melts.
inline constexpr double kNeverMelts = 20000;

/// One key of the [case] table of a kind. `fallback` without a value: the key must be there.
struct CaseKey {
    std::string_view key;
    CaseValue value;
    double minimum, maximum;
    std::optional<double> fallback;
    std::string_view note;
};

/// What a kind needs of [material] beside the density.
enum class CaseMatter {
    heat,    ///< conductivity and specific heat
    melting, ///< those, and what flows: tension and viscosity have values of a usual molten metal where none is given
    surface, ///< surface tension; no heat
    fluid,   ///< no heat
    viscous, ///< viscosity; no heat
};

/// One kind of case with what its [case] table needs and the names that its results carry.
struct CaseKind {
    std::string_view name;
    std::span<const CaseKey> keys;
    CaseMatter matter;
    bool needsTime;           ///< whether `time_s` must be given
    std::string_view results; ///< documented names of its numbers, after commas; X, XI_Y_Z and N stand for numbers
};

/// Every kind there is, in the order of the documentation.
std::span<const CaseKind> caseKinds();

/// What an experiment gave for one result: one value, or one a time.
struct Measured {
    std::vector<double> values;
    double tolerancePercent = 0;
};

struct ValidationCase {
    std::filesystem::path file;
    std::string name;
    const CaseKind* kind = nullptr;
    double spacing = 0;          ///< m
    double time = 0;             ///< s; 0 where the kind decides
    double tolerancePercent = 0; ///< of the closed form, and of measured values without their own
    Material material;
    std::map<std::string, double, std::less<>> numbers;            ///< [case], units as the key says
    std::map<std::string, std::vector<double>, std::less<>> lists; ///< [case]; rows one after the other
    std::string process;                                           ///< [case]; empty where the case does not say
    std::map<std::string, Measured, std::less<>> measured;         ///< [measured]

    double number(std::string_view key) const { return numbers.find(key)->second; }
    const std::vector<double>& list(std::string_view key) const { return lists.find(key)->second; }
};

/// Name of the temperature at a depth, and at a point relative to a source; mm.
std::string temperatureName(double depth);
std::string temperatureName(double xi, double y, double z);

/// Whether the keys of a weld ask for wire.
bool hasWire(const ValidationCase& from);

/// The names that this case's results can carry, which are those that [measured] may give.
std::vector<std::string> resultNames(const ValidationCase& from);

/// Reads and checks a case. Throws InputError naming file and line for anything unknown, missing or out of range.
ValidationCase readValidationCase(const std::filesystem::path& file);

/// The cases of a folder, by name. Throws InputError when the folder holds none.
std::vector<std::filesystem::path> validationCaseFiles(const std::filesystem::path& folder);

} // namespace meltpool
