#include "core/render/look/heat_colours.hpp"

#include "shaders/shared/render.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>

#include <array>
#include <cmath>
#include <vector>

namespace meltpool {

namespace {

constexpr double kKelvinAtZero = 273.15;

/// Returns a Gaussian with different widths on its two sides.
double lobe(double nm, double middle, double below, double above) {
    const double t = (nm - middle) / (nm < middle ? below : above);
    return std::exp(-0.5 * t * t);
}

glm::dvec3 matching(double nm) {
    return {1.056 * lobe(nm, 599.8, 37.9, 31.0) + 0.362 * lobe(nm, 442.0, 16.0, 26.7) -
                0.065 * lobe(nm, 501.1, 20.4, 26.2),
            0.821 * lobe(nm, 568.8, 46.9, 40.5) + 0.286 * lobe(nm, 530.9, 16.3, 31.1),
            1.217 * lobe(nm, 437.0, 11.8, 36.0) + 0.681 * lobe(nm, 459.0, 26.0, 13.8)};
}

/// Returns the spectral radiance, W / (m² sr m).
double planck(double metres, double temperature) {
    constexpr double h = 6.62607015e-34, c = 299792458.0, k = 1.380649e-23;
    return 2 * h * c * c / std::pow(metres, 5) / std::expm1(h * c / (metres * k * temperature));
}

struct Tint {
    double celsius;
    glm::vec3 factor;
};

constexpr std::array<Tint, 15> kTints{{{185, {1.00f, 1.00f, 1.00f}},
                                       {205, {1.00f, 0.95f, 0.80f}}, // faint straw
                                       {227, {1.00f, 0.86f, 0.52f}}, // straw
                                       {243, {0.94f, 0.70f, 0.32f}}, // dark straw
                                       {260, {0.72f, 0.42f, 0.22f}}, // brown
                                       {275, {0.52f, 0.25f, 0.34f}}, // purple
                                       {290, {0.32f, 0.24f, 0.55f}}, // violet
                                       {305, {0.17f, 0.28f, 0.62f}}, // dark blue
                                       {320, {0.27f, 0.42f, 0.72f}}, // full blue
                                       {350, {0.46f, 0.58f, 0.70f}}, // light blue
                                       {400, {0.50f, 0.54f, 0.56f}}, // grey
                                       {600, {0.34f, 0.34f, 0.35f}},
                                       {900, {0.20f, 0.19f, 0.19f}}, // mill scale
                                       {1400, {0.19f, 0.18f, 0.18f}},
                                       {1530, {0.62f, 0.62f, 0.63f}}}}; // formerly molten metal

} // namespace

glm::dvec3 blackBodyTristimulus(double temperature) {
    constexpr double kStep = 5; // nm
    constexpr double kLumenPerWatt = 683.002;
    glm::dvec3 sum(0.0);
    if (temperature <= 0) return sum;
    for (double nm = 360; nm <= 830; nm += kStep)
        sum += matching(nm) * planck(nm * 1e-9, temperature);
    return sum * (kLumenPerWatt * kStep * 1e-9);
}

glm::vec3 blackBodyLight(double temperature) {
    const glm::dvec3 c = blackBodyTristimulus(temperature) / kPaperLuminance;
    const glm::dvec3 light(3.2404542 * c.x - 1.5371385 * c.y - 0.4985314 * c.z,
                           -0.9692660 * c.x + 1.8760108 * c.y + 0.0415560 * c.z,
                           0.0556434 * c.x - 0.2040259 * c.y + 1.0572252 * c.z);
    return glm::max(glm::vec3(light), 0.0f);
}

glm::vec3 temperTint(double peakTemperature) {
    const double celsius = peakTemperature - kKelvinAtZero;
    if (celsius <= kTints.front().celsius) return kTints.front().factor;
    for (size_t i = 1; i < kTints.size(); ++i) {
        if (celsius > kTints[i].celsius) continue;
        const double part = (celsius - kTints[i - 1].celsius) / (kTints[i].celsius - kTints[i - 1].celsius);
        return glm::mix(kTints[i - 1].factor, kTints[i].factor, static_cast<float>(part));
    }
    return kTints.back().factor;
}

float filterShare(float shade) {
    return shade <= 0 ? 1.0f : std::pow(10.0f, -3.0f * (shade - 1.0f) / 7.0f);
}

gl::Texture makeHeatTexture() {
    const gl::Texture::Shape shape{.format = GL_RGBA16F, .width = HEAT_COLUMNS, .height = 2};
    std::vector<glm::vec4> texels;
    const auto kelvin = [](int column) {
        return HEAT_COLDEST + (HEAT_HOTTEST - HEAT_COLDEST) * column / double(HEAT_COLUMNS - 1);
    };
    // The fourth root fits nine decades of light into half precision and keeps linear filtering smooth.
    for (int column = 0; column < HEAT_COLUMNS; ++column)
        texels.emplace_back(glm::pow(blackBodyLight(kelvin(column)), glm::vec3(0.25f)), 1.0f);
    for (int column = 0; column < HEAT_COLUMNS; ++column)
        texels.emplace_back(temperTint(kelvin(column)), 1.0f);
    gl::Texture texture("heat colours", shape);
    glTextureSubImage2D(texture.name(), 0, 0, 0, HEAT_COLUMNS, 2, GL_RGBA, GL_FLOAT, texels.data());
    return texture;
}

} // namespace meltpool
