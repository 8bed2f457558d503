// The table of causes: each imperfection with the deviations of hand and machine that lead to it, as teachers tell it.
#pragma once

#include "core/training/judging/quantity.hpp"

#include <optional>
#include <span>
#include <string_view>

namespace meltpool {

/// Effect of a cause on the weld; a key of [cure.effect] in the words file.
enum class CureEffect {
    cold,        ///< too little heat for the plate
    hot,         ///< too much heat
    muchMetal,   ///< more metal than the heat wets out
    littleMetal, ///< too little metal
    starved,     ///< the arc melts a groove that no metal fills
    oneSided,    ///< the arc melts one side more than the other
    runsAhead,   ///< the pool runs ahead of the arc, which then does not reach the plate
    air,         ///< air reaches the pool
    slag,        ///< slag runs ahead of the arc
    setUp,       ///< the plates were set up so
};

/// Name of an effect in [cure.effect].
std::string_view nameOf(CureEffect effect);

/// One row: this deviation leads to this imperfection.
struct CureCause {
    std::string_view imperfection;         ///< a key of imperfections()
    std::optional<TechniqueQuantity> hand; ///< quantity of the hand; empty: a setting
    std::string_view setting = {};         ///< key of a setting of machine or workpiece
    int sign = 0;                          ///< +1: too much of it, -1: too little, 0: either
    CureEffect effect = CureEffect::cold;
    /// True for the processes to which the row applies; null: all.
    bool (*only)(const ProcessTraits&) = nullptr;
};

/// All rows. Among those of one imperfection the likelier settings come first.
std::span<const CureCause> cureCauses();

} // namespace meltpool
