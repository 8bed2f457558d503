// Wire or rod that melts into the pool: particles with exact mass and enthalpy.
#pragma once

#include "core/metal/state/metal_state.hpp"

#include <span>
#include <vector>

namespace meltpool {

class Filler {
  public:
    /// `spacing`: edge of the cube that a particle represents, m.
    explicit Filler(float spacing) : spacing_(spacing) {}

    /// Returns the particles of `volume` (m³) more filler, liquid, that leave `place` with `velocity` (m/s) at
    /// `temperature` (K). A remainder smaller than a particle is carried over to the next call, so the sum is exact to
    /// one particle. Several at once are placed in a row against the velocity, a spacing apart. They are valid until
    /// the next call.
    std::span<const MetalSeed> feed(double volume, glm::vec3 place, glm::vec3 velocity, float temperature);

    /// Saves or restores the remainder for the next call.
    void transfer(gl::StateArchive& archive);

    size_t fed() const { return fed_; }
    void reset() {
        waiting_ = 0;
        fed_ = 0;
    }

  private:
    float spacing_;
    std::vector<MetalSeed> seeds_;
    double waiting_ = 0; ///< m³ that do not fill a particle yet
    size_t fed_ = 0;
};

} // namespace meltpool
