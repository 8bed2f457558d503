// The torch of a ghost: the drawn torch in one colour, half transparent, with an outline that is seen on dark and
// light.
#pragma once

#include "core/render/scene.hpp"
#include "core/weld/process/processes.hpp"
#include "core/weld/torch/torch_sample.hpp"

#include <vector>

namespace meltpool {

/// Linear sRGB, as displayed, whatever light and visor there are.
inline constexpr glm::vec3 kGhostColour(0.78F, 0.70F, 1.0F);
/// 0..1 of its outline; what is behind it must stay in sight.
inline constexpr float kGhostOpacity = 0.4F;
/// Share of that where its surface faces the eye.
inline constexpr float kGhostFace = 0.45F;

/// Adds the torch of this process at this pose, and its rod where it holds one, to `markers`. `arc`: see
/// buildTorchModel(); nothing glows. `strength`: 0..1 of kGhostOpacity. `size`: of torch and rod about their tips, over
/// that of the workpiece. `parts` is room that is used again. `workpieceToWorld`: rotation, one scale, translation.
void addGhostTorch(std::vector<Marker>& markers, std::vector<Solid>& parts, const TorchSample& torch,
                   const ProcessSettings& process, const ArcState& arc, float strength, float size,
                   const glm::mat4& workpieceToWorld);

} // namespace meltpool
