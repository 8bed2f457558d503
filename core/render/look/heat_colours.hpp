// Light of hot metal and temper colours of steel.
#pragma once

#include "core/gl/texture.hpp"

#include <glm/vec3.hpp>

namespace meltpool {

/// Luminance of white paper in the workshop's light (about 500 lx), cd/m²: the renderer's unit of light.
constexpr double kPaperLuminance = 160;

/// Returns the CIE 1931 tristimulus values of a black body at `temperature` (K): Planck's law, weighted with the colour
/// matching functions as fitted by Wyman, Sloan and Shirley 2013 ("Simple analytic approximations to the CIE XYZ color
/// matching functions"). Scaled so that Y is the luminance in cd/m².
glm::dvec3 blackBodyTristimulus(double temperature);

/// Returns the light of a black body in linear sRGB, 1 = white paper; negative components, outside the gamut, become 0.
glm::vec3 blackBodyLight(double temperature);

/// Returns the factors on the reflectance of steel (linear sRGB) from the oxide that grows at a peak temperature (K); 1
/// for metal that never was hot. Straw, brown, purple, blue, grey as in workshop tables of temper colours, mill scale
/// above; metal that was molten has lost its former oxide.
glm::vec3 temperTint(double peakTemperature);

/// Returns the luminous transmittance of a welding filter of this shade number: 10^(-3 (shade - 1) / 7) (EN 169). Shade
/// 0: no filter.
float filterShare(float shade);

/// Makes a texture of blackBodyLight() and temperTint() as rows over temperature, read by shaders/render/hot.glsl.
gl::Texture makeHeatTexture();

} // namespace meltpool
