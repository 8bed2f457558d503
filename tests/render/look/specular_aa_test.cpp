// Highlights on metal whose normals vary within a pixel: calmer with antialiasing, and closer to a picture of many
// samples.
#include "core/render/camera.hpp"
#include "core/render/look/measures.hpp"
#include "shaders/shared/surface.h"
#include "tests/render/look/patch.hpp"
#include "tests/support/catch.hpp"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cmath>
#include <vector>

namespace meltpool {

namespace {

constexpr int kSize = 48; ///< pixels per edge of the picture

/// A flat sheet with waving normals, a wave in about three pixels, as ripples on a bead in the distance.
class RippledSheet {
  public:
    RippledSheet() {
        constexpr int kCells = 220;
        std::vector<SurfaceVertex> vertices;
        std::vector<GLuint> indices;
        for (int i = 0; i <= kCells; ++i)
            for (int j = 0; j <= kCells; ++j) {
                const float x = -0.1f + 0.2f * float(i) / kCells, y = -0.1f + 0.2f * float(j) / kCells;
                const glm::vec3 normal(0.25f * std::sin(520 * x + 110 * y), 0.2f * std::sin(460 * y - 150 * x), 1);
                vertices.push_back({{x, y, 0}, 300, glm::normalize(normal), 0});
            }
        for (GLuint i = 0; i < kCells; ++i)
            for (GLuint j = 0; j < kCells; ++j) {
                const GLuint a = i * (kCells + 1) + j, b = a + kCells + 1;
                indices.insert(indices.end(), {a, b, b + 1, a, b + 1, a + 1});
            }
        const SurfaceDraw draw{static_cast<uint>(indices.size()), 1, 0, 0, 0};
        vertices_ = gl::Buffer("sheet vertices", std::span<const SurfaceVertex>(vertices));
        indices_ = gl::Buffer("sheet indices", std::span<const GLuint>(indices));
        command_ = gl::Buffer("sheet command", std::span<const SurfaceDraw>(&draw, 1));
    }

    SceneView scene(const MaterialLooks& looks) const {
        SceneView scene;
        scene.mesh = {&vertices_, &indices_, &command_, nullptr};
        scene.temperature = {293.15f, 2500, true, test::kPatchSolidus, test::kPatchLiquidus};
        scene.looks = &looks;
        scene.arc = {{0.02f, 0.03f, 0.1f}, glm::vec3(2e-3f), 2e-3f};
        return scene;
    }

  private:
    gl::Buffer vertices_, indices_, command_;
};

/// Returns the light of the pixels, sampled once each at this offset, -0.5..0.5 of a pixel from their middles.
std::vector<float> sampled(const SceneView& scene, const LookParameters& look, glm::vec2 shift) {
    View view = FreeCamera({0, -0.05f, 0.22f}, {0, 0, 0}).view({}, 1);
    view.eyeToClip[2][0] += 2 * shift.x / kSize;
    view.eyeToClip[2][1] += 2 * shift.y / kSize;
    return test::lightOfPixels(test::evenlyLit(0.3f), scene, look, view, kSize);
}

/// Returns the samples at `side` x `side` offsets over the pixel.
std::vector<std::vector<float>> sampledEverywhere(const SceneView& scene, const LookParameters& look, int side) {
    std::vector<std::vector<float>> all;
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j)
            all.push_back(
                sampled(scene, look, {(float(i) + 0.5f) / float(side) - 0.5f, (float(j) + 0.5f) / float(side) - 0.5f}));
    return all;
}

std::vector<double> meanOf(const std::vector<std::vector<float>>& samples) {
    std::vector<double> mean(samples.front().size());
    for (const std::vector<float>& each : samples)
        for (size_t i = 0; i < mean.size(); ++i)
            mean[i] += double(each[i]) / double(samples.size());
    return mean;
}

/// Returns the root mean square difference of the samples from the reference.
double spread(const std::vector<std::vector<float>>& samples, const std::vector<double>& from) {
    double sum = 0;
    for (const std::vector<float>& each : samples)
        for (size_t i = 0; i < from.size(); ++i)
            sum += (double(each[i]) - from[i]) * (double(each[i]) - from[i]);
    return std::sqrt(sum / double(samples.size() * from.size()));
}

double meanDifference(const std::vector<std::vector<float>>& samples, const std::vector<double>& from) {
    double sum = 0;
    for (const std::vector<float>& each : samples)
        for (size_t i = 0; i < from.size(); ++i)
            sum += std::abs(double(each[i]) - from[i]);
    return sum / double(samples.size() * from.size());
}

} // namespace

TEST_CASE("antialiased highlights vary less over a pixel, and differ less from the picture of 64 samples") {
    const RippledSheet sheet;
    const MaterialLooks looks;
    LookParameters look = test::roomOnly(0.2f);
    look.dullness = 0;
    look.exposure = 0.02f; // below the tone curve's knee, so that light is compared
    look.detail = kHighDetail;
    const SceneView scene = sheet.scene(looks);
    look.leftOut = bitOf(DetailFeature::calmHighlights);
    const std::vector<double> reference = meanOf(sampledEverywhere(scene, look, 8));
    const auto plain = sampledEverywhere(scene, look, 4);
    look.leftOut = 0;
    const auto calm = sampledEverywhere(scene, look, 4);
    const double plainSpread = spread(plain, meanOf(plain)), calmSpread = spread(calm, meanOf(calm));
    const double plainFar = meanDifference(plain, reference), calmFar = meanDifference(calm, reference);
    INFO("spread " << plainSpread << " -> " << calmSpread << ", mean difference " << plainFar << " -> " << calmFar);
    CHECK(plainSpread > 0.1 * reference.front()); // the plain picture has a difference to reduce
    CHECK(calmSpread < 0.8 * plainSpread);
    CHECK(calmFar < 0.95 * plainFar);
    look.detail = kLowDetail; // low detail has no antialiasing
    const auto low = sampled(scene, look, {0, 0});
    look.leftOut = bitOf(DetailFeature::calmHighlights);
    CHECK(low == sampled(scene, look, {0, 0}));
}

} // namespace meltpool
