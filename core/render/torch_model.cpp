#include "core/render/torch_model.hpp"

#include "core/render/look/heat_colours.hpp"

#include <glm/ext/matrix_transform.hpp>

#include <numbers>

namespace meltpool {

namespace {

constexpr glm::vec3 kDarkSteel(0.10F, 0.105F, 0.11F);
constexpr glm::vec3 kCopper(0.62F, 0.29F, 0.17F);
constexpr glm::vec3 kBrass(0.58F, 0.44F, 0.17F);
constexpr glm::vec3 kCeramic(0.55F, 0.30F, 0.24F);
constexpr glm::vec3 kTungsten(0.35F, 0.35F, 0.36F);
constexpr glm::vec3 kArcColour(0.93F, 1.0F, 1.25F);
constexpr float kLumenPerWatt = 5;

/// The drawn arc: a ball in front of the tip.
struct ArcBall {
    float distance; ///< of its centre from the tip, m
    float diameter; ///< m
};
constexpr ArcBall kGmawArc{0.0010F, 0.0028F};
constexpr ArcBall kTigArc{0.0008F, 0.0030F};
constexpr glm::vec3 kFlameGlow(0.5F, 1.2F, 3.0F);

/// Adds solids along the torch's axis. Distances from the tip in m, positive towards the handle.
class Builder {
  public:
    Builder(std::vector<Solid>& solids, const TorchSample& torch, const glm::mat4& toWorld)
        : solids_(solids), torch_(torch), toWorld_(toWorld) {}

    void part(SolidShape shape, float from, float to, float width, const glm::vec3& colour, float gloss,
              const glm::vec3& glow = glm::vec3(0.0F)) {
        solids_.push_back({shape, toWorld_ * alongLine(at(from), at(to), width), colour, gloss, glow});
    }

    /// A ball whose disc emits all light of the arc evenly.
    void arc(const ArcBall& ball, const ArcLight& light) {
        const glm::mat4 place = glm::scale(glm::translate(glm::mat4(1.0F), light.position), glm::vec3(ball.diameter));
        const float disc = std::numbers::pi_v<float> / 4 * ball.diameter * ball.diameter;
        solids_.push_back({SolidShape::sphere, toWorld_ * place, glm::vec3(0.0F), 0.0F, light.intensity / disc});
    }

  private:
    glm::vec3 at(float distance) const { return torch_.tip - torch_.axis() * distance; }

    std::vector<Solid>& solids_;
    const TorchSample& torch_;
    const glm::mat4& toWorld_;
};

/// The tip of the pose is the end of the wire.
void addGmaw(Builder& add, const ArcLight& light) {
    constexpr float kStickOut = 0.010F;
    add.part(SolidShape::cylinder, kStickOut, 0.0F, 0.0012F, kCopper, 0.8F);
    add.part(SolidShape::cylinder, kStickOut + 0.012F, kStickOut, 0.006F, kCopper, 0.7F);
    add.part(SolidShape::cylinder, kStickOut + 0.05F, kStickOut + 0.003F, 0.014F, kBrass, 0.85F);
    add.part(SolidShape::cylinder, kStickOut + 0.10F, kStickOut + 0.048F, 0.012F, kDarkSteel, 0.4F);
    if (light.intensity.g > 0) add.arc(kGmawArc, light);
}

/// The tip of the pose is that of the electrode.
void addTig(Builder& add, const ArcLight& light) {
    add.part(SolidShape::cone, 0.004F, 0.0F, 0.0024F, kTungsten, 0.7F);
    add.part(SolidShape::cylinder, 0.010F, 0.004F, 0.0024F, kTungsten, 0.7F);
    add.part(SolidShape::cylinder, 0.038F, 0.006F, 0.012F, kCeramic, 0.3F);
    add.part(SolidShape::cylinder, 0.09F, 0.036F, 0.016F, kDarkSteel, 0.4F);
    if (light.intensity.g > 0) add.arc(kTigArc, light);
}

/// The tip of the pose is where the flame is hottest, in front of the burner's nozzle.
void addFlame(Builder& add, float trigger) {
    constexpr float kNozzle = 0.012F;
    add.part(SolidShape::cylinder, kNozzle + 0.03F, kNozzle, 0.009F, kBrass, 0.6F);
    add.part(SolidShape::cylinder, kNozzle + 0.08F, kNozzle + 0.028F, 0.006F, kDarkSteel, 0.4F);
    if (trigger > 0) add.part(SolidShape::cone, kNozzle, 0.0F, 0.005F, glm::vec3(0.0F), 0.0F, kFlameGlow * trigger);
}

void addIron(Builder& add) {
    add.part(SolidShape::cone, 0.012F, 0.0F, 0.005F, kCopper, 0.7F);
    add.part(SolidShape::cylinder, 0.05F, 0.012F, 0.005F, kTungsten, 0.6F);
    add.part(SolidShape::cylinder, 0.12F, 0.05F, 0.018F, kDarkSteel, 0.3F);
}

} // namespace

ArcLight torchArcLight(const TorchSample& torch, const ProcessParameters& process) {
    const auto kind = static_cast<ProcessKind>(process.kind);
    if (torch.trigger <= 0 || (kind != ProcessKind::Gmaw && kind != ProcessKind::Tig)) return {};
    const ArcBall& ball = kind == ProcessKind::Gmaw ? kGmawArc : kTigArc;
    const float candela =
        kLumenPerWatt * process.voltage * process.current * torch.trigger / (4 * std::numbers::pi_v<float>);
    return {torch.tip + torch.axis() * ball.distance, kArcColour * (candela / static_cast<float>(kPaperLuminance)),
            ball.diameter / 2};
}

void buildTorchModel(std::vector<Solid>& solids, const TorchSample& torch, const ProcessParameters& process,
                     const glm::mat4& workpieceToWorld) {
    solids.clear();
    Builder add(solids, torch, workpieceToWorld);
    switch (static_cast<ProcessKind>(process.kind)) {
    case ProcessKind::Gmaw:
        return addGmaw(add, torchArcLight(torch, process));
    case ProcessKind::Tig:
        return addTig(add, torchArcLight(torch, process));
    case ProcessKind::Flame:
        return addFlame(add, torch.trigger);
    case ProcessKind::Iron:
        return addIron(add);
    }
}

} // namespace meltpool
