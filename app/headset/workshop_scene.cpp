#include "app/headset/workshop_scene.hpp"

#include "core/scene/gloved_hand.hpp"
#include "core/scene/torch_fittings.hpp"
#include "core/scene/torch_geometry.hpp"
#include "core/scene/torch_model.hpp"

#include <glm/gtc/matrix_transform.hpp>

namespace meltpool {

namespace {

constexpr size_t kMostSolids = 64;
constexpr glm::vec3 kDarkSteel(0.10f, 0.105f, 0.11f);
constexpr glm::vec3 kMat(0.035f, 0.035f, 0.04f);
constexpr glm::vec3 kTableSteel(0.12f, 0.12f, 0.125f);
constexpr glm::vec3 kSlotBlack(0.012f);
constexpr glm::vec3 kRubber(0.025f, 0.025f, 0.03f);
constexpr glm::vec3 kTorchCopper(0.62f, 0.29f, 0.17f);
constexpr glm::vec3 kBrass(0.58f, 0.44f, 0.17f);
constexpr glm::vec3 kSafetyRed(0.55f, 0.03f, 0.02f);
constexpr glm::vec3 kHeatGlow(2.4f, 1.7f, 0.9f);

/// Returns the end of the cable of a torch in this hand: a cable that crosses the table would cross the sight, too.
glm::vec3 cableEnd(const HeadsetParameters& parameters, bool right) {
    const glm::vec3 left = kCableEnd + glm::vec3(0, parameters.tableHeight, -Workshop::kTableBack);
    return {right ? -left.x : left.x, left.y, left.z};
}

} // namespace

WorkshopScene::WorkshopScene() {
    solids_.reserve(kMostSolids);
}

void WorkshopScene::add(SolidShape shape, const glm::mat4& toWorld, const glm::vec3& colour, float gloss,
                        const glm::vec3& glow) {
    solids_.push_back({shape, toWorld, colour, gloss, glow});
}

void WorkshopScene::addRoom(float tableHeight) {
    constexpr float kWidth = 1.2f, kDepth = 0.75f, kThickness = 0.03f, kLeg = 0.05f;
    constexpr float kBack = -Workshop::kTableBack;
    add(SolidShape::box, boxAt({0, -0.01f, 0.2f}, {2.6f, 0.02f, 2.2f}), kMat, 0.1f);
    add(SolidShape::box, boxAt({0, tableHeight - kThickness / 2, kBack}, {kWidth, kThickness, kDepth}), kTableSteel,
        0.3f);
    // The slots of a clamping table help to judge distances on it.
    constexpr float kSlot = 0.006f, kSpacing = 0.15f, kRaise = 0.0004f;
    for (int i = -3; i <= 3; ++i)
        add(SolidShape::box, boxAt({float(i) * kSpacing, tableHeight, kBack}, {kSlot, kRaise, kDepth - 0.06f}),
            kSlotBlack, 0);
    for (int i = -2; i <= 2; ++i)
        add(SolidShape::box, boxAt({0, tableHeight, kBack + float(i) * kSpacing}, {kWidth - 0.06f, kRaise, kSlot}),
            kSlotBlack, 0);
    const float legHeight = tableHeight - kThickness;
    for (const float x : {-1.0f, 1.0f})
        for (const float z : {-1.0f, 1.0f})
            add(SolidShape::box,
                boxAt({x * (kWidth / 2 - kLeg), legHeight / 2, kBack + z * (kDepth / 2 - kLeg)},
                      {kLeg, legHeight, kLeg}),
                kDarkSteel, 0.2f);
}

void WorkshopScene::addTorch(const HandsView& hands) {
    const xr::Pose& tip = hands.tip; // +z of the tip points back along the torch
    const auto along = [&](float z) { return tip * glm::vec3(0, 0, z + hands.burnt); };
    add(SolidShape::cone, alongLine(along(0.012f), along(0.0f), 0.006f), kTorchCopper, 0.7f);
    add(SolidShape::cylinder, alongLine(along(0.05f), along(0.012f), 0.016f), kBrass, 0.6f);
    add(SolidShape::cylinder, alongLine(along(kPlainTorch.neck), along(0.045f), 0.013f), kDarkSteel, 0.4f);
    addHandle(hands, kPlainTorch);
}

/// Adds a handle that runs from the neck through the hand, for any calibration.
void WorkshopScene::addHandle(const HandsView& hands, const TorchGeometry& torch) {
    const glm::vec3 neck = hands.tip * glm::vec3(0, 0, torch.neck + hands.burnt);
    add(SolidShape::sphere, boxAt(neck, glm::vec3(0.016f)), kDarkSteel, 0.4f);
    const glm::vec3 hand = hands.holder.hold.position;
    const glm::vec3 way =
        glm::length(hand - neck) > 0.01f ? glm::normalize(hand - neck) : hands.tip.orientation * glm::vec3(0, 0, 1);
    add(SolidShape::cylinder, alongLine(hand + way * 0.07f, neck, torch.handleWidth), kRubber, 0.25f);
    add(SolidShape::cylinder, alongLine(neck + way * 0.035f, neck + way * 0.02f, 0.029f), kSafetyRed, 0.4f);
}

void WorkshopScene::addGlow(const HandsView& hands) {
    if (hands.heat > 0)
        add(SolidShape::sphere, boxAt(hands.tip * glm::vec3(0, 0, hands.burnt), glm::vec3(0.004f)), {1, 1, 1}, 0,
            hands.arcGlow.value_or(kHeatGlow * hands.heat));
}

/// Adds the process's own torch, whose handle runs through the hand, for any calibration near its own tip.
void WorkshopScene::addProcessTorch(const HeadsetParameters& parameters, const HandsView& hands,
                                    const ProcessSettings& process) {
    TorchSample sample;
    sample.tip = hands.tip.position;
    sample.orientation = hands.tip.orientation;
    ArcState arc; // out: the light is at the tip, in real size, for any zoom of the workpiece
    arc.extension = hands.extension;
    buildTorchModel(torch_, sample, process, arc, glm::mat4(1.0f));
    solids_.insert(solids_.end(), torch_.begin(), torch_.end());
    if (hands.process == nullptr) {
        const TorchGeometry geometry = torchGeometry(process);
        const bool straight = geometry.bend == 0 || equipmentOf(process).electrodeLength > 0; // has its handle
        if (!straight) addHandle(hands, geometry);
        return;
    }
    TorchSurroundings around;
    around.hand = hands.holder.tracked();
    around.cableEnd = cableEnd(parameters, hands.holder.right);
    buildTorchFittings(fittings_, sample, *hands.process, around, glm::mat4(1.0f));
}

/// Adds the fittings of a demonstration's torch, with handle and cable on the side of the person's own hand.
void WorkshopScene::addDemonstratedTorch(const HeadsetParameters& parameters, const HandsView& hands) {
    const glm::mat4 toWorkpiece = glm::inverse(hands.workpieceToWorkshop);
    TorchSurroundings around;
    around.rightHand = hands.rightHand;
    around.cableEnd = toWorkpiece * glm::vec4(cableEnd(parameters, hands.rightHand), 1);
    around.up = glm::normalize(glm::mat3(toWorkpiece) * glm::vec3(0, 1, 0));
    buildTorchFittings(demonstrated_, *hands.demonstrated, *hands.process, around, hands.workpieceToWorkshop);
    fittings_.insert(fittings_.end(), demonstrated_.begin(), demonstrated_.end());
}

void WorkshopScene::addEmptyHand(const HandsView& hands) {
    const glm::vec3 way = hands.tip.orientation * glm::vec3(0, 0, 1);
    addGlovedHand(fittings_, gripOf(hands.holder.tracked(), way, hands.tip.position, kPlainTorch.handleWidth / 2),
                  glm::mat4(1.0f));
}

void WorkshopScene::addRodHand(const HandsView& hands) {
    const xr::Pose& hold = hands.rod->hold;
    const glm::vec3 way = hold.orientation * glm::vec3(0, 0, 1), end = hold * glm::vec3(0, 0, -kRodReach);
    addGlovedHand(fittings_, rodGripOf(hands.rod->tracked(), way, end), glm::mat4(1.0f));
}

/// Table and machine are made again only when they change.
void WorkshopScene::furnish(const HeadsetParameters& parameters, const HandsView& hands) {
    const FurnitureKey key{parameters.tableHeight, hands.process->kind, equipmentOf(*hands.process).displays,
                           hands.machineRight};
    if (furnished_ != key) {
        const glm::mat4 bench = glm::translate(glm::mat4(1.0f), {0, parameters.tableHeight, -Workshop::kTableBack});
        furniture_.clear();
        addTable(furniture_, bench, parameters.tableHeight);
        addMachine(furniture_, bench, *hands.process, key.right);
        standing_ = furniture_.size();
        furnished_ = key;
    }
    furniture_.resize(standing_);
    for (Solid holder : hands.holders) {
        holder.toWorld = hands.toolsToWorkshop * holder.toWorld;
        furniture_.push_back(holder);
    }
}

std::span<const Solid> WorkshopScene::hands() const {
    return fittings_.empty() ? std::span(solids_).subspan(room_) : std::span(fittings_);
}

std::span<const Solid> WorkshopScene::build(const HeadsetParameters& parameters, const HandsView& hands) {
    solids_.clear();
    fittings_.clear();
    if (hands.process == nullptr)
        addRoom(parameters.tableHeight);
    else
        furnish(parameters, hands);
    room_ = solids_.size();
    if (hands.torch && hands.laidAside) {
        if (hands.process != nullptr) addEmptyHand(hands);
    } else if (hands.torch) {
        const ProcessSettings* const process = hands.process != nullptr ? hands.process : hands.plainly;
        if (process == nullptr)
            addTorch(hands);
        else
            addProcessTorch(parameters, hands, *process);
        addGlow(hands);
    }
    if (hands.rod && hands.process != nullptr) addRodHand(hands);
    if (hands.demonstrated != nullptr && hands.process != nullptr) addDemonstratedTorch(parameters, hands);
    for (Solid solid : hands.tools) {
        solid.toWorld = hands.toolsToWorkshop * solid.toWorld;
        solids_.push_back(solid);
    }
    if (hands.rayStart)
        add(SolidShape::cylinder, alongLine(*hands.rayStart, hands.rayEnd, 0.002f), {0.1f, 0.3f, 0.5f}, 0,
            {0.05f, 0.35f, 0.6f});
    return solids_;
}

} // namespace meltpool
