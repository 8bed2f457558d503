#include "core/render/look/temperature_scale.hpp"

#include "shaders/shared/render.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_precision.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace meltpool {

namespace {

float toLinear(float shown) {
    return shown <= 0.04045f ? shown / 12.92f : std::pow((shown + 0.055f) / 1.055f, 2.4f);
}

float toShown(float light) {
    return light <= 0.0031308f ? light * 12.92f : 1.055f * std::pow(light, 1 / 2.4f) - 0.055f;
}

/// Returns the linear sRGB of an Oklab colour; components outside 0..1 are outside the gamut.
glm::vec3 linearOfOklab(const glm::vec3& lab) {
    const float l = lab.x + 0.3963377774f * lab.y + 0.2158037573f * lab.z;
    const float m = lab.x - 0.1055613458f * lab.y - 0.0638541728f * lab.z;
    const float s = lab.x - 0.0894841775f * lab.y - 1.2914855480f * lab.z;
    const float l3 = l * l * l, m3 = m * m * m, s3 = s * s * s;
    return {4.0767416621f * l3 - 3.3077115913f * m3 + 0.2309699292f * s3,
            -1.2684380046f * l3 + 2.6097574011f * m3 - 0.3413193965f * s3,
            -0.0041960863f * l3 - 0.7034186147f * m3 + 1.7076147010f * s3};
}

glm::vec3 shownOfOklab(const glm::vec3& lab) {
    const glm::vec3 light = glm::clamp(linearOfOklab(lab), 0.0f, 1.0f);
    return {toShown(light.x), toShown(light.y), toShown(light.z)};
}

bool inGamut(const glm::vec3& lab) {
    const glm::vec3 light = linearOfOklab(lab);
    return std::min({light.x, light.y, light.z}) >= -1e-4f && std::max({light.x, light.y, light.z}) <= 1.0001f;
}

/// Returns the largest chroma inside the sRGB gamut at this lightness and hue.
float mostChroma(float lightness, float hue) {
    float low = 0, high = 0.4f;
    for (int i = 0; i < 24; ++i) {
        const float middle = 0.5f * (low + high);
        (inGamut({lightness, middle * std::cos(hue), middle * std::sin(hue)}) ? low : high) = middle;
    }
    return low;
}

/// Returns the path of the even scale before it is divided into equal steps: lightness and hue are linear, chroma stays
/// inside the gamut so that no corner of the gamut bends the path.
glm::vec3 evenPath(float along) {
    constexpr float kDegree = 0.01745329252f;
    const float lightness = 0.26f + 0.70f * along;
    const float hue = (265.0f + 195.0f * along) * kDegree; // blue, violet, red, orange, yellow
    const float chroma = std::min(0.85f * mostChroma(lightness, hue), 0.16f);
    return {lightness, chroma * std::cos(hue), chroma * std::sin(hue)};
}

std::vector<glm::vec3> divideEvenPath() {
    constexpr int kFine = 4096;
    std::vector<glm::vec3> path(kFine + 1);
    std::vector<float> length(kFine + 1, 0.0f);
    for (int i = 0; i <= kFine; ++i) {
        const auto at = static_cast<size_t>(i);
        path[at] = evenPath(static_cast<float>(i) / kFine);
        if (i > 0) length[at] = length[at - 1] + glm::distance(path[at], path[at - 1]);
    }
    std::vector<glm::vec3> colours;
    size_t at = 0;
    for (int i = 0; i < SCALE_COLUMNS; ++i) {
        const float wanted = length.back() * static_cast<float>(i) / (SCALE_COLUMNS - 1);
        while (at + 2 < length.size() && length[at + 1] < wanted)
            ++at;
        const float part = (wanted - length[at]) / std::max(length[at + 1] - length[at], 1e-9f);
        colours.push_back(shownOfOklab(glm::mix(path[at], path[at + 1], glm::clamp(part, 0.0f, 1.0f))));
    }
    return colours;
}

glm::vec3 between(const glm::vec3* colours, size_t count, float share) {
    const float at = glm::clamp(share, 0.0f, 1.0f) * static_cast<float>(count - 1);
    const size_t low = std::min(static_cast<size_t>(at), count - 2);
    return glm::mix(colours[low], colours[low + 1], at - static_cast<float>(low));
}

} // namespace

glm::vec3 oklabOfShown(const glm::vec3& shown) {
    const glm::vec3 c(toLinear(shown.x), toLinear(shown.y), toLinear(shown.z));
    const float l = std::cbrt(0.4122214708f * c.x + 0.5363325363f * c.y + 0.0514459929f * c.z);
    const float m = std::cbrt(0.2119034982f * c.x + 0.6806995451f * c.y + 0.1073969566f * c.z);
    const float s = std::cbrt(0.0883024619f * c.x + 0.2817188376f * c.y + 0.6299787005f * c.z);
    return {0.2104542553f * l + 0.7936177850f * m - 0.0040720468f * s,
            1.9779984951f * l - 2.4285922050f * m + 0.4505937099f * s,
            0.0259040371f * l + 0.7827717662f * m - 0.8086757660f * s};
}

glm::vec3 temperatureColour(ColourMode colours, float share) {
    static const std::vector<glm::vec3> even = divideEvenPath();
    static constexpr std::array<glm::vec3, 5> classic{glm::vec3(0, 0, 1), glm::vec3(1, 0, 1), glm::vec3(1, 0, 0),
                                                      glm::vec3(1, 1, 0), glm::vec3(1, 1, 1)};
    if (colours == kEvenColours) return between(even.data(), even.size(), share);
    if (colours == kGreyColours) return shownOfOklab({0.12f + 0.88f * glm::clamp(share, 0.0f, 1.0f), 0, 0});
    return between(classic.data(), classic.size(), share);
}

gl::Texture makeScaleTexture() {
    std::vector<glm::u8vec4> texels;
    for (const ColourMode row : {kTemperatureColours, kEvenColours, kGreyColours})
        for (int column = 0; column < SCALE_COLUMNS; ++column) {
            const float share = static_cast<float>(column) / (SCALE_COLUMNS - 1);
            texels.emplace_back(glm::round(temperatureColour(row, share) * 255.0f), 255);
        }
    gl::Texture texture("temperature scales", {.format = GL_RGBA8, .width = SCALE_COLUMNS, .height = SCALE_ROWS});
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTextureSubImage2D(texture.name(), 0, 0, 0, SCALE_COLUMNS, SCALE_ROWS, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    return texture;
}

} // namespace meltpool
