// A square of metal of one temperature, and the light that a picture has in its middle as numbers.
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

/// One renderer for all who use this, in its workshop: painting its room takes longer than a test.
Renderer& patchRenderer();

/// Another for all who use this, with the same light everywhere around. It is the same one with the last light asked
/// for.
Renderer& evenlyLit(float light);

/// No box, sky and source, and no light but `ambient` of the room.
LookParameters roomOnly(float ambient);

/// Light (green) of each pixel of a square picture of `size` pixels a side, row after row from below, after exposure
/// and tone curve.
std::vector<float> lightOfPixels(Renderer& renderer, const SceneView& scene, const LookParameters& look,
                                 const View& view, int size);

/// Light in the middle of the picture that an eye at `eye` has which looks at `target`, after exposure and tone curve.
glm::vec3 lightOf(Renderer& renderer, const SceneView& scene, const LookParameters& look, glm::vec3 eye = {0, 0, 1},
                  glm::vec3 target = {0, 0, 0});

} // namespace meltpool::test
