#include "core/weld/workpiece/workpiece_shape.hpp"

#include "core/weld/workpiece/simulated_size.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace meltpool {

namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kClampMm = 4; ///< reach of clamps over the ends
/// Tacks take half of the plates' thickness, and three particles, as fewer are no triangle; at most this many mm.
constexpr float kTackShare = 0.5F, kTackSpacings = 3, kLargestTackMm = 5;

using Boxes = std::vector<WorkpieceShape::Box>;

/// Returns the two halves of a body parted by a gap across z, `open` mm wide about `middle`; without a gap the whole.
Boxes partedBoxes(glm::vec3 low, glm::vec3 high, float open, float middle) {
    if (open <= 0) return {{low, high}};
    return {{low, {high.x, high.y, middle - open / 2}}, {{low.x, low.y, middle + open / 2}, high}};
}

/// Returns the length by which a bridge's piers reach inwards: twice the clamps, in whole layers.
float pierLength(const WorkpieceParameters& p) {
    return std::max(std::round(2 * kClampMm / p.spacingMm), 1.0F) * p.spacingMm;
}

Boxes boxesOf(const WorkpieceParameters& p) {
    const float l = p.lengthMm / 2, w = p.widthMm / 2, t = p.thicknessMm, d = p.diameterMm;
    const float middle = gapBesideMiddle(p), pier = pierLength(p);
    switch (static_cast<WorkpieceKind>(p.kind)) {
    case WorkpieceKind::Plate:
        return {{{-l, -t, -w}, {l, 0, w}}};
    case WorkpieceKind::Cube:
        return {{{-l, -l, -l}, {l, l, l}}};
    case WorkpieceKind::Bridge:
        return {{{-l, -p.heightMm, -w}, {-l + pier, 0, w}},
                {{l - pier, -p.heightMm, -w}, {l, 0, w}},
                {{-l + pier, -t, -w}, {l - pier, 0, w}}};
    case WorkpieceKind::Tee:
        return {{{-l, -t, -w}, {l, 0, w}}, {{-l, 0, -t}, {l, p.heightMm, 0}}};
    case WorkpieceKind::Lap:
        return {{{-l, -t, -w / 2}, {l, 0, w}}, {{-l, 0, -w}, {l, t, 0}}};
    case WorkpieceKind::Butt:
        return partedBoxes({-l, -t, -w}, {l, 0, w}, p.gapMm, middle);
    case WorkpieceKind::Corner:
        return {{{-l, 0, -w}, {l, t, 0}}, {{-l, -p.heightMm, 0}, {l, 0, t}}};
    case WorkpieceKind::Pipe:
        return partedBoxes({-d / 2, -d, -w}, {d / 2, 0, w}, p.gapMm, middle);
    }
    return {};
}

} // namespace

WorkpieceShape::WorkpieceShape(const WorkpieceParameters& simulated)
    : p_(simulated), gapMiddle_(gapBesideMiddle(simulated)), boxes_(boxesOf(simulated)) {}

WorkpieceShape::Box WorkpieceShape::around() const {
    Box sum = boxes_[0];
    for (const Box& box : boxes_)
        sum = {glm::min(sum.low, box.low), glm::max(sum.high, box.high)};
    return sum;
}

std::vector<WorkpieceShape::Box> WorkpieceShape::fullBoxes() const {
    if (is(WorkpieceKind::Pipe)) return {};
    if (!is(WorkpieceKind::Butt)) return boxes_;
    const Box all = around();
    return partedBoxes(all.low, all.high, p_.gapMm + 2 * bevelRun(p_), gapMiddle_);
}

glm::vec2 WorkpieceShape::sectionOf(glm::vec3 place) const {
    const float across = place.z - gapMiddle_;
    if (!is(WorkpieceKind::Pipe)) return {across, place.y};
    const float radius = p_.diameterMm / 2;
    return {across, std::hypot(place.x, place.y + radius) - radius};
}

float WorkpieceShape::halfGroove(float height) const {
    const float rise = std::max(height - p_.rootFaceMm, 0.0F);
    return p_.gapMm / 2 + rise * std::tan(p_.bevelDeg * kPi / 180);
}

float WorkpieceShape::bevelRun(const WorkpieceParameters& p) {
    return std::max(p.thicknessMm - p.rootFaceMm, 0.0F) * std::tan(p.bevelDeg * kPi / 180);
}

bool WorkpieceShape::holds(glm::vec3 place) const {
    if (!grooved()) return true;
    const glm::vec2 at = sectionOf(place);
    if (is(WorkpieceKind::Pipe) && (at.y > 0 || at.y < -p_.thicknessMm)) return false;
    return p_.bevelDeg <= 0 || std::abs(at.x) >= halfGroove(at.y + p_.thicknessMm);
}

double WorkpieceShape::volume() const {
    const auto cubicMm = [](const Box& box) {
        const glm::dvec3 size = box.high - box.low;
        return size.x * size.y * size.z;
    };
    double sum = 0;
    for (const Box& box : boxes_)
        sum += cubicMm(box);
    if (!grooved()) return sum;
    const double outer = static_cast<double>(p_.diameterMm) / 2, wall = static_cast<double>(p_.thicknessMm);
    double length = static_cast<double>(p_.lengthMm); // length of the edges
    if (is(WorkpieceKind::Pipe)) {
        const double ring = std::numbers::pi * wall * (2 * outer - wall);
        sum = ring * static_cast<double>(p_.widthMm - p_.gapMm);
        // Guldin's rule: the bevel's centre is a third of its height under the outer face.
        length = 2 * std::numbers::pi * (outer - (wall - static_cast<double>(p_.rootFaceMm)) / 3);
    }
    return sum - length * static_cast<double>(bevelRun(p_) * (p_.thicknessMm - p_.rootFaceMm));
}

/// Returns true at a clamp: clamps hold the ends of plates and pipes, the foot of a cube and the feet of a bridge's
/// piers.
bool WorkpieceShape::held(glm::vec3 place) const {
    if (is(WorkpieceKind::Cube) || is(WorkpieceKind::Bridge)) return place.y < around().low.y + p_.spacingMm;
    const bool pipe = is(WorkpieceKind::Pipe);
    const float length = pipe ? p_.widthMm : p_.lengthMm;
    return std::abs(pipe ? place.z : place.x) > length / 2 - std::min(kClampMm, length / 8);
}

float WorkpieceShape::tackSize(const WorkpieceParameters& p) {
    const float wanted = std::max(std::min(kTackShare * p.thicknessMm, kLargestTackMm), kTackSpacings * p.spacingMm);
    return std::min(wanted, p.thicknessMm);
}

float WorkpieceShape::placeOf(glm::vec3 place) const {
    if (!is(WorkpieceKind::Pipe)) return place.x;
    const float radius = p_.diameterMm / 2, angle = std::atan2(place.x, place.y + radius);
    return (angle < 0 ? angle + 2 * kPi : angle) * radius;
}

float WorkpieceShape::seamLength(const WorkpieceParameters& p) {
    return static_cast<WorkpieceKind>(p.kind) == WorkpieceKind::Pipe ? kPi * p.diameterMm : p.lengthMm;
}

/// The first and the last tack end at the ends of the seam; on a pipe they are at equal distances around it.
bool WorkpieceShape::onTack(float place) const {
    const float length = seamLength(p_);
    const auto last = static_cast<float>(p_.tackCount - 1);
    for (int i = 0; i < p_.tackCount; ++i) {
        const auto number = static_cast<float>(i);
        const float free = length - p_.tackLengthMm;
        float middle = last > 0 ? free * (number / last - 0.5F) : 0;
        if (is(WorkpieceKind::Pipe)) middle = length * (number + 0.5F) / (last + 1);
        if (std::abs(place - middle) < p_.tackLengthMm / 2) return true;
    }
    return false;
}

bool WorkpieceShape::inTack(glm::vec3 place) const {
    if (!onTack(placeOf(place))) return false;
    const glm::vec2 at = sectionOf(place);
    const float size = tackSize(p_);
    if (!grooved()) return at.x > 0 && at.y > 0 && at.x + at.y < size;
    const float height = at.y + p_.thicknessMm;
    // A bevel without a gap has room for a tack above its root face only.
    const float top = std::max(size, p_.gapMm > 0 ? 0.0F : p_.rootFaceMm + size);
    return height > 0 && height < std::min(top, p_.thicknessMm) && std::abs(at.x) < halfGroove(height);
}

WorkpieceShape::Box WorkpieceShape::aroundTacks() const {
    const Box all = around();
    const float size = tackSize(p_);
    if (!grooved()) return {{all.low.x, 0, 0}, {all.high.x, size, size}};
    const float half = halfGroove(p_.thicknessMm);
    return {{all.low.x, all.low.y, gapMiddle_ - half}, {all.high.x, all.high.y, gapMiddle_ + half}};
}

} // namespace meltpool
