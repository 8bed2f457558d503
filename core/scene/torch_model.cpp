#include "core/scene/torch_model.hpp"

#include "core/render/look/heat_colours.hpp"

#include <glm/ext/matrix_transform.hpp>

#include <algorithm>
#include <numbers>

namespace meltpool {

namespace {

constexpr glm::vec3 kDarkSteel(0.10F, 0.105F, 0.11F);
constexpr glm::vec3 kCopper(0.62F, 0.29F, 0.17F);
constexpr glm::vec3 kBrass(0.58F, 0.44F, 0.17F);
constexpr glm::vec3 kCeramic(0.55F, 0.30F, 0.24F);
constexpr glm::vec3 kTungsten(0.35F, 0.35F, 0.36F);
constexpr glm::vec3 kSteelWire(0.42F, 0.41F, 0.40F);
constexpr glm::vec3 kCovered(0.36F, 0.33F, 0.30F);
constexpr glm::vec3 kHotBall(6.0F, 2.2F, 0.5F);
constexpr glm::vec3 kArcColour(0.93F, 1.0F, 1.25F);
constexpr float kLumenPerWatt = 5;

/// Diameter (m) of the drawn arc's core, a ball in the middle of the arc.
constexpr float kArcDiameter = 0.0029F;
/// m; an arc shorter than this is drawn in a gap of this length, as the wire's end is a drop.
constexpr float kShortestShown = 0.0016F;
constexpr glm::vec3 kFlameGlow(0.5F, 1.2F, 3.0F);

/// Builder of solids along the torch's axis. Distances in m from the tip, towards the handle positive.
class Builder {
  public:
    Builder(std::vector<Solid>& solids, const TorchSample& torch, const glm::mat4& toWorld)
        : solids_(solids), torch_(torch), toWorld_(toWorld) {}

    void part(SolidShape shape, float from, float to, float width, const glm::vec3& colour, float gloss,
              const glm::vec3& glow = glm::vec3(0.0F)) {
        solids_.push_back({shape, toWorld_ * alongLine(at(from), at(to), width), colour, gloss, glow});
    }
    /// Adds a coarse part that replaces those of buildTorchFittings().
    void coarse(float from, float to, float width, const glm::vec3& colour, float gloss) {
        part(SolidShape::cylinder, from, to, width, colour, gloss);
        solids_.back().coarse = true;
    }

    /// Adds a ball that shines evenly over its disc with the arc's whole light.
    void arc(const ArcLight& light) {
        if (light.intensity.g <= 0) return;
        const glm::mat4 place = glm::scale(glm::translate(glm::mat4(1.0F), light.position), glm::vec3(kArcDiameter));
        const float disc = std::numbers::pi_v<float> / 4 * kArcDiameter * kArcDiameter;
        solids_.push_back({SolidShape::sphere, toWorld_ * place, glm::vec3(0.0F), 0.0F, light.intensity / disc});
    }

  private:
    glm::vec3 at(float distance) const { return torch_.tip - torch_.axis() * distance; }

    std::vector<Solid>& solids_;
    const TorchSample& torch_;
    const glm::mat4& toWorld_;
};

/// Adds a wire torch: the contact tip is at the set stick-out behind the pose's tip; the wire has its present
/// extension.
void addWireTorch(Builder& add, float stickOut, float extension, float diameter, const ArcLight& light) {
    add.part(SolidShape::cylinder, stickOut, stickOut - extension, diameter, kCopper, 0.8F);
    add.coarse(stickOut + 0.012F, stickOut, 0.006F, kCopper, 0.7F);
    add.coarse(stickOut + 0.05F, stickOut + 0.003F, 0.014F, kBrass, 0.85F);
    add.coarse(stickOut + 0.10F, stickOut + 0.048F, 0.012F, kDarkSteel, 0.4F);
    add.arc(light);
}

/// Adds a tungsten torch: the tip of the pose is that of the electrode.
void addTungstenTorch(Builder& add, const ArcLight& light) {
    add.part(SolidShape::cone, 0.004F, 0.0F, 0.0024F, kTungsten, 0.7F);
    add.part(SolidShape::cylinder, 0.010F, 0.004F, 0.0024F, kTungsten, 0.7F);
    add.coarse(0.038F, 0.006F, 0.012F, kCeramic, 0.3F);
    add.coarse(0.09F, 0.036F, 0.016F, kDarkSteel, 0.4F);
    add.arc(light);
}

/// Adds the rod, whose end has melted back from the pose's tip by `eaten`; m.
void addRod(std::vector<Solid>& solids, const RodSample& rod, float diameter, const ArcState& arc,
            const glm::mat4& toWorld) {
    constexpr float kShown = 0.3F;
    const glm::vec3 axis = rod.axis();
    const glm::vec3 end = rod.tip - axis * arc.rodEaten;
    solids.push_back({SolidShape::cylinder, toWorld * alongLine(end - axis * kShown, end, diameter), kSteelWire, 0.6F});
    if (arc.rodBall <= 0) return;
    const glm::mat4 ball = glm::scale(glm::translate(glm::mat4(1.0F), end), glm::vec3(arc.rodBall));
    solids.push_back({SolidShape::sphere, toWorld * ball, kSteelWire, 0.8F, kHotBall});
}

/// Adds an electrode holder: the rest of the electrode reaches from the holder to its end; its covering ends a little
/// before its core.
void addElectrodeHolder(Builder& add, float whole, float core, float left, const ArcLight& light) {
    const float burnt = whole - left;
    constexpr float kHeld = 0.025F, kCovering = 1.7F;
    add.part(SolidShape::cylinder, whole, burnt, core, kTungsten, 0.6F);
    add.part(SolidShape::cylinder, whole - kHeld, burnt + core / 2, core * kCovering, kCovered, 0.15F);
    add.coarse(whole + 0.03F, whole - 0.02F, 0.022F, kDarkSteel, 0.3F);
    add.coarse(whole + 0.16F, whole + 0.03F, 0.028F, kDarkSteel, 0.2F);
    add.arc(light);
}

/// Adds a burner: the tip of the pose is the hottest place of the flame, in front of the burner's nozzle.
void addBurner(Builder& add, float share) {
    constexpr float kNozzle = 0.012F;
    add.coarse(kNozzle + 0.03F, kNozzle, 0.009F, kBrass, 0.6F);
    add.coarse(kNozzle + 0.08F, kNozzle + 0.028F, 0.006F, kDarkSteel, 0.4F);
    if (share > 0) add.part(SolidShape::cone, kNozzle, 0.0F, 0.005F, glm::vec3(0.0F), 0.0F, kFlameGlow * share);
}

void addIron(Builder& add) {
    add.part(SolidShape::cone, 0.012F, 0.0F, 0.005F, kCopper, 0.7F);
    add.coarse(0.05F, 0.012F, 0.005F, kTungsten, 0.6F);
    add.coarse(0.12F, 0.05F, 0.018F, kDarkSteel, 0.3F);
}

void addTorch(Builder& add, const ProcessSettings& process, const ArcState& arc, const ArcLight& light) {
    const Equipment tools = equipmentOf(process);
    // Before the first step wire and electrode have their set lengths.
    const auto left = [&](double set) { return arc.extension > 0 ? arc.extension : static_cast<float>(set); };
    switch (traitsOf(process).torch) {
    case TorchShape::wireTorch:
        return addWireTorch(add, static_cast<float>(tools.heldBehind), left(tools.heldBehind),
                            static_cast<float>(tools.wire), light);
    case TorchShape::tungstenTorch:
        return addTungstenTorch(add, light);
    case TorchShape::electrodeHolder:
        return addElectrodeHolder(add, static_cast<float>(tools.electrodeLength), static_cast<float>(tools.electrode),
                                  left(tools.electrodeLength), light);
    case TorchShape::burner:
        return addBurner(add, arc.burns() ? arc.share : 0);
    case TorchShape::iron:
        return addIron(add);
    }
}

} // namespace

ArcLight torchArcLight(const TorchSample& torch, const ProcessSettings& process, const ArcState& arc) {
    if (!arc.burns() || arc.current <= 0) return {};
    const float candela = kLumenPerWatt * arc.voltage * arc.current / (4 * std::numbers::pi_v<float>);
    // The arc is between the wire's or electrode's end and the metal.
    const Equipment tools = equipmentOf(process);
    const float back = tools.electrodeLength > 0 ? static_cast<float>(tools.electrodeLength) - arc.extension
                                                 : static_cast<float>(tools.heldBehind);
    const float middle = arc.distance - std::max(arc.length, kShortestShown) / 2;
    return {torch.tip + torch.axis() * (middle - back), kArcColour * (candela / static_cast<float>(kPaperLuminance)),
            kArcDiameter / 2};
}

size_t buildTorchModel(std::vector<Solid>& solids, const TorchSample& torch, const ProcessSettings& process,
                       const ArcState& arc, const glm::mat4& workpieceToWorld) {
    solids.clear();
    Builder add(solids, torch, workpieceToWorld);
    addTorch(add, process, arc, torchArcLight(torch, process, arc));
    const size_t own = solids.size();
    if (torch.rod && holdsRod(process))
        addRod(solids, *torch.rod, static_cast<float>(rodDiameter(process)), arc, workpieceToWorld);
    return solids.size() - own;
}

} // namespace meltpool
