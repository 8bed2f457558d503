// Detector of contact between the torch's tip and the metal: the hand feels a knock, with heat on or off.
#pragma once

#include <glm/vec3.hpp>

#include <limits>

namespace meltpool {

/// Distance of the drawn surface of the metal from the tip, m in the workpiece's frame; infinite if none is in reach.
struct SurfaceDistance {
    /// Distance along the torch's axis; negative: the tip is inside.
    float ahead = std::numeric_limits<float>::infinity();
    float nearest = std::numeric_limits<float>::infinity(); ///< distance in any direction; negative: inside
    /// share of liquid in the metal that the torch points at, 0..1.
    float liquid = 0;
    glm::vec3 normal{0, 1, 0}; ///< direction out of the metal at its nearest place
};

/// Detects that a tip of some radius meets the metal.
class TipTouch {
  public:
    /// Takes the newest distance, `elapsed` seconds after the last. `radius` (m): of the wire, electrode or iron.
    /// `velocity`: of the tip, m/s as the hand moves it.
    void update(float radius, const SurfaceDistance& metal, const glm::vec3& velocity, double elapsed);
    /// Discards the known distance until the next update; metal that surrounds the tip then does not count as touched.
    void forget() { known_ = touching_ = false; }

    bool touching() const { return touching_; }
    /// Returns the seconds since the tip met the metal; infinite before the first time.
    double since() const { return since_; }
    /// Returns the speed towards the metal at that moment, m/s.
    float speed() const { return speed_; }
    /// Returns the number of contacts.
    unsigned count() const { return count_; }

  private:
    bool known_ = false; ///< a tip that is inside at the first update did not touch
    bool touching_ = false;
    double since_ = std::numeric_limits<double>::infinity();
    float speed_ = 0;
    unsigned count_ = 0;
    /// Greatest recent speed, m/s: the answer about the metal comes when the hand has already stopped.
    float approach_ = 0;
};

} // namespace meltpool
