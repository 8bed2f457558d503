// A checkpoint holds the whole state of a running lesson: from it the same torch gives the same bits.
#pragma once

#include "core/gl/state_archive.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace meltpool {

/// Made by Trainer::save() and Trainer::capture(), taken by Trainer::restore().
///
/// The measured steps of the hand only grow, so a checkpoint may hold them from step `historyFrom` on alone. Such a
/// checkpoint can be restored only in the attempt that made it, where the earlier steps are still known.
struct Checkpoint {
    size_t step = 0;            ///< steps since the lesson's start
    double time = 0;            ///< metal time, s
    std::uint64_t identity = 0; ///< hash of lesson, workpiece and process
    size_t historyFrom = 0;     ///< first step of the hand in `history`
    size_t historyTo = 0;       ///< step behind the last one in `history`
    double historyTime = 0;     ///< s, time of the step before the first, used to recognise it; 0: no such step
    std::vector<std::byte> history;
    std::vector<gl::StatePart> parts; ///< parts of `bytes`, in order
    std::vector<std::byte> bytes;
    std::uint64_t hash = 0; ///< hash of all the above, see seal()
};

/// Hash of everything in the checkpoint except `hash`.
std::uint64_t hashOf(const Checkpoint& checkpoint);

/// Sets the hash. Call it after the last change.
void seal(Checkpoint& checkpoint);

/// Throws InputError if anything in it changed since seal().
void requireWhole(const Checkpoint& checkpoint);

/// Memory in bytes.
size_t sizeOf(const Checkpoint& checkpoint);

} // namespace meltpool
