// A square of metal of one temperature, with the light in the middle of its picture as numbers.
#pragma once

#include "core/render/renderer.hpp"

#include <vector>

namespace meltpool::test {

/// Freezing range of the patch's metal, K: that of S235.
constexpr float kPatchSolidus = 1768, kPatchLiquidus = 1813;

/// A small square in the plane z = 0 that faces +z, of one temperature and one highest temperature (K).
class Patch {
  public:
    Patch(float temperature, float peak);

    /// `looks` must outlive the scene.
    SceneView scene(const MaterialLooks& looks) const;

  private:
    gl::Buffer vertices_, indices_, command_, peaks_;
};

/// Returns one shared renderer in its workshop: painting its room takes longer than a test.
Renderer& patchRenderer();

/// Returns another shared renderer, with equal light from all directions. Its light is that of the last call.
Renderer& evenlyLit(float light);

/// Returns parameters without box, sky and source, whose only light is the room's `ambient`.
LookParameters roomOnly(float ambient);

/// Returns the green light of each pixel of a square picture of `size` pixels a side, row after row from below, after
/// exposure and tone curve.
std::vector<float> lightOfPixels(Renderer& renderer, const SceneView& scene, const LookParameters& look,
                                 const View& view, int size);

/// Returns the light in the middle of a picture from `eye` towards `target`, after exposure and tone curve.
glm::vec3 lightOf(Renderer& renderer, const SceneView& scene, const LookParameters& look, glm::vec3 eye = {0, 0, 1},
                  glm::vec3 target = {0, 0, 0});

} // namespace meltpool::test
