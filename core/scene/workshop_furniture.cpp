#include "core/scene/workshop_furniture.hpp"

#include "core/base/units.hpp"
#include "core/scene/stroke_text.hpp"

#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

namespace meltpool {

namespace {

constexpr glm::vec3 kTableSteel(0.085f, 0.085f, 0.09f);
constexpr glm::vec3 kSlotBlack(0.012f);
constexpr glm::vec3 kDarkSteel(0.10f, 0.105f, 0.11f);
constexpr glm::vec3 kBareSteel(0.40f, 0.40f, 0.41f);
constexpr glm::vec3 kMachinePaint(0.62f, 0.17f, 0.02f);
constexpr glm::vec3 kPanel(0.03f, 0.032f, 0.035f);
constexpr glm::vec3 kBrass(0.58f, 0.44f, 0.17f);
constexpr glm::vec3 kDisplayLight(1.4f, 0.30f, 0.07f);
constexpr glm::vec3 kLabelWhite(0.55f);

/// Builder of solids in a frame of their own.
class Builder {
  public:
    Builder(std::vector<Solid>& solids, const glm::mat4& toWorld) : solids_(solids), toWorld_(toWorld) {}

    void add(SolidShape shape, const glm::mat4& place, const glm::vec3& colour, float gloss,
             const glm::vec3& glow = glm::vec3(0)) {
        solids_.push_back({shape, toWorld_ * place, colour, gloss, glow});
    }
    void box(const glm::vec3& middle, const glm::vec3& size, const glm::vec3& colour, float gloss,
             SolidShape shape = SolidShape::box) {
        add(shape, boxAt(middle, size), colour, gloss);
    }
    void rod(const glm::vec3& from, const glm::vec3& to, float width, const glm::vec3& colour, float gloss,
             SolidShape shape = SolidShape::cylinder) {
        add(shape, alongLine(from, to, width), colour, gloss);
    }

    /// Adds a line of text in the plane z = `begin.z`, right to +x: each of its strokes is a thin box.
    void text(std::string_view words, const glm::vec3& begin, float height, const glm::vec3& colour,
              const glm::vec3& glow) {
        strokes_.clear();
        appendStrokeText(strokes_, words, {begin.x, begin.y}, {.height = height});
        for (const SectionStroke& stroke : strokes_) {
            const glm::vec2 way = stroke.to - stroke.from, middle = 0.5f * (stroke.from + stroke.to);
            const float length = glm::length(way), width = stroke.width;
            const glm::vec2 along = length > 0 ? way / length : glm::vec2(1, 0);
            const glm::mat4 place(glm::vec4(along * (length + width), 0, 0),
                                  glm::vec4(-along.y * width, along.x * width, 0, 0), glm::vec4(0, 0, 0.1f * height, 0),
                                  glm::vec4(middle, begin.z, 1));
            add(SolidShape::box, place, colour, 0, glow);
        }
    }

  private:
    std::vector<Solid>& solids_;
    const glm::mat4& toWorld_;
    std::vector<SectionStroke> strokes_;
};

std::string number(float value, int places) {
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "%.*f", places, static_cast<double>(value));
    return text.data();
}

constexpr glm::vec3 kMachineSize(0.20f, 0.26f, 0.36f);

/// Adds the front of the machine, its lower edge's middle at the origin, looking to +z.
void addFront(Builder& add, std::span<const MachineDisplay> displays) {
    constexpr float kDisplayHeight = 0.042f, kFigure = 0.026f;
    add.box({0, 0.5f * kMachineSize.y, 0}, {kMachineSize.x - 0.02f, kMachineSize.y - 0.025f, 0.012f}, kPanel, 0.3f);
    float top = kMachineSize.y - 0.03f;
    for (const MachineDisplay& display : displays) {
        if (display.unit.empty()) continue;
        const ShownUnit unit = shownUnit(display.unit);
        const std::string value = number(display.value * static_cast<float>(unit.perMetric),
                                         std::clamp(display.digits + unit.digits, 0, unit.mostDigits));
        const float middle = top - 0.5f * kDisplayHeight;
        add.box({-0.025f, middle, 0.006f}, {0.105f, kDisplayHeight, 0.004f}, kSlotBlack, 0.5f);
        const float length = strokeTextLength(value, kFigure);
        add.text(value, {0.018f - length, middle - 0.5f * kFigure, 0.009f}, kFigure, kSlotBlack, kDisplayLight);
        add.text(unit.name, {0.034f, middle - 0.5f * kFigure, 0.008f}, 0.5f * kFigure, kLabelWhite, glm::vec3(0));
        top -= kDisplayHeight + 0.014f;
    }
    for (const float x : {-0.05f, 0.05f}) { // knob and socket
        add.rod({x, 0.1f, 0.03f}, {x, 0.1f, 0}, 0.03f, kDarkSteel, 0.5f, SolidShape::taper);
        add.rod({x, 0.045f, 0.03f}, {x, 0.045f, 0}, 0.034f, kDarkSteel, 0.3f, SolidShape::tube);
        add.rod({x, 0.045f, 0.012f}, {x, 0.045f, 0}, 0.024f, kBrass, 0.6f);
    }
}

/// Adds a plate's step clamp: a bar that presses on its top and on a block of its height, held down by a bolt. `side`:
/// of the end along x.
void addClamp(Builder& add, const WorkpieceBlock& plate, float table, float side) {
    const float edge = side > 0 ? plate.high.x : plate.low.x;
    const float z = glm::mix(plate.low.z, plate.high.z, 0.14f), top = plate.high.y;
    constexpr float kBar = 0.008f;
    const auto x = [&](float outwards) { return edge + side * outwards; };
    add.box({x(0.022f), top + kBar / 2, z}, {0.058f, kBar, 0.014f}, kDarkSteel, 0.35f, SolidShape::rounded);
    add.box({x(0.044f), 0.5f * (table + top), z}, {0.012f, std::max(top - table, 0.001f), 0.016f}, kBareSteel, 0.4f);
    add.rod({x(0.022f), top + kBar + 0.012f, z}, {x(0.022f), table, z}, 0.006f, kBareSteel, 0.6f);
    add.rod({x(0.022f), top + kBar + 0.006f, z}, {x(0.022f), top + kBar, z}, 0.011f, kBareSteel, 0.5f);
}

/// Returns the block that reaches lowest, of those the longest: the part on the table.
const WorkpieceBlock* basePlate(const Workpiece& piece) {
    const WorkpieceBlock* best = nullptr;
    for (const WorkpieceBlock& block : piece.blocks)
        if (best == nullptr || block.low.y < best->low.y - 1e-5f ||
            (block.low.y < best->low.y + 1e-5f && block.high.x - block.low.x > best->high.x - best->low.x))
            best = &block;
    return best;
}

/// Adds rests for a workpiece whose lowest side is not the table's: bars under both ends.
void addRests(Builder& add, const Workpiece& piece, const WorkpieceBlock& plate) {
    const float gap = plate.low.y - piece.floorHeight;
    if (gap < 2e-4f) return;
    for (const float side : {-1.0f, 1.0f}) {
        const float x = 0.5f * (plate.low.x + plate.high.x) + side * (0.5f * (plate.high.x - plate.low.x) - 0.008f);
        add.box({x, piece.floorHeight + gap / 2, 0.5f * (plate.low.z + plate.high.z)},
                {0.010f, gap, plate.high.z - plate.low.z}, kDarkSteel, 0.3f);
    }
}

void addPost(Builder& add, const Workpiece& piece, float overTable) {
    glm::vec3 low(1e9f), high(-1e9f); // box around the workpiece as it is held
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 share(corner & 1, corner >> 1 & 1, corner >> 2);
        const glm::vec3 at = piece.turn * glm::mix(piece.bodyLow, piece.bodyHigh, share);
        low = glm::min(low, at);
        high = glm::max(high, at);
    }
    constexpr float kPost = 0.03f, kBehind = 0.035f;
    const float table = piece.floorHeight - overTable, grip = glm::mix(low.y, high.y, 0.5f);
    const float x = 0.5f * (low.x + high.x), z = low.z - kBehind;
    add.box({x, table + 0.006f, z}, {0.14f, 0.012f, 0.11f}, kDarkSteel, 0.3f, SolidShape::rounded);
    add.rod({x, grip + 0.03f, z}, {x, table, z}, kPost, kBareSteel, 0.5f);
    add.box({x, grip, z}, {0.045f, 0.04f, 0.045f}, kDarkSteel, 0.3f, SolidShape::rounded);
    add.rod({x, grip, z}, {x, grip, low.z}, 0.014f, kBareSteel, 0.5f);
}

} // namespace

void addTable(std::vector<Solid>& solids, const glm::mat4& toWorld, float height) {
    constexpr float kWidth = 1.2f, kDepth = 0.75f, kThickness = 0.03f, kLeg = 0.05f;
    Builder add(solids, toWorld);
    constexpr float kUnder = 0.0005f; // depth under the top's face of the box that carries it
    add.box({0, -kThickness / 2 - kUnder, 0}, {kWidth, kThickness, kDepth}, kTableSteel, 0.3f);
    add.box({0, 0, 0}, {kWidth, 1, kDepth}, kTableSteel, 0.3f, SolidShape::slab);
    // The slots of a clamping table help to judge distances on it.
    constexpr float kSlot = 0.006f, kSpacing = 0.15f, kRaise = 0.0004f;
    for (int i = -3; i <= 3; ++i)
        add.box({float(i) * kSpacing, 0, 0}, {kSlot, kRaise, kDepth - 0.06f}, kSlotBlack, 0);
    for (int i = -2; i <= 2; ++i)
        add.box({0, 0, float(i) * kSpacing}, {kWidth - 0.06f, kRaise, kSlot}, kSlotBlack, 0);
    const float leg = height - kThickness;
    for (const float x : {-1.0f, 1.0f})
        for (const float z : {-1.0f, 1.0f})
            add.box({x * (kWidth / 2 - kLeg), -kThickness - leg / 2, z * (kDepth / 2 - kLeg)}, {kLeg, leg, kLeg},
                    kDarkSteel, 0.2f);
}

void addMachine(std::vector<Solid>& solids, const glm::mat4& toWorld, const ProcessSettings& process, bool right) {
    const auto displays = equipmentOf(process).displays;
    if (displays.front().unit.empty()) return;
    constexpr float kTurn = -0.45f; // turn about the vertical, rad, towards the welder
    const float side = right ? 1.0f : -1.0f;
    const glm::vec3 place(0.36f * side, 0, -0.10f);
    const glm::mat4 toBench = glm::rotate(glm::translate(glm::mat4(1), place), kTurn * side, glm::vec3(0, 1, 0));
    const glm::mat4 machineToWorld = toWorld * toBench;
    Builder add(solids, machineToWorld);
    add.box({0, 0.5f * kMachineSize.y + 0.012f, -0.5f * kMachineSize.z}, kMachineSize, kMachinePaint, 0.35f,
            SolidShape::rounded);
    for (const float z : {-0.05f, -0.31f})
        add.box({0, 0.008f, z}, {0.17f, 0.016f, 0.03f}, kPanel, 0.1f);
    const float top = kMachineSize.y + 0.012f;
    for (const float z : {-0.08f, -0.28f})
        add.rod({0, top + 0.03f, z}, {0, top - 0.01f, z}, 0.022f, kPanel, 0.3f);
    add.rod({0, top + 0.032f, -0.05f}, {0, top + 0.032f, -0.31f}, 0.026f, kPanel, 0.3f, SolidShape::pill);
    addFront(add, displays);
}

void addHolders(std::vector<Solid>& solids, const glm::mat4& toWorld, const Workpiece& piece, float overTable) {
    Builder add(solids, toWorld);
    if (overTable > 1e-4f) return addPost(add, piece, overTable);
    const WorkpieceBlock* plate = basePlate(piece);
    if (plate == nullptr || piece.turn != glm::mat3(1)) return;
    addRests(add, piece, *plate);
    const glm::vec3 size = plate->high - plate->low;
    if (size.y > 0.5f * std::min(size.x, size.z)) return; // a thick block is no plate
    for (const float side : {-1.0f, 1.0f})
        addClamp(add, *plate, piece.floorHeight, side);
}

} // namespace meltpool
