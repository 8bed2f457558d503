#include "core/render/look/mirror_shares.hpp"

#include "shaders/shared/render.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace meltpool {

namespace {

constexpr int kRings = 48, kAround = 24; ///< samples of half vectors. No source: chosen; errors stay below 0.005

/// Half vectors are drawn by the lobe's own density, so that all weigh alike but for the parts that geometry hides.
struct Sample {
    float weight;  ///< weight of this half vector
    float grazing; ///< Schlick's term
};

Sample sampleAt(float alpha, const glm::vec3& toEye, float part, float angle) {
    const float square = alpha * alpha;
    const float half = std::sqrt((1 - part) / (1 + (square - 1) * part));
    const float sine = std::sqrt(std::max(0.0f, 1 - half * half));
    const glm::vec3 middle(sine * std::cos(angle), sine * std::sin(angle), half);
    const float eyeHalf = glm::dot(toEye, middle);
    const float lamp = 2 * eyeHalf * middle.z - toEye.z;
    if (lamp <= 0 || eyeHalf <= 0) return {0, 0};
    const float hidden = (1 - alpha) * 2 * lamp * toEye.z + alpha * (lamp + toEye.z);
    return {2 * lamp * eyeHalf / (hidden * half), std::pow(1 - eyeHalf, 5.0f)};
}

} // namespace

glm::vec2 mirrorShares(float roughness, float cosine) {
    const float alpha = std::max(roughness * roughness, 1e-3f);
    const float eye = std::max(cosine, 1e-3f);
    const glm::vec3 toEye(std::sqrt(std::max(0.0f, 1 - eye * eye)), 0, eye);
    double straight = 0, grazing = 0;
    for (int ring = 0; ring < kRings; ++ring)
        for (int step = 0; step < kAround; ++step) {
            const auto angle = static_cast<float>(2 * std::numbers::pi * (step + 0.5) / kAround);
            const Sample sample = sampleAt(alpha, toEye, (static_cast<float>(ring) + 0.5f) / kRings, angle);
            straight += double(sample.weight) * (1 - double(sample.grazing));
            grazing += double(sample.weight) * double(sample.grazing);
        }
    return glm::vec2(glm::dvec2(straight, grazing) / double(kRings * kAround));
}

gl::Texture makeMirrorShareTexture() {
    std::vector<glm::vec2> texels;
    for (int row = 0; row < MIRROR_SHARE_SIZE; ++row)
        for (int column = 0; column < MIRROR_SHARE_SIZE; ++column)
            texels.push_back(mirrorShares(static_cast<float>(row) / (MIRROR_SHARE_SIZE - 1),
                                          static_cast<float>(column) / (MIRROR_SHARE_SIZE - 1)));
    gl::Texture texture("mirror shares", {.format = GL_RG16F, .width = MIRROR_SHARE_SIZE, .height = MIRROR_SHARE_SIZE});
    texture.setSampling(true);
    glTextureSubImage2D(texture.name(), 0, 0, 0, MIRROR_SHARE_SIZE, MIRROR_SHARE_SIZE, GL_RG, GL_FLOAT, texels.data());
    return texture;
}

} // namespace meltpool
