#include "core/weld/process/filler.hpp"

#include "core/gl/state_archive.hpp"

#include <glm/geometric.hpp>

#include <limits>

namespace meltpool {

void Filler::transfer(gl::StateArchive& archive) {
    archive.values(waiting_);
    archive.count(fed_, std::numeric_limits<size_t>::max());
}

std::span<const MetalSeed> Filler::feed(double volume, glm::vec3 place, glm::vec3 velocity, float temperature) {
    const double each = static_cast<double>(spacing_) * static_cast<double>(spacing_) * static_cast<double>(spacing_);
    waiting_ += volume;
    const float speed = glm::length(velocity);
    const glm::vec3 back = speed > 0 ? -velocity / speed * spacing_ : glm::vec3(0, spacing_, 0);
    seeds_.clear();
    for (; waiting_ >= each; waiting_ -= each)
        seeds_.push_back(
            {place + back * static_cast<float>(seeds_.size()), temperature, PHASE_ALIVE | PHASE_LIQUID, velocity});
    fed_ += seeds_.size();
    return seeds_;
}

} // namespace meltpool
