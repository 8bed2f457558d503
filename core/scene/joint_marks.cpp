#include "core/scene/joint_marks.hpp"

#include "core/scene/chalk_line.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace meltpool {

namespace {

constexpr float kNearest = 5e-3F;                      ///< m across the line, begin of a mark
constexpr float kFarthest = 12e-3F;                    ///< m across the line, end of a mark
constexpr float kShortest = 0.5e-3F, kShorter = 1e-3F; ///< m, least mark, and step to a shorter one
constexpr float kEdge = 1e-3F;                         ///< m across the line, from a mark to the face's edge
constexpr float kAbove = 0.05F;                        ///< m over the joint, from where the faces are seen
constexpr float kParallel = 1e-6F;
constexpr float kArrow = 6e-3F;       ///< m, length of the arrow
constexpr float kArrowFrom = 1.5e-3F; ///< m along the line, from the mark to the arrow

/// A place on a face.
struct FacePoint {
    glm::vec3 place{0}; ///< m
    glm::vec3 normal{0};
};

/// Returns the place where a ray enters the block; nothing if it passes it.
std::optional<float> entryOf(const WorkpieceBlock& block, const glm::vec3& from, const glm::vec3& way,
                             glm::vec3& normal) {
    float enters = 0, leaves = std::numeric_limits<float>::max();
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(way[axis]) < kParallel) {
            if (from[axis] < block.low[axis] || from[axis] > block.high[axis]) return std::nullopt;
            continue;
        }
        const float a = (block.low[axis] - from[axis]) / way[axis], b = (block.high[axis] - from[axis]) / way[axis];
        if (std::min(a, b) > enters) {
            enters = std::min(a, b);
            normal = glm::vec3(0);
            normal[axis] = way[axis] > 0 ? -1.0F : 1.0F;
        }
        leaves = std::min(leaves, std::max(a, b));
    }
    if (enters <= 0 || enters > leaves) return std::nullopt;
    return enters;
}

/// Returns the face that a look down into the joint meets `aside` m across the line.
std::optional<FacePoint> faceAt(const JointEnd& end, float aside, std::span<const WorkpieceBlock> blocks) {
    const glm::vec3 over = end.point + end.across * aside;
    if (blocks.empty()) return FacePoint{over, end.up};
    const glm::vec3 from = over + end.up * kAbove;
    std::optional<FacePoint> face;
    float nearest = 2 * kAbove;
    for (const WorkpieceBlock& block : blocks) {
        glm::vec3 normal(0);
        const auto entry = entryOf(block, from, -end.up, normal);
        if (!entry || *entry >= nearest) continue;
        nearest = *entry;
        face = FacePoint{from - end.up * nearest, normal};
    }
    return face;
}

/// Adds the arrow between the mark's begin and end, if it lies on one face.
bool addArrow(std::vector<Solid>& marks, const JointEnd& end, float side, std::span<const WorkpieceBlock> blocks) {
    JointEnd first = end, last = end;
    first.point += end.along * kArrowFrom;
    last.point += end.along * (kArrowFrom + kArrow);
    const float aside = side * (kNearest + kFarthest) / 2;
    const auto from = faceAt(first, aside, blocks), to = faceAt(last, aside, blocks);
    if (!from || !to || from->normal != to->normal) return false;
    for (const Solid& stroke : chalkArrow(from->place, end.along, from->normal, kArrow))
        marks.push_back(stroke);
    return true;
}

} // namespace

std::vector<Solid> jointMarks(std::span<const JointEnd> ends, std::span<const WorkpieceBlock> blocks) {
    std::vector<Solid> marks;
    for (const JointEnd& end : ends)
        for (const float side : {-1.0F, 1.0F}) {
            const auto near = faceAt(end, side * kNearest, blocks);
            if (!near) continue;
            for (float reach = kFarthest; reach > kNearest + kShortest; reach -= kShorter) { // a face may be narrow
                const auto far = faceAt(end, side * reach, blocks), past = faceAt(end, side * (reach + kEdge), blocks);
                if (!far || !past || near->normal != far->normal || near->normal != past->normal) continue;
                marks.push_back(chalkStroke(near->place, far->place, near->normal));
                break;
            }
        }
    if (!ends.empty() && !addArrow(marks, ends[0], 1, blocks)) addArrow(marks, ends[0], -1, blocks);
    return marks;
}

} // namespace meltpool
