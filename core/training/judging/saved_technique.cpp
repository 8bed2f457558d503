// Saves and restores the measured hand.
#include "core/gl/state_archive.hpp"
#include "core/training/judging/technique.hpp"

#include <cstdint>

namespace meltpool {

namespace {

constexpr size_t kMostSteps = size_t(1) << 28;

void transferStep(gl::StateArchive& archive, TechniqueStep& s) {
    // The second flag shares a byte with the first: states saved without it remain readable.
    constexpr std::uint8_t kWelds = 1, kGuessed = 2;
    std::uint8_t flags = static_cast<std::uint8_t>((s.welds ? kWelds : 0) | (s.known ? 0 : kGuessed));
    archive.values(s.time, s.place, s.aim, s.height, s.distance, s.workAngle, s.lean, s.rodAngle, s.rodGap, s.current,
                   s.voltage, flags, s.joined);
    s.welds = (flags & kWelds) != 0;
    s.known = (flags & kGuessed) == 0;
}

} // namespace

void DirectionSense::transfer(gl::StateArchive& archive) {
    archive.values(begun_, direction_, low_, high_);
}

void SlidingSlope::transfer(gl::StateArchive& archive) {
    archive.values(count_, sumT_, sumV_, sumTT_, sumTV_);
}

void Technique::transfer(gl::StateArchive& archive) {
    archive.values(now_, faults_.arcSeconds, faults_.lostSeconds, origin_, burned_, lost_);
    archive.count(faults_.dropped, kMostSteps);
    archive.count(oldest_, steps_.size());
    sense_.transfer(archive);
    slope_.transfer(archive);
    if (archive.restores()) guessedTo_ = kNever; // states are saved between frames
}

void Technique::transferSteps(gl::StateArchive& archive, size_t from, size_t to) {
    if (archive.restores()) steps_.resize(to);
    for (size_t i = from; i < to; ++i)
        transferStep(archive, steps_[i]);
}

} // namespace meltpool
