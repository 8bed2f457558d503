// The whole state of a lesson in progress at one moment: from here on the same torch gives the same bits.
#pragma once

#include "core/gl/state_archive.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace meltpool {

/// Made by Trainer::save() and Trainer::capture(), taken by Trainer::restore().
///
/// What only grows, the measured steps of the hand, may be in it in part only: from step `historyFrom` on. Then it can
/// be restored where the steps before that are known still, as they are in the attempt that it was saved in.
struct Checkpoint {
    size_t step = 0;            ///< that were made since the lesson's start
    double time = 0;            ///< s of the metal's time
    std::uint64_t identity = 0; ///< of lesson, workpiece and process
    size_t historyFrom = 0;     ///< first step of the hand in `history`
    size_t historyTo = 0;       ///< the step behind the last
    double historyTime = 0;     ///< s, time of the step before the first, by which it is known again; 0 for none
    std::vector<std::byte> history;
    std::vector<gl::StatePart> parts; ///< that `bytes` consist of
    std::vector<std::byte> bytes;
    std::uint64_t hash = 0; ///< of all the above, see seal()
};

/// Of everything in it but `hash`.
std::uint64_t hashOf(const Checkpoint& checkpoint);

/// After the last change to it.
void seal(Checkpoint& checkpoint);

/// Throws InputError where anything in it changed since seal().
void requireWhole(const Checkpoint& checkpoint);

/// Memory, bytes.
size_t sizeOf(const Checkpoint& checkpoint);

} // namespace meltpool
