#include "core/scene/torch_fittings.hpp"

#include "core/scene/gloved_hand.hpp"
#include "core/scene/torch_geometry.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr glm::vec3 kDarkSteel(0.10f, 0.105f, 0.11f);
constexpr glm::vec3 kCopper(0.62f, 0.29f, 0.17f);
constexpr glm::vec3 kBrass(0.58f, 0.44f, 0.17f);
constexpr glm::vec3 kCeramic(0.62f, 0.36f, 0.28f);
constexpr glm::vec3 kSteel(0.42f, 0.42f, 0.43f);
constexpr glm::vec3 kRubber(0.022f, 0.022f, 0.025f);
constexpr glm::vec3 kGripBlue(0.02f, 0.05f, 0.13f);
constexpr glm::vec3 kSafetyRed(0.50f, 0.03f, 0.02f);
constexpr glm::vec3 kHose(0.22f, 0.03f, 0.02f);

constexpr float kCableWidth = 0.018f; ///< m

glm::vec3 acrossTo(const glm::vec3& axis, const glm::vec3& wanted, const glm::vec3& otherwise) {
    glm::vec3 across = wanted - axis * glm::dot(axis, wanted);
    if (glm::length(across) < 1e-3f) across = otherwise - axis * glm::dot(axis, otherwise);
    return glm::normalize(across);
}

/// Builder of the torch's solids. Distances in m from the tip, towards the handle positive.
class Builder {
  public:
    Builder(std::vector<Solid>& solids, const TorchSample& torch, const TorchGeometry& geometry,
            const TorchSurroundings& around, const glm::mat4& toWorld)
        : solids_(solids), torch_(torch), geometry_(geometry), around_(around), toWorld_(toWorld) {
        towards_ = way_ = handleWay(torch, geometry.bend, around.rightHand);
        if (around.hand) followHand(around.hand->place);
        begin_ = bent() + way_ * lead_;
    }

    glm::vec3 at(float distance) const {
        const float part = distance - geometry_.reach;
        return torch_.tip - torch_.axis() * (part > 0 && shrink_ < 1 ? geometry_.reach + shrink_ * part : distance);
    }
    /// Unit vector along the handle, away from the work.
    const glm::vec3& way() const { return way_; }
    const glm::vec3& begin() const { return begin_; }
    /// Returns the end of the bend.
    glm::vec3 bent() const {
        const glm::vec3 corner = at(geometry_.neck);
        if (!round_) return corner;
        const glm::vec3 z = -torch_.axis(), x = acrossTo(z, towards_, {1, 0, 0});
        return corner + geometry_.bendRadius * (x * (1 - std::cos(kBendAngle)) + z * std::sin(kBendAngle));
    }

    void rod(const glm::vec3& from, const glm::vec3& to, float width, const glm::vec3& colour, float gloss,
             SolidShape shape = SolidShape::cylinder) {
        solids_.push_back({shape, toWorld_ * alongLine(from, to, width), colour, gloss});
    }
    void part(float from, float to, float width, const glm::vec3& colour, float gloss,
              SolidShape shape = SolidShape::cylinder) {
        rod(at(from), at(to), width, colour, gloss, shape);
    }

    /// Adds the round neck that leads to the way of the handle, or the corner in its place.
    void bend(const glm::vec3& colour, float gloss) {
        const float width = geometry_.bendRadius / kBendRadius;
        if (!round_) {
            solids_.push_back({SolidShape::sphere, toWorld_ * boxAt(bent(), glm::vec3(width)), colour, gloss});
            return;
        }
        const glm::vec3 z = -torch_.axis(), x = acrossTo(z, towards_, {1, 0, 0}), y = glm::cross(z, x);
        const glm::mat4 place{glm::vec4(x * width, 0), glm::vec4(y * width, 0), glm::vec4(z * width, 0),
                              glm::vec4(at(geometry_.neck), 1)};
        solids_.push_back({SolidShape::bend, toWorld_ * place, colour, gloss});
    }

    /// Adds the handle, and the hand round it; returns its end.
    glm::vec3 handle(const glm::vec3& colour) {
        const float held = around_.hand ? glm::dot(around_.hand->place - begin_, way_) : geometry_.held();
        const float width = geometry_.handleWidth;
        const glm::vec3 end = begin_ + way_ * std::max(geometry_.handle, held + 0.06f);
        rod(end, begin_, width, colour, 0.25f, SolidShape::pill);
        rod(begin_ + way_ * 0.018f, begin_ + way_ * 0.006f, width * 1.06f, kDarkSteel, 0.4f);
        if (around_.hand)
            addGlovedHand(solids_, gripOf(*around_.hand, way_, torch_.tip, 0.5f * width), toWorld_);
        else
            hand(begin_ + way_ * held, way_, 0.5f * width, around_.rightHand);
        return end;
    }

    /// Adds a hand round a rod there; `way` leads away from the work.
    void hand(const glm::vec3& middle, const glm::vec3& way, float radius, bool right) {
        const glm::vec3 toWelder(0, 0, 1);
        const glm::vec3 palm = acrossTo(way, around_.up + 0.7f * toWelder, {1, 0, 0});
        const glm::vec3 arm = glm::normalize(way + 0.9f * toWelder + 0.1f * around_.up);
        addGlovedHand(solids_, {middle, way, palm, arm, radius, right}, toWorld_);
    }

    /// Adds a cable that leaves the handle along `way` and hangs over an edge to its end.
    void cable(const glm::vec3& from, const glm::vec3& way, float width, const glm::vec3& colour) {
        constexpr int kPieces = 16;
        const float reach = std::max(0.3f * glm::distance(from, around_.cableEnd), 0.08f);
        const glm::vec3 leaves = from + way * reach, comes = around_.cableEnd + around_.up * 0.42f;
        const auto place = [&](int step) {
            const float t = static_cast<float>(step) / kPieces, s = 1 - t;
            return s * s * s * from + 3 * s * s * t * leaves + 3 * s * t * t * comes + t * t * t * around_.cableEnd;
        };
        for (int step = 0; step < kPieces; ++step) {
            const glm::vec3 a = place(step), b = place(step + 1);
            const glm::vec3 more = glm::normalize(b - a) * (0.5f * width); // pieces reach into each other
            rod(a - more, b + more, width, colour, 0.15f, SolidShape::pill);
        }
    }

  private:
    /// Turns neck and handle to a hand at `place`.
    void followHand(const glm::vec3& place) {
        constexpr float kShortest = 0.3f;        // share of the neck that a measured tip leaves at least
        constexpr float kNearlyStraight = 0.87f; // cosine of the way to the hand with the axis
        const glm::vec3 back = -torch_.axis();
        const float behind = glm::dot(place - torch_.tip, back);
        const float bent = geometry_.neck + geometry_.bendRadius * std::sin(geometry_.bend);
        if (behind < bent && bent > geometry_.reach)
            shrink_ = std::clamp((behind - geometry_.reach) / (bent - geometry_.reach), kShortest, 1.0f);
        towards_ = place - at(geometry_.neck);
        const bool straight = glm::dot(towards_, back) > kNearlyStraight * glm::length(towards_);
        round_ = round_ && shrink_ == 1 && !straight;
        const glm::vec3 toHand = place - this->bent();
        const float far = glm::length(toHand);
        const bool backwards = glm::dot(toHand, back) < -0.3f * far;
        way_ = backwards || far < 1e-3f ? back : toHand / far;
        lead_ = std::clamp(far - kPalm, 0.0f, geometry_.lead);
    }

    static constexpr float kPalm = 0.05f; ///< m of handle before the middle of the hand, at least

    std::vector<Solid>& solids_;
    const TorchSample& torch_;
    const TorchGeometry& geometry_;
    const TorchSurroundings& around_;
    const glm::mat4& toWorld_;
    glm::vec3 towards_{0.0f}; ///< direction to which the neck turns
    glm::vec3 way_{0.0f};
    glm::vec3 begin_{0.0f};                 ///< beginning of the handle
    float lead_ = geometry_.lead;           ///< m, from the end of the bend to there
    float shrink_ = 1;                      ///< share of its length with which the torch is drawn
    bool round_ = geometry_.bendRadius > 0; ///< the neck is bent, not a corner
};

void addWireTorch(Builder& add, float stickOut) {
    const glm::vec3 way = add.way(), begin = add.begin();
    add.part(stickOut + 0.012f, stickOut + 0.002f, 0.0075f, kCopper, 0.6f);
    add.part(stickOut + 0.026f, stickOut + 0.012f, 0.0085f, kBrass, 0.7f);                   // tip holder
    add.part(stickOut + 0.045f, stickOut + 0.003f, 0.0175f, kBrass, 0.75f, SolidShape::cup); // gas nozzle
    add.part(stickOut + 0.066f, stickOut + 0.044f, 0.0175f, kBrass, 0.75f, SolidShape::tube);
    add.part(stickOut + 0.076f, stickOut + 0.063f, 0.0160f, kRubber, 0.3f); // insulator
    add.part(stickOut + 0.086f, stickOut + 0.074f, 0.0125f, kDarkSteel, 0.4f);
    add.bend(kDarkSteel, 0.45f);
    add.rod(begin, add.bent(), 0.0125f, kDarkSteel, 0.45f);
    const glm::vec3 end = add.handle(kGripBlue);
    add.rod(begin + way * 0.075f, begin + way * 0.045f, 0.0336f, kSafetyRed, 0.4f, SolidShape::pill); // trigger
    add.cable(end - way * 0.01f, way, kCableWidth, kRubber);
}

void addTungstenTorch(Builder& add) {
    const glm::vec3 way = add.way();
    add.part(0.034f, 0.006f, 0.0165f, kCeramic, 0.35f, SolidShape::cup);
    add.part(0.032f, 0.010f, 0.0036f, kSteel, 0.5f); // collet
    add.part(0.038f, 0.032f, 0.0150f, kBrass, 0.6f);
    add.part(0.070f, 0.037f, 0.0200f, kRubber, 0.25f); // head
    add.part(0.074f, 0.069f, 0.0165f, kDarkSteel, 0.3f);
    add.part(0.112f, 0.068f, 0.0140f, kRubber, 0.3f, SolidShape::pill); // back cap
    add.rod(add.begin() + way * 0.01f, add.bent(), 0.0150f, kRubber, 0.25f);
    const glm::vec3 end = add.handle(kGripBlue);
    add.cable(end - way * 0.01f, way, 0.016f, kRubber);
}

void addElectrodeHolder(Builder& add, const TorchSample& torch, float whole) {
    const glm::vec3 way = add.way(), grip = add.bent();
    const glm::vec3 across = glm::normalize(glm::cross(way, acrossTo(way, torch.axis(), {1, 0, 0})));
    for (const float side : {-1.0f, 1.0f}) {
        const glm::vec3 off = across * (side * 0.0055f);
        add.rod(grip + way * 0.05f + off * 1.3f, grip - way * 0.012f + off, 0.011f, kBrass, 0.5f, SolidShape::pill);
    }
    add.rod(grip + way * 0.075f, grip + way * 0.028f, 0.034f, kSafetyRed, 0.2f, SolidShape::taper);
    const glm::vec3 lever = add.at(whole + 0.024f); // jaw lever
    add.rod(lever + way * 0.105f, lever + way * 0.035f, 0.012f, kSafetyRed, 0.2f, SolidShape::pill);
    const glm::vec3 end = add.handle(kRubber);
    add.cable(end - way * 0.01f, way, kCableWidth, kRubber);
}

void addBurner(Builder& add, const TorchSample& torch) {
    constexpr float kNozzle = 0.012f;
    const glm::vec3 way = add.way();
    add.part(kNozzle + 0.026f, kNozzle, 0.0105f, kBrass, 0.6f, SolidShape::cup);
    add.part(kNozzle + 0.036f, kNozzle + 0.024f, 0.0125f, kBrass, 0.6f);
    add.part(kNozzle + 0.080f, kNozzle + 0.034f, 0.0075f, kCopper, 0.6f);
    add.bend(kCopper, 0.6f);
    const glm::vec3 neck = add.begin() - way * 0.024f;
    add.rod(neck, add.bent(), 0.0075f, kCopper, 0.6f);
    add.rod(neck + way * 0.028f, neck - way * 0.004f, 0.018f, kBrass, 0.6f);
    const glm::vec3 side = glm::normalize(glm::cross(way, acrossTo(way, torch.axis(), {1, 0, 0}))),
                    valve = neck + way * 0.012f;
    add.rod(valve + side * 0.026f, valve, 0.007f, kBrass, 0.6f);
    add.rod(valve + side * 0.034f, valve + side * 0.022f, 0.019f, kSafetyRed, 0.3f); // valve knob
    const glm::vec3 end = add.handle(kDarkSteel);
    add.cable(end - way * 0.01f, way, 0.011f, kHose);
}

void addIron(Builder& add) {
    const glm::vec3 way = add.way();
    add.part(0.030f, 0.0115f, 0.0055f, kCopper, 0.5f);
    add.part(0.062f, 0.026f, 0.0085f, kSteel, 0.65f);
    add.part(0.068f, 0.060f, 0.0120f, kSteel, 0.6f);
    add.part(0.088f, 0.066f, 0.0200f, kRubber, 0.2f, SolidShape::taper);
    add.part(0.092f, 0.086f, 0.0280f, kRubber, 0.2f); // shield that protects the fingers from the heat
    const glm::vec3 end = add.handle(kGripBlue);
    add.cable(end - way * 0.01f, way, 0.006f, kRubber);
}

void addFittings(Builder& add, const TorchSample& torch, const ProcessSettings& process) {
    const Equipment tools = equipmentOf(process);
    switch (traitsOf(process).torch) {
    case TorchShape::wireTorch:
        return addWireTorch(add, static_cast<float>(tools.heldBehind));
    case TorchShape::tungstenTorch:
        return addTungstenTorch(add);
    case TorchShape::electrodeHolder:
        return addElectrodeHolder(add, torch, static_cast<float>(tools.electrodeLength));
    case TorchShape::burner:
        return addBurner(add, torch);
    case TorchShape::iron:
        return addIron(add);
    }
}

} // namespace

glm::vec3 handleWay(const TorchSample& torch, float angle, bool right) {
    const glm::vec3 back = -torch.axis();
    const glm::vec3 leans(back.x, 0, back.z);
    const glm::vec3 across = acrossTo(back, leans + glm::vec3(right ? 0.45f : -0.45f, 0, 0.2f), {0, 1, 0});
    return std::cos(angle) * back + std::sin(angle) * across;
}

void buildTorchFittings(std::vector<Solid>& solids, const TorchSample& torch, const ProcessSettings& process,
                        const TorchSurroundings& around, const glm::mat4& workpieceToWorld) {
    solids.clear();
    const TorchGeometry geometry = torchGeometry(process);
    Builder add(solids, torch, geometry, around, workpieceToWorld);
    addFittings(add, torch, process);
    if (!torch.rod || !holdsRod(process)) return;
    constexpr float kHeld = 0.20f; // m behind the rod's tip: far enough that the arc does not burn the glove
    const glm::vec3 back = -torch.rod->axis();
    add.hand(torch.rod->tip + back * kHeld, back, 0.004f, false);
}

} // namespace meltpool
