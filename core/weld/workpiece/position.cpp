#include "core/weld/workpiece/position.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>

namespace meltpool {

namespace {

constexpr std::array<std::string_view, 11> kNames{"as_it_lies", "flat", "1F", "2F", "3F", "4F",
                                                  "1G",         "2G",   "3G", "4G", "5G"};

constexpr float kHalfRoot = 0.70710678F; ///< cos 45°
/// m: higher than the eyes of a person at the table, standing (with a table of 0.9 m) or seated.
constexpr float kOverhead = 0.95F;
constexpr float kPipeOverTable = 0.25F; ///< m: a pipe is welded from below too

bool isFillet(WorkpieceKind kind) {
    return kind == WorkpieceKind::Tee || kind == WorkpieceKind::Lap || kind == WorkpieceKind::Corner;
}

/// The seam points at the welder's right, the bisector of a fillet up.
glm::mat3 trough() {
    return {{1, 0, 0}, {0, kHalfRoot, -kHalfRoot}, {0, kHalfRoot, kHalfRoot}};
}

} // namespace

std::span<const std::string_view> positionNames() {
    return kNames;
}

std::optional<WeldPosition> findPosition(std::string_view name) {
    const auto names = positionNames();
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return std::nullopt;
    return static_cast<WeldPosition>(found - names.begin());
}

glm::vec3 Fixture::up() const {
    return glm::transpose(turn) * glm::vec3(0, 1, 0);
}

glm::vec3 Fixture::down() const {
    return glm::transpose(turn) * glm::vec3(0, -1, 0);
}

Fixture fixtureOf(const WorkpieceParameters& parameters) {
    // The columns of each matrix are the room directions of the workpiece's x, y and z.
    switch (static_cast<WeldPosition>(parameters.position)) {
    case WeldPosition::flat:
        return {isFillet(static_cast<WorkpieceKind>(parameters.kind)) ? trough() : glm::mat3(1)};
    case WeldPosition::f1:
        return {trough()};
    case WeldPosition::f3: // the bisector between y and z looks at the welder
        return {{{0, 1, 0}, {-kHalfRoot, 0, kHalfRoot}, {kHalfRoot, 0, kHalfRoot}}};
    case WeldPosition::g2:
        return {{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}};
    case WeldPosition::g3:
        return {{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}};
    case WeldPosition::f4:
    case WeldPosition::g4: // turned about z, so that the rear stays at the rear
        return {{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}, kOverhead};
    case WeldPosition::g5:
        return {glm::mat3(1), kPipeOverTable};
    case WeldPosition::asItLies:
    case WeldPosition::f2:
    case WeldPosition::g1:
        break;
    }
    return {};
}

// Along any direction each axis of the box has its lower end.
float lowestAlong(const glm::vec3& up, const glm::vec3& low, const glm::vec3& high) {
    return glm::dot(up, glm::mix(high, low, glm::greaterThan(up, glm::vec3(0))));
}

bool positionFits(WorkpieceKind kind, WeldPosition position) {
    const auto between = [&](WeldPosition first, WeldPosition last) { return position >= first && position <= last; };
    if (position == WeldPosition::asItLies) return true;
    if (kind == WorkpieceKind::Cube || kind == WorkpieceKind::Bridge) return false;
    if (kind == WorkpieceKind::Pipe) return position == WeldPosition::g5;
    if (position == WeldPosition::flat) return true;
    return isFillet(kind) ? between(WeldPosition::f1, WeldPosition::f4) : between(WeldPosition::g1, WeldPosition::g4);
}

std::string fittingPositions(WorkpieceKind kind) {
    std::string names;
    for (size_t i = 0; i < kNames.size(); ++i)
        if (positionFits(kind, static_cast<WeldPosition>(i)))
            names += (names.empty() ? "" : ", ") + std::string(kNames[i]);
    return names;
}

} // namespace meltpool
