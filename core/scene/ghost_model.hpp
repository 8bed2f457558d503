// The torch of a ghost: the drawn torch in one colour, half transparent, with an outline that is visible on dark and
// light.
#pragma once

#include "core/render/scene.hpp"
#include "core/weld/process/processes.hpp"
#include "core/weld/torch/torch_sample.hpp"

#include <vector>

namespace meltpool {

/// Linear sRGB, as displayed, in any light and with any visor.
inline constexpr glm::vec3 kGhostColour(0.78F, 0.70F, 1.0F);
/// Opacity of its outline, 0..1; the background must stay in sight.
inline constexpr float kGhostOpacity = 0.4F;
/// Share of that opacity on surfaces that face the eye.
inline constexpr float kGhostFace = 0.45F;

/// Adds the torch of this process at this pose, and its rod if it holds one, to `markers`. `arc`: see
/// buildTorchModel(); nothing glows. `strength`: 0..1 of kGhostOpacity. `size`: of torch and rod about their tips, over
/// that of the workpiece. `parts` is reused memory. `workpieceToWorld`: rotation, one scale, translation.
void addGhostTorch(std::vector<Marker>& markers, std::vector<Solid>& parts, const TorchSample& torch,
                   const ProcessSettings& process, const ArcState& arc, float strength, float size,
                   const glm::mat4& workpieceToWorld);

} // namespace meltpool
