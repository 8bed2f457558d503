// Reads acceptance limits for welds: one TOML file for a standard, an edition and a level.
#pragma once

#include "core/weld/gauge/weld_stations.hpp"

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace meltpool {

/// Sizes that limits depend on, mm. An unknown size is NaN.
struct LimitSizes {
    double b = 0;   ///< measured width of the reinforcement, the fillet's face or the root
    double a = 0;   ///< nominal throat
    double t = 0;   ///< plate thickness
    double leg = 0; ///< nominal leg
};

/// constant + perB b + perA a + perT t, at most `most`; in the imperfection's unit (mm or degrees).
struct LimitFormula {
    double constant = 0;
    double perB = 0, perA = 0, perT = 0;
    double most = std::numeric_limits<double>::infinity();

    /// NaN if it needs an unknown size.
    double at(const LimitSizes& sizes) const;
};

/// The total length that an imperfection beyond the limit may have, and its size there.
struct ShortAllowance {
    LimitFormula formula;
    double length = std::numeric_limits<double>::infinity(); ///< mm, total in any `per` mm of weld
    double per = std::numeric_limits<double>::infinity();    ///< mm
    double share = 1;                                        ///< share of the whole weld, if that is shorter than `per`

    /// Millimetres allowed beyond the limit in any window of `per`, or in the whole of a shorter weld (mm).
    double allowed(double weldLength) const;
};

/// An interval of a size, mm.
struct SizeBounds {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool lowIncluded = true, highIncluded = true;

    bool contains(double value) const;
    bool bounded() const; ///< true with at least one end
};

enum class LimitKind { notPermitted, atMost, atLeast };

/// One limit.
struct AcceptanceItem {
    std::string imperfection; ///< a key of imperfections()
    std::vector<WeldKind> appliesTo;
    LimitKind kind = LimitKind::atMost;
    LimitFormula formula;                    ///< 0 means not permitted
    std::optional<ShortAllowance> shortOnes; ///< allowance for short lengths
    SizeBounds t, b, leg;                    ///< sizes to which the item applies

    bool appliesToKind(WeldKind weld) const;
    /// True if the item applies to a weld of these sizes; an item that needs an unknown size applies.
    bool holdsFor(const LimitSizes& sizes) const;
};

struct Acceptance {
    std::string standard; ///< "ISO 5817"
    std::string edition;
    std::string level; ///< "C"
    std::filesystem::path file;
    std::vector<AcceptanceItem> items;
};

/// Reads and checks an acceptance file; see the handbook's page on the measured weld. Throws InputError naming file,
/// line and key for an unknown or missing key and for a value out of range.
Acceptance readAcceptance(const std::filesystem::path& file);

/// The shipped acceptance of this name ("iso5817-c"), or the file itself if the name ends in .toml. Throws InputError
/// that lists the shipped names for any other name.
Acceptance findAcceptance(const std::string& name);

/// Names of the shipped files, in order. Throws InputError if their folder cannot be read.
std::vector<std::string> acceptanceNames();

} // namespace meltpool
