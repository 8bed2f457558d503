// Temperature as a colour: the classic scale, a perceptually uniform one, and grey.
#pragma once

#include "core/gl/texture.hpp"
#include "core/render/look/look.hpp"

#include <glm/vec3.hpp>

namespace meltpool {

/// Returns the colour of `share` (0 coldest .. 1 hottest, clamped) as displayed: sRGB values 0..1. `colours` is
/// kTemperatureColours, kEvenColours or kGreyColours; anything else is treated as kTemperatureColours.
///
/// Classic: linear between blue, purple at 0.25, red at 0.5, yellow at 0.75 and white. Even: a path through Oklab
/// (Ottosson 2020) from dark blue over violet, red and orange to light yellow, whose lightness is proportional to the
/// length of the path, divided into steps of equal length. Grey: equal steps of Oklab lightness.
glm::vec3 temperatureColour(ColourMode colours, float share);

/// Returns the Oklab values (lightness 0..1, a, b) of a displayed sRGB colour.
glm::vec3 oklabOfShown(const glm::vec3& shown);

/// Makes a texture of all scales as rows in the order of ColourMode without the material's; shaders/render/scale.glsl
/// samples it.
gl::Texture makeScaleTexture();

} // namespace meltpool
