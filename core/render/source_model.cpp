#include "core/render/source_model.hpp"

#include <algorithm>

namespace meltpool {

namespace {

constexpr glm::vec3 kBrass(0.58f, 0.44f, 0.17f);
constexpr glm::vec3 kDarkSteel(0.10f, 0.105f, 0.11f);
constexpr glm::vec3 kFlameGlow(0.7f, 1.5f, 3.4f);
constexpr glm::vec3 kColdGlow(1.0f, 1.3f, 1.5f);
constexpr glm::vec3 kPlume(0.10f, 0.26f, 0.90f), kOuter(0.85f, 0.32f, 0.06f), kColdPlume(0.55f, 0.80f, 0.92f);
constexpr glm::vec3 kLine(0.75f, 0.78f, 0.80f);
constexpr glm::vec3 kUp{0, 1, 0};
constexpr float kFloor = -1; ///< model units, the box's lower face

// Lengths in reaches of the heat, along the flame's axis from its hottest place.
constexpr float kMouth = 0.42f, kPlumeEnd = -0.45f, kOuterEnd = -0.9f;
// Lengths in model units.
constexpr float kNozzle = 0.20f, kPipe = 0.30f, kPilot = 0.06f;

class Builder {
  public:
    Builder(SourceModel& model, const glm::vec3& hottest, const glm::mat4& toWorld)
        : model_(model), hottest_(hottest), toWorld_(toWorld) {}

    void solid(SolidShape shape, float from, float to, float width, const glm::vec3& colour, float gloss,
               const glm::vec3& glow = glm::vec3(0)) {
        model_.solids.push_back({shape, placed(from, to, width), colour, gloss, glow});
    }
    void marker(SolidShape shape, float from, float to, float width, const glm::vec3& colour, float opacity,
                float face) {
        model_.markers.push_back({shape, placed(from, to, width), colour, opacity, face});
    }

  private:
    glm::mat4 placed(float from, float to, float width) const {
        return toWorld_ * alongLine(hottest_ + kUp * from, hottest_ + kUp * to, width);
    }

    SourceModel& model_;
    glm::vec3 hottest_;
    const glm::mat4& toWorld_;
};

} // namespace

void buildSource(SourceModel& model, const SourceView& source, const glm::mat4& modelToWorld) {
    model.solids.clear();
    model.markers.clear();
    Builder add(model, source.position, modelToWorld);
    const float reach = source.reach, mouth = kMouth * reach, width = std::min(0.35f * reach, 0.16f);
    add.solid(SolidShape::taper, mouth + kNozzle, mouth, width, kBrass, 0.6f);
    add.solid(SolidShape::cylinder, mouth + kNozzle + kPipe, mouth + kNozzle, 0.6f * width, kDarkSteel, 0.4f);
    const glm::vec3& glow = source.cold ? kColdGlow : kFlameGlow;
    add.solid(SolidShape::cone, mouth, source.on ? 0 : mouth - kPilot, (source.on ? 0.7f : 0.35f) * width, glm::vec3(0),
              0, source.on ? glow : 0.4f * glow);
    const float line = kFloor - source.position.y;
    if (line < 0) add.marker(SolidShape::cylinder, 0, line, 0.006f, kLine, 0.4f, 1);
    if (!source.on) return;
    add.marker(SolidShape::cone, mouth, kOuterEnd * reach, 1.25f * width, source.cold ? kColdPlume : kOuter, 0.28f,
               0.5f);
    add.marker(SolidShape::cone, mouth, kPlumeEnd * reach, width, source.cold ? kColdPlume : kPlume, 0.5f, 0.6f);
}

} // namespace meltpool
