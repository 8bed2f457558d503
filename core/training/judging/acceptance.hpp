// Acceptance limits for welds as a school keeps them: one TOML file for a standard, an edition and a level.
#pragma once

#include "core/weld/gauge/weld_stations.hpp"

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace meltpool {

/// The sizes that limits depend on, mm. An unknown one is NaN.
struct LimitSizes {
    double b = 0;   ///< width of the reinforcement, the fillet's face or the root, as measured
    double a = 0;   ///< nominal throat
    double t = 0;   ///< plate thickness
    double leg = 0; ///< nominal leg
};

/// constant + perB b + perA a + perT t, at most `most`; in the imperfection's unit (mm or degrees).
struct LimitFormula {
    double constant = 0;
    double perB = 0, perA = 0, perT = 0;
    double most = std::numeric_limits<double>::infinity();

    /// NaN where it needs a size that is not known.
    double at(const LimitSizes& sizes) const;
};

/// How long an imperfection beyond the limit may be in sum, and how large it may be there.
struct ShortAllowance {
    LimitFormula formula;
    double length = std::numeric_limits<double>::infinity(); ///< mm, together in any `per` mm of weld
    double per = std::numeric_limits<double>::infinity();    ///< mm
    double share = 1;                                        ///< of the whole weld, where that is shorter than `per`

    /// mm that may be beyond the limit in any window of `per`, or in the whole of a weld that is shorter (mm).
    double allowed(double weldLength) const;
};

/// An interval of a size, mm.
struct SizeBounds {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool lowIncluded = true, highIncluded = true;

    bool contains(double value) const;
    bool bounded() const; ///< it has at least one end
};

enum class LimitKind { notPermitted, atMost, atLeast };

/// One limit.
struct AcceptanceItem {
    std::string imperfection; ///< a key of imperfections()
    std::vector<WeldKind> appliesTo;
    LimitKind kind = LimitKind::atMost;
    LimitFormula formula;                    ///< 0 of what is not permitted
    std::optional<ShortAllowance> shortOnes; ///< what is still allowed over short lengths
    SizeBounds t, b, leg;                    ///< sizes for which the item holds

    bool appliesToKind(WeldKind weld) const;
    /// Whether the item holds for a weld of these sizes; one that asks for an unknown size holds.
    bool holdsFor(const LimitSizes& sizes) const;
};

struct Acceptance {
    std::string standard; ///< such as "ISO 5817"
    std::string edition;
    std::string level; ///< such as "C"
    std::filesystem::path file;
    std::vector<AcceptanceItem> items;
};

/// Reads and checks an acceptance file; see the handbook's page on the measured weld. Throws InputError naming file,
/// line and key for anything that is unknown, missing or out of range.
Acceptance readAcceptance(const std::filesystem::path& file);

/// The shipped acceptance of this name ("iso5817-c"), or the file itself when the name ends in .toml. Throws InputError
/// that lists the shipped ones for another name.
Acceptance findAcceptance(const std::string& name);

/// Names of the shipped files, in order. Throws InputError where their folder cannot be read.
std::vector<std::string> acceptanceNames();

} // namespace meltpool
