// Share of an evenly bright room that a rough metal mirrors.
#pragma once

#include "core/gl/texture.hpp"

#include <glm/vec2.hpp>

namespace meltpool {

/// Returns the shares of an evenly bright room's light that a surface mirrors by the lobe of
/// shaders/render/reflectance.glsl, which counts light that meets one facet: `x` for a reflectance of 1 at normal
/// incidence, `y` the addition of Schlick's term for a surface of any reflectance. `roughness`: 0..1; `cosine`: between
/// the normal and the way to the eye, above 0.
glm::vec2 mirrorShares(float roughness, float cosine);

/// Makes a texture of mirrorShares(): cosine along x, roughness along y, both from 0 to 1, the texels' middles at the
/// ends.
gl::Texture makeMirrorShareTexture();

} // namespace meltpool
