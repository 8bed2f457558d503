#include "tests/render/synthetic_weld.hpp"

#include "shaders/shared/surface.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace meltpool::test {

namespace {

constexpr double kPower = 1500, kConductivity = 30, kDiffusivity = 6e-6, kSpeed = 0.005, kAmbient = 293;
constexpr double kSolidus = 1768, kLiquidus = 1813;
constexpr double kSourceX = 0.015; // the pool's place on the plate, m
constexpr double kLength = 0.08, kWidth = 0.04, kThickness = 0.008;
constexpr double kSpacing = 0.0005;
constexpr int kAlong = int(kLength / kSpacing), kAcross = int(kWidth / kSpacing), kDown = int(kThickness / kSpacing);

/// Returns the height of the bead over the plate: a low arch over the molten area, with the ripples of its freezing.
double beadHeight(double x, double z) {
    const double behind = kSourceX - x;
    if (behind < -0.004 || std::abs(z) > 0.004) return 0;
    const double arch = 1 - (z / 0.004) * (z / 0.004);
    const double nose = std::clamp((behind + 0.004) / 0.006, 0.0, 1.0);
    const double ripple = behind > 0.006 ? 0.00006 * std::sin(6283 * (behind + 400 * z * z) / 1.2) : 0;
    return arch * nose * 0.0016 + arch * ripple;
}

glm::dvec3 surfacePoint(double x, double z) {
    return {x, beadHeight(x, z), z};
}

/// Returns the freezing time; behind the pool the edges freeze before the middle.
SurfaceFreezing freezingAt(double x, double z) {
    return {glm::dvec3(1 / kSpeed, 0, -600 * z / kSpeed), static_cast<float>(20 + (x - 300 * z * z) / kSpeed)};
}

constexpr int kLayers = 12; ///< layers of the cut slab

/// Returns particles where the section cuts: a slab across the seam, behind the pool. w: temperature.
std::vector<glm::vec4> particlesOfSlab() {
    std::vector<glm::vec4> particles;
    for (int i = -kLayers / 2; i < kLayers / 2; ++i)
        for (int j = 0; j <= kAcross; ++j)
            for (int k = -4; k <= kDown; ++k) {
                const double x = -0.01 + (i + 0.5) * kSpacing, z = j * kSpacing - kWidth / 2, y = -(k + 0.5) * kSpacing;
                if (y > beadHeight(x, z)) continue;
                particles.emplace_back(x, y, z, weldTemperature({x - kSourceX, std::max(-y, 0.0), z}));
            }
    return particles;
}

} // namespace

double weldTemperature(const glm::dvec3& at) {
    constexpr double kPi = 3.14159265358979;
    const double r = std::max(glm::length(at), 1e-4);
    const double rise = kPower / (2 * kPi * kConductivity * r) * std::exp(-kSpeed * (at.x + r) / (2 * kDiffusivity));
    return std::min(kAmbient + rise, 2700.0);
}

double weldPeak(double behind, double aside, double deep) {
    double peak = kAmbient;
    for (double x = -behind; x < 0.02; x += 0.0005)
        peak = std::max(peak, weldTemperature({x, deep, aside}));
    return peak;
}

SyntheticWeld::SyntheticWeld() {
    std::vector<SurfaceVertex> vertices;
    std::vector<float> peaks;
    std::vector<SurfaceFreezing> freezing;
    for (int i = 0; i <= kAlong; ++i)
        for (int j = 0; j <= kAcross; ++j) {
            const double x = i * kSpacing - kLength / 2, z = j * kSpacing - kWidth / 2;
            constexpr double step = 1e-4;
            const glm::dvec3 normal = glm::normalize(glm::cross(surfacePoint(x, z + step) - surfacePoint(x, z - step),
                                                                surfacePoint(x + step, z) - surfacePoint(x - step, z)));
            const double temperature = weldTemperature({x - kSourceX, 0, z}), peak = weldPeak(kSourceX - x, z, 0);
            const bool frozen = peak > kLiquidus && temperature < kSolidus;
            vertices.push_back({surfacePoint(x, z), static_cast<float>(temperature), normal, frozen ? 1.0f : 0.0f});
            peaks.push_back(static_cast<float>(peak));
            freezing.push_back(frozen ? freezingAt(x, z) : SurfaceFreezing{});
        }
    std::vector<GLuint> indices;
    constexpr GLuint row = kAcross + 1;
    for (GLuint i = 0; i < kAlong; ++i)
        for (GLuint j = 0; j < kAcross; ++j) {
            const GLuint a = i * row + j;
            indices.insert(indices.end(), {a, a + 1, a + row + 1, a, a + row + 1, a + row});
        }
    const std::vector<glm::vec4> particles = particlesOfSlab();
    const SurfaceDraw draw{static_cast<uint>(indices.size()), 1, 0, 0, 0};
    vertices_ = gl::Buffer("weld vertices", std::span<const SurfaceVertex>(vertices));
    indices_ = gl::Buffer("weld indices", std::span<const GLuint>(indices));
    peaks_ = gl::Buffer("weld peaks", std::span<const float>(peaks));
    freezing_ = gl::Buffer("weld freezing", std::span<const SurfaceFreezing>(freezing));
    command_ = gl::Buffer("weld draw command", sizeof draw);
    command_.writeValue(draw);
    particles_ = gl::Buffer("weld particles", std::span<const glm::vec4>(particles));
    particleCount_ = particles.size();
    looks_.heatTint = 1;
}

SectionMap SyntheticWeld::map() const {
    std::vector<MapParticle> all;
    for (const glm::vec4& p : particlesOfSlab()) {
        const double peak = weldPeak(kSourceX - double(p.x), double(p.z), std::max(-double(p.y), 0.0));
        all.push_back({{p.z, p.y}, static_cast<float>(peak), p.w});
    }
    return makeSectionMap({-0.02f, -0.008f}, {0.04f, 0.018f}, static_cast<float>(kSpacing), kLayers, all);
}

SceneView SyntheticWeld::view() const {
    SceneView scene;
    scene.mesh = {.vertices = &vertices_, .indices = &indices_, .drawCommand = &command_, .peaks = &peaks_};
    scene.particles.positions = &particles_;
    scene.particles.count = particleCount_;
    scene.temperature = {.coldest = 293, .hottest = 2000, .kelvin = true, .solidus = kSolidus, .liquidus = kLiquidus};
    scene.looks = &looks_;
    scene.boxMin = {-0.04f, -0.008f, -0.02f};
    scene.boxMax = {0.04f, 0.01f, 0.02f};
    return scene;
}

SceneView SyntheticWeld::rippledView() const {
    SceneView scene = view();
    scene.mesh.freezing = &freezing_;
    return scene;
}

} // namespace meltpool::test
