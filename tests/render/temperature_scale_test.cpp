// Temperature colours: the classic scale's points, the even scale's evenness, grey, and their texture.
#include "core/render/look/temperature_scale.hpp"
#include "shaders/shared/render.h"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/geometric.hpp>

#include <algorithm>

namespace meltpool {

TEST_CASE("the classic scale runs blue, purple, red, yellow, white, linear between") {
    const auto at = [](float t) { return temperatureColour(kTemperatureColours, t); };
    CHECK(at(0) == glm::vec3(0, 0, 1));
    CHECK(at(0.25f) == glm::vec3(1, 0, 1));
    CHECK(at(0.5f) == glm::vec3(1, 0, 0));
    CHECK(at(0.75f) == glm::vec3(1, 1, 0));
    CHECK(at(1) == glm::vec3(1, 1, 1));
    CHECK(at(0.125f) == glm::vec3(0.5f, 0, 1));
    CHECK(at(0.875f) == glm::vec3(1, 1, 0.5f));
    CHECK(at(-3) == at(0));
    CHECK(at(7) == at(1));
}

TEST_CASE("the even and the grey scale rise in lightness by equal perceived steps") {
    constexpr int kSteps = 64;
    for (const ColourMode scale : {kEvenColours, kGreyColours}) {
        float least = 1e9f, most = 0, before = -1;
        for (int i = 0; i <= kSteps; ++i) {
            const glm::vec3 shown = temperatureColour(scale, static_cast<float>(i) / kSteps);
            CHECK(std::min({shown.x, shown.y, shown.z}) >= 0.0f);
            CHECK(std::max({shown.x, shown.y, shown.z}) <= 1.0f);
            const glm::vec3 lab = oklabOfShown(shown);
            CHECK(lab.x > before);
            before = lab.x;
            if (i == 0) continue;
            const glm::vec3 last = oklabOfShown(temperatureColour(scale, static_cast<float>(i - 1) / kSteps));
            least = std::min(least, glm::distance(lab, last));
            most = std::max(most, glm::distance(lab, last));
        }
        CHECK(most / least < 1.06f);
    }
}

TEST_CASE("the texture holds every scale at its own row") {
    test::context();
    const gl::Texture texture = makeScaleTexture();
    std::vector<glm::u8vec4> texels(static_cast<size_t>(SCALE_COLUMNS) * SCALE_ROWS);
    glGetTextureImage(texture.name(), 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(texels.size() * 4),
                      texels.data());
    for (const int row : {0, 1, 2})
        for (const int column : {0, 64, 100, 128, 192, 256}) {
            const auto shown = temperatureColour(static_cast<ColourMode>(kTemperatureColours + row),
                                                 static_cast<float>(column) / (SCALE_COLUMNS - 1));
            const glm::u8vec4 texel = texels[static_cast<size_t>(row * SCALE_COLUMNS + column)];
            for (int channel = 0; channel < 3; ++channel)
                CHECK(std::abs(static_cast<float>(texel[channel]) - shown[channel] * 255.0f) <= 0.51f);
        }
}

} // namespace meltpool
