// Places a camera so that its picture shows given points in the part that no panel covers.
#pragma once

#include "core/render/camera.hpp"

#include <span>

namespace meltpool {

/// Edges of a picture that panels cover, as shares of its width and height.
struct CoveredEdges {
    float left = 0;
    float right = 0;
    float bottom = 0;
    float top = 0;

    /// Distance of the uncovered part's middle to the right of the picture's, as a share of half its width.
    float shift() const { return left - right; }
    /// Distance of that middle above the picture's, as a share of half its height.
    float lift() const { return bottom - top; }
    /// Turns clip space of the picture into one whose whole extent is the uncovered part; the picture's own if nothing
    /// is uncovered.
    glm::mat4 uncovered() const;
};

/// Returns the camera that looks in the direction of `wanted` and has all `points` (world) in the uncovered part. It
/// moves `wanted` sideways and away no farther than it must, and never nearer. `aspect`: width over height of the
/// picture, whose middle is shifted by `covered.shift()` and `covered.lift()`. Returns `wanted` for no points, or if
/// nothing is uncovered.
OrbitCamera framed(const OrbitCamera& wanted, const Lens& lens, float aspect, const CoveredEdges& covered,
                   std::span<const glm::vec3> points);

} // namespace meltpool
