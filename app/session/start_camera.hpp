// The desk's camera at the start of a lesson: torch and seam are in the part of the picture that no panel covers.
#pragma once

#include "app/session/controls.hpp"
#include "app/session/desk_torch.hpp"
#include "core/render/framing.hpp"

#include <vector>

namespace meltpool {

/// Returns the points that the first picture of a lesson shows, in world units: the seam that is to be welded and, as
/// the last kTorchPoints, the desk's torch at its start; without a seam the metal and the heat source.
std::vector<glm::vec3> pointsToShow(const Lesson& lesson, const DeskTorch& torch);
inline constexpr size_t kTorchPoints = 2;

class StartCamera {
  public:
    /// Places the camera as the lesson says. `torch`: at its start.
    void begin(Controls& controls, const Lesson& lesson, const DeskTorch& torch);
    /// Moves the camera no more than it must to show those points in the uncovered part; no-op once the person has
    /// moved it. `aspect`: width over height of the picture. `torch`: false shows the seam alone, as when the torch is
    /// put aside.
    void frame(Controls& controls, const CoveredEdges& covered, float aspect, bool torch = true);

  private:
    OrbitCamera wanted_; ///< camera of the lesson
    OrbitCamera placed_; ///< camera of the last frame
    std::vector<glm::vec3> points_;
};

} // namespace meltpool
