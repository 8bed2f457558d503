// Colours of vertices for files, as the pictures show the metal.
#pragma once

#include "core/gl/program.hpp"
#include "core/render/look/look.hpp"
#include "core/render/scene.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace meltpool {

/// Returns the colour of the metal itself at each pair of temperature and highest temperature so far (0: not known), in
/// the scene's temperatures: the result of the drawing shaders' own functions, without lamp, arc, mirror image and
/// welding filter. Linear sRGB, 0..1. Material colours have temper colours and glow; other colours of the look are its
/// temperature scale. Waits for the GPU.
std::vector<glm::vec3> surfaceColours(gl::ShaderLibrary& shaders, const SceneView& scene, LookParameters look,
                                      std::span<const glm::vec2> heats);

} // namespace meltpool
