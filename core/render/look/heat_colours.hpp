// The light of hot metal and the colours that heat leaves on steel.
#pragma once

#include "core/gl/texture.hpp"

#include <glm/vec3.hpp>

namespace meltpool {

/// Luminance that white paper has in the workshop's light, cd/m² (about 500 lx): what the renderer calls 1.
constexpr double kPaperLuminance = 160;

/// CIE 1931 tristimulus values of a black body at `temperature` (K): Planck's law, weighted with the colour matching
/// functions as fitted by Wyman, Sloan and Shirley 2013 ("Simple analytic approximations to the CIE XYZ color matching
/// functions"). Scaled so that Y is the luminance in cd/m².
glm::dvec3 blackBodyTristimulus(double temperature);

/// Its light in linear sRGB, 1 = paper white; parts that no screen can show are cut off.
glm::vec3 blackBodyLight(double temperature);

/// What oxide grown at a peak temperature (K) does to steel's reflectance: factors of linear sRGB, 1 where it never got
/// hot. Straw, brown, purple, blue, grey as in the workshop's table of temper colours, mill scale above; metal that has
/// been molten shows its own surface again.
glm::vec3 temperTint(double peakTemperature);

/// The share of light that a welding filter of this shade number lets through: 10^(-3 (shade - 1) / 7) (EN 169). Shade
/// 0 stands for no filter.
float filterShare(float shade);

/// Both as a texture over temperature, read by shaders/render/hot.glsl.
gl::Texture makeHeatTexture();

} // namespace meltpool
