// When the torch's tip meets the metal: what the hand feels as a knock, whether heat is on or not.
#pragma once

#include <glm/vec3.hpp>

#include <limits>

namespace meltpool {

/// Where the shown surface of the metal lies from the tip, m in the workpiece's frame; infinite where there is none in
/// reach.
struct SurfaceDistance {
    float ahead = std::numeric_limits<float>::infinity();   ///< along the torch's axis; negative: the tip is inside
    float nearest = std::numeric_limits<float>::infinity(); ///< in any direction; negative: inside
    float liquid = 0;                                       ///< share of liquid where the torch points, 0..1
    glm::vec3 normal{0, 1, 0};                              ///< out of the metal at its nearest place
};

/// Notices when a tip of some radius meets the metal.
class TipTouch {
  public:
    /// Takes the newest distance, `elapsed` seconds after the last. `radius` (m): of the wire, electrode or iron.
    /// `velocity`: of the tip, m/s as the hand moves it.
    void update(float radius, const SurfaceDistance& metal, const glm::vec3& velocity, double elapsed);
    /// Nothing is known of the metal until the next update; metal that the tip is in then was not touched.
    void forget() { known_ = touching_ = false; }

    bool touching() const { return touching_; }
    /// Seconds since the tip met the metal; infinite before the first time.
    double since() const { return since_; }
    /// m/s, towards the metal, at that moment.
    float speed() const { return speed_; }
    /// How often it did.
    unsigned count() const { return count_; }

  private:
    bool known_ = false; ///< a tip that is inside at the first look did not get there by a touch
    bool touching_ = false;
    double since_ = std::numeric_limits<double>::infinity();
    float speed_ = 0;
    unsigned count_ = 0;
    float approach_ = 0; ///< fastest of late, m/s: the answer about the metal comes when the hand has already stopped
};

} // namespace meltpool
