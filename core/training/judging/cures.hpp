// Names a likely cause and its remedy for each imperfection that a weld was refused for.
#pragma once

#include "core/training/judging/score.hpp"
#include "core/training/judging/verdict.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

/// A numeric setting of machine or workpiece in an attempt, and in the lesson.
struct SettingFact {
    std::string key;  ///< as in lessons, such as "voltage"
    std::string name; ///< name within a sentence, such as "voltage"
    std::string unit; ///< "V"
    double value = 0; ///< value at the end of the attempt
    double asked = 0; ///< the lesson's own value, which its demonstration uses
    double least = 0; ///< values from `least` to `most` are as the lesson asks
    double most = 0;
    double lowest = 0; ///< values that the setting may have in this lesson
    double highest = 0;
    bool ofMachine = true; ///< false: a size of the workpiece
};

/// Likely cause and remedy of a failed imperfection.
struct Cure {
    std::string imperfection; ///< a key of imperfections()
    std::string sentence;     ///< "Overlap at 12 mm: likely too much metal there. Travel faster: 4.1 mm/s, target 6.5."
    /// Wish for readWhatIf() that tries the remedy, such as "voltage=20"; empty: no what-if can.
    std::string whatIf = {};
    std::string change = {}; ///< that wish in words: "voltage 20 V instead of 17"; empty without one
};

/// Knowledge about an attempt from which its cures are taken.
struct CureFacts {
    const std::vector<SeamMillimetre>& seam;
    const ProcessTraits& process;
    const TechniqueBands* bands = nullptr;      ///< null: the lesson asks for no technique
    std::span<const SettingFact> settings = {}; ///< settings of machine and workpiece
    std::span<const double> unknown = {};       ///< places with an unknown hand, see unknownPlaces()
};

/// One cure for each failed item, in the verdict's order. In this order of precedence:
///
/// 1. No arc at the place of the failure, or only strike or crater.
/// 2. A deviation of the hand there that explains the imperfection, beyond its tolerance; of several the largest as a
///    share of the one that has no points. A deviation within the tolerance is never named.
/// 3. A setting that explains it and is not as the lesson asks; of several the largest share of its asked value.
/// 4. A chosen setting that is allowed, and explains it by its difference from the demonstration's.
/// 5. The change of the machine that would most likely help.
std::vector<Cure> curesOf(const Verdict& verdict, const CureFacts& facts);

/// Outcome of an attempt that was welded again with a change, in sentences: the imperfections that would have passed,
/// still fail, or fail only then.
std::string whatIfOutcome(std::string_view change, std::span<const std::string> failed,
                          std::span<const std::string> failedThen);

/// Keys of the items that fail.
std::vector<std::string> failedKeys(const Verdict& verdict);

} // namespace meltpool
