// Ripples of frozen metal: their pitch is travel speed over frequency, found by a Fourier transform along the bead; and
// places without ripples.
#include "core/render/camera.hpp"
#include "shaders/shared/surface.h"
#include "tests/render/look/patch.hpp"
#include "tests/support/catch.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <numeric>
#include <vector>

namespace meltpool {

namespace {

using glm::vec3;

constexpr int kPixels = 512;
constexpr float kHalf = 0.02f; ///< m, half the bead's length

/// Time (s) at which a bead froze at `x` (m), and its slope.
using FreezingLaw = std::function<glm::vec2(float x)>;

/// A flat bead along x that froze from -x to +x at `speed` (m/s).
class Bead {
  public:
    explicit Bead(float speed, float temperature = 900, float frozen = 1)
        : Bead([=](float x) { return glm::vec2(10 + x / speed, 1 / speed); }, temperature, frozen) {}

    explicit Bead(const FreezingLaw& law, float temperature = 900, float frozen = 1) {
        std::vector<SurfaceVertex> vertices;
        std::vector<SurfaceFreezing> freezing;
        std::vector<GLuint> indices;
        constexpr GLuint kCells = 40; // 1 mm: coarser than the ripples
        for (GLuint i = 0; i <= kCells; ++i)
            for (const float y : {-0.02f, 0.02f}) {
                const float x = kHalf * (2 * float(i) / float(kCells) - 1);
                const glm::vec2 time = law(x);
                vertices.push_back({{x, y, 0}, temperature, {0, 0, 1}, frozen});
                freezing.push_back({{time.y, 0, 0}, time.x});
            }
        for (GLuint i = 0; i < 2 * kCells; i += 2)
            indices.insert(indices.end(), {i, i + 2, i + 3, i, i + 3, i + 1});
        const std::vector<float> peaks(vertices.size(), 2000.0f);
        const SurfaceDraw draw{static_cast<uint>(indices.size()), 1, 0, 0, 0};
        vertices_ = gl::Buffer("bead vertices", std::span<const SurfaceVertex>(vertices));
        indices_ = gl::Buffer("bead indices", std::span<const GLuint>(indices));
        command_ = gl::Buffer("bead command", std::span<const SurfaceDraw>(&draw, 1));
        peaks_ = gl::Buffer("bead peaks", std::span<const float>(peaks));
        freezing_ = gl::Buffer("bead freezing", std::span<const SurfaceFreezing>(freezing));
    }

    SceneView scene(const MaterialLooks& looks) const {
        SceneView scene;
        scene.mesh = {&vertices_, &indices_, &command_, &peaks_, &freezing_};
        scene.modelToWorld = glm::scale(glm::mat4(1), vec3(25)); // scale of displayed welds
        scene.temperature = {293.15f, 2500, true, test::kPatchSolidus, test::kPatchLiquidus};
        scene.looks = &looks;
        return scene;
    }

  private:
    gl::Buffer vertices_, indices_, command_, peaks_, freezing_;
};

/// Returns the light along the middle row of a picture that sees `length` (m) of the bead from above.
std::vector<double> lightAlong(const SceneView& scene, const LookParameters& look, float length) {
    const gl::Texture colour("light", {.format = GL_RGBA32F, .width = kPixels, .height = 1});
    const gl::Texture depth("depth", {.format = GL_DEPTH_COMPONENT24, .width = kPixels, .height = 1});
    const gl::Framebuffer picture("light");
    picture.attach(GL_COLOR_ATTACHMENT0, colour);
    picture.attach(GL_DEPTH_ATTACHMENT, depth);
    const float half = 0.5f * 25 * length, high = half / float(kPixels), far = 4;
    View view = FreeCamera({0, 0, far}, {0, 0, 0}).view({}, 1);
    view.eyeToClip = glm::frustum(-half / far, half / far, -high / far, high / far, 1.0f, 10.0f);
    const RenderTarget where{.framebuffer = picture.name(), .viewport = {0, 0, kPixels, 1}, .encodesSrgb = true};
    test::evenlyLit(0.5f).draw(scene, look, {&view, 1}, where, nullptr);
    std::vector<glm::vec4> row(kPixels);
    glBindFramebuffer(GL_FRAMEBUFFER, picture.name());
    glReadPixels(0, 0, kPixels, 1, GL_RGBA, GL_FLOAT, row.data());
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    std::vector<double> light;
    for (const glm::vec4& pixel : row)
        light.push_back(double(pixel.g));
    return light;
}

/// Returns the number of whole waves along the row with the largest amplitude.
int strongestWave(const std::vector<double>& row) {
    const double mean = std::accumulate(row.begin(), row.end(), 0.0) / double(row.size());
    int strongest = 0;
    double most = 0;
    for (int k = 1; k < kPixels / 2; ++k) {
        std::complex<double> sum = 0;
        for (int i = 0; i < kPixels; ++i) {
            const double turn = 2 * std::numbers::pi * double(i) / kPixels;
            const double window = 0.5 - 0.5 * std::cos(turn); // Hann window: the row's ends make no step
            sum += (row[size_t(i)] - mean) * window * std::polar(1.0, -turn * k);
        }
        if (std::abs(sum) <= most) continue;
        most = std::abs(sum);
        strongest = k;
    }
    return strongest;
}

/// Returns the difference of largest and smallest light, over the mean.
double contrast(const std::vector<double>& row) {
    const auto [least, most] = std::minmax_element(row.begin(), row.end());
    return (*most - *least) * double(row.size()) / std::accumulate(row.begin(), row.end(), 0.0);
}

LookParameters lampFromBehind() {
    LookParameters look = test::roomOnly(0.2f);
    look.diffuse = 0.8f;
    look.lightPosition = {-3, 0, 2};
    return look;
}

} // namespace

TEST_CASE("the pitch of a bead's ripples is travel speed over frequency, at two speeds and two frequencies") {
    MaterialLooks looks;
    looks.heatTint = 1;
    for (const float speed : {0.005f, 0.008f})
        for (const float frequency : {10.0f, 7.0f}) {
            looks.rippleFrequency = frequency;
            constexpr float kSeen = 0.02f; // m
            const auto row = lightAlong(Bead(speed).scene(looks), lampFromBehind(), kSeen);
            const double waves = double(kSeen * frequency / speed);
            INFO(speed << " m/s, " << frequency << " Hz: " << waves << " waves expected, found " << strongestWave(row)
                       << ", contrast " << contrast(row));
            CHECK(std::abs(strongestWave(row) - waves) <= 1);
            CHECK(contrast(row) > 0.15);
        }
}

TEST_CASE(
    "the pitch is that of the process where the metal names no frequency, and lower processes give fainter ripples") {
    MaterialLooks looks;
    looks.heatTint = 1;
    constexpr float kSpeed = 0.006f, kSeen = 0.02f; // m/s, m
    const auto row = [&](FreezingRipples ripples) {
        const Bead bead(kSpeed);
        SceneView scene = bead.scene(looks);
        scene.ripples = ripples;
        return lightAlong(scene, lampFromBehind(), kSeen);
    };
    for (const float frequency : {6.0f, 16.0f}) {
        const double waves = double(kSeen * frequency / kSpeed);
        CHECK(std::abs(strongestWave(row({frequency, 1})) - waves) <= 1);
    }
    CHECK(contrast(row({6, 0.3f})) < 0.6 * contrast(row({6, 1})));
    looks.rippleFrequency = 9; // the metal's own frequency
    CHECK(std::abs(strongestWave(row({16, 1})) - double(kSeen * 9 / kSpeed)) <= 1);
}

TEST_CASE("where the torch stopped the ripples crowd and run back to the middle of the crater") {
    // The crater of 4 mm closes from both ends in a second; then the bead continues.
    constexpr float kSpeed = 0.005f, kCloses = 1, kCrater = 0.002f, kSeen = 0.01f, kPause = 3;
    MaterialLooks looks;
    looks.heatTint = 1;
    looks.rippleFrequency = 9.3f;
    const Bead stopped([&](float x) {
        const float inward = kCloses / kCrater, rim = 10 - kCrater / kSpeed;
        if (x < -kCrater - 1e-5f) return glm::vec2(10 + x / kSpeed, 1 / kSpeed);
        if (x > kCrater + 1e-5f) return glm::vec2(10 + kPause + x / kSpeed, 1 / kSpeed);
        return glm::vec2(rim + inward * (kCrater - std::abs(x)), x < 0 ? inward : -inward);
    });
    const auto row = lightAlong(stopped.scene(looks), lampFromBehind(), kSeen);
    const auto steady = lightAlong(Bead(kSpeed).scene(looks), lampFromBehind(), kSeen);
    const auto waves = [&](const std::vector<double>& light, float from, float to) { // upward crossings of the mean
        const auto at = [&](float x) { return size_t(std::lround((x / kSeen + 0.5f) * kPixels)); };
        const auto part = std::span(light).subspan(at(from), at(to) - at(from));
        const double mean = std::accumulate(part.begin(), part.end(), 0.0) / double(part.size());
        int crossings = 0;
        for (size_t i = 1; i < part.size(); ++i)
            crossings += part[i - 1] < mean && part[i] >= mean ? 1 : 0;
        return crossings;
    };
    for (const float side : {-1.0f, 0.0f}) {
        const float from = side * kCrater, to = from + kCrater;
        INFO("from " << from * 1e3f << " mm: " << waves(row, from, to) << " waves, " << waves(steady, from, to)
                     << " without the stop");
        CHECK(std::abs(waves(row, from, to) - 9.3 * double(kCloses)) <= 1);
        CHECK(std::abs(waves(steady, from, to) - 9.3 * double(kCrater / kSpeed)) <= 1);
    }
    // The bead behind the crater equals that before the torch's stop.
    for (size_t i = 0; i < size_t(0.25 * kPixels); ++i)
        CHECK(row[i] == Approx(steady[i]).epsilon(0.01));
}

TEST_CASE("slower travel gives finer ripples, which are no steeper than metal bears") {
    MaterialLooks looks;
    looks.rippleHeight = 1; // full height
    const double fast = contrast(lightAlong(Bead(0.008f).scene(looks), lampFromBehind(), 0.005f)),
                 slow = contrast(lightAlong(Bead(0.004f).scene(looks), lampFromBehind(), 0.005f));
    CHECK(slow == Approx(fast).epsilon(0.03));
    CHECK(fast < 1);
}

TEST_CASE(
    "there are no ripples on liquid metal, on metal that never froze, in low detail and where pixels are too wide") {
    const MaterialLooks looks;
    LookParameters look = lampFromBehind();
    const auto seen = [&](const Bead& bead, float length) {
        return contrast(lightAlong(bead.scene(looks), look, length));
    };
    const double there = seen(Bead(0.005f), 0.02f);
    CHECK(there > 0.15);
    CHECK(seen(Bead(0.005f, 2000), 0.02f) < 0.02);
    CHECK(seen(Bead(0.005f, 900, 0), 0.02f) < 0.02);
    // 0.5 mm: 80 waves on 512 pixels have 6.4 pixels each; the waves at 3 mm/s have fewer than 3.
    CHECK(seen(Bead(0.005f), 0.04f) > 0.7 * there);
    CHECK(seen(Bead(0.0022f), 0.04f) < 0.02);
    MaterialLooks smooth;
    smooth.rippleHeight = 0;
    CHECK(contrast(lightAlong(Bead(0.005f).scene(smooth), look, 0.02f)) < 0.02);
    look.detail = kLowDetail;
    CHECK(seen(Bead(0.005f), 0.02f) < 0.02);
}

} // namespace meltpool
