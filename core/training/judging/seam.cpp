#include "core/training/judging/seam.hpp"

#include "core/weld/workpiece/simulated_size.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace meltpool {

namespace {

constexpr double kMm = 1e-3;
/// Least cosine to the bisector: a flatter torch's axis has no place on the seam.
constexpr double kFlattest = 0.1;
/// Iterations that find the foot of the axis on a circle's tangents; each adds several digits.
constexpr int kFootRounds = 4;

/// A frame with this tangent, and `up` as near to the given one as a right angle allows.
SeamFrame frameOf(const glm::dvec3& point, const glm::dvec3& tangent, const glm::dvec3& up) {
    SeamFrame frame;
    frame.point = point;
    frame.tangent = glm::normalize(tangent);
    frame.up = glm::normalize(up - glm::dot(up, frame.tangent) * frame.tangent);
    frame.across = glm::cross(frame.tangent, frame.up);
    return frame;
}

} // namespace

Seam Seam::line(const glm::dvec3& zero, const glm::dvec3& tangent, const glm::dvec3& up, double begin, double end) {
    Seam seam;
    seam.zero_ = frameOf(zero, tangent, up);
    seam.begin_ = begin;
    seam.end_ = end;
    return seam;
}

Seam Seam::circle(const glm::dvec3& centre, const glm::dvec3& axis, const glm::dvec3& start) {
    Seam seam;
    seam.axis_ = glm::normalize(axis);
    seam.centre_ = centre + glm::dot(start - centre, seam.axis_) * seam.axis_;
    seam.radius_ = glm::length(start - seam.centre_);
    const glm::dvec3 up = (start - seam.centre_) / seam.radius_;
    seam.zero_ = frameOf(start, glm::cross(seam.axis_, up), up);
    seam.end_ = 2 * std::numbers::pi * seam.radius_;
    return seam;
}

SeamFrame Seam::at(double place) const {
    SeamFrame frame = zero_;
    if (!closed()) {
        frame.point += place * zero_.tangent;
        return frame;
    }
    const double angle = place / radius_;
    frame.up = std::cos(angle) * zero_.up + std::sin(angle) * zero_.tangent;
    frame.tangent = glm::cross(axis_, frame.up);
    frame.point = centre_ + radius_ * frame.up;
    return frame;
}

SeamPlace Seam::nearest(const glm::dvec3& point) const {
    SeamPlace result;
    if (closed()) {
        const glm::dvec3 from = point - centre_;
        double angle = std::atan2(glm::dot(from, zero_.tangent), glm::dot(from, zero_.up));
        if (angle < 0) angle += 2 * std::numbers::pi;
        result.place = angle * radius_ < end_ ? angle * radius_ : 0;
    } else {
        result.place = glm::dot(point - zero_.point, zero_.tangent);
    }
    const SeamFrame frame = at(result.place);
    result.across = glm::dot(point - frame.point, frame.across);
    result.height = glm::dot(point - frame.point, frame.up);
    return result;
}

Seam seamOf(const WorkpieceParameters& asked) {
    const WorkpieceParameters workpiece = simulatedWorkpiece(asked);
    const double half = static_cast<double>(workpiece.lengthMm) * kMm / 2;
    const glm::dvec3 along(1, 0, 0), outOfPlate(0, 1, 0), outOfCorner(0, 1, 1);
    switch (static_cast<WorkpieceKind>(workpiece.kind)) {
    case WorkpieceKind::Tee:
    case WorkpieceKind::Lap:
    case WorkpieceKind::Corner:
        return Seam::line({}, along, outOfCorner, -half, half);
    case WorkpieceKind::Cube:
        return Seam::line({0, half, 0}, along, outOfPlate, -half, half);
    case WorkpieceKind::Pipe:
        return Seam::circle({0, -static_cast<double>(workpiece.diameterMm) * kMm / 2, 0}, {0, 0, -1}, {});
    case WorkpieceKind::Plate:
    case WorkpieceKind::Bridge:
    case WorkpieceKind::Butt:
        break;
    }
    return Seam::line({}, along, outOfPlate, -half, half);
}

glm::dvec3 footOf(const Seam& seam, const glm::dvec3& tip, const glm::dvec3& axis) {
    glm::dvec3 foot = tip;
    for (int i = 0; i < (seam.closed() ? kFootRounds : 1); ++i) {
        const SeamFrame frame = seam.at(seam.nearest(foot).place);
        const double down = -glm::dot(axis, frame.up);
        if (down < kFlattest) return tip;
        foot = tip + axis * (glm::dot(tip - frame.point, frame.up) / down);
    }
    return foot;
}

} // namespace meltpool
