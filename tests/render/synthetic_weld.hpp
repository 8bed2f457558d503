// A fixed picture of a weld: a plate with a bead behind a pool, temperatures after Rosenthal's moving point source.
#pragma once

#include "core/gl/buffer.hpp"
#include "core/render/scene.hpp"

namespace meltpool::test {

/// Returns the temperature (K) around a point source of 1500 W that moves along +x at 5 mm/s over thick steel, at `at`
/// (m) from it, y down into the plate. Never above 2700 K, as near a real pool.
double weldTemperature(const glm::dvec3& at);
/// Returns the highest temperature reached by metal `aside` (m) of the seam and `deep` below it when the source is
/// `behind` (m, along -x) away.
double weldPeak(double behind, double aside, double deep);

class SyntheticWeld {
  public:
    SyntheticWeld();
    SceneView view() const;
    /// Returns a view with the times at which the bead froze, for ripples.
    SceneView rippledView() const;
    /// Returns the cut across the seam at x = -10 mm, 6 mm around it.
    SectionMap map() const;

  private:
    gl::Buffer vertices_, indices_, command_, peaks_, freezing_, particles_;
    size_t particleCount_ = 0;
    MaterialLooks looks_;
};

} // namespace meltpool::test
