#include "core/render/framing.hpp"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace meltpool {

namespace {

constexpr float kMargin = 0.06f; ///< share of the uncovered part that stays free at each of its edges

/// Tangents of the angles from the camera's axis to two opposite edges of the uncovered part.
struct Edges {
    float low = 0;
    float high = 0;
};

/// Returns the edges. `low`, `high`: covered shares; `shift`: of the picture's middle; `scale`: the projection's.
Edges edgesOf(float low, float high, float shift, float scale) {
    const float margin = kMargin * 2 * (1 - low - high);
    return {(-1 + 2 * low + margin - shift) / scale, (1 - 2 * high - margin - shift) / scale};
}

/// Limits of the camera's place along one axis of the picture, over its distance `back` behind the points' origin:
/// most - edges.high * back <= place <= least - edges.low * back.
struct Limits {
    Edges edges;
    float most = std::numeric_limits<float>::lowest();
    float least = std::numeric_limits<float>::max();

    void add(float across, float towards) {
        most = std::max(most, across + edges.high * towards);
        least = std::min(least, across + edges.low * towards);
    }
    float leastBack() const { return (most - least) / (edges.high - edges.low); }
    float place(float back) const {
        const float from = most - edges.high * back, to = least - edges.low * back;
        return from <= to ? std::clamp(0.0f, from, to) : (from + to) / 2;
    }
};

} // namespace

glm::mat4 CoveredEdges::uncovered() const {
    const float width = 1 - left - right, height = 1 - bottom - top;
    glm::mat4 turn(1);
    if (width <= 0 || height <= 0) return turn;
    turn[0][0] = 1 / width;
    turn[1][1] = 1 / height;
    turn[3][0] = -shift() / width;
    turn[3][1] = -lift() / height;
    return turn;
}

OrbitCamera framed(const OrbitCamera& wanted, const Lens& lens, float aspect, const CoveredEdges& covered,
                   std::span<const glm::vec3> points) {
    if (points.empty() || covered.left + covered.right >= 1 || covered.bottom + covered.top >= 1) return wanted;
    const float upright = 1 / std::tan(lens.fieldOfView / 2);
    Limits x{edgesOf(covered.left, covered.right, covered.shift(), upright / aspect)};
    Limits y{edgesOf(covered.bottom, covered.top, covered.lift(), upright)};
    const glm::mat3 toWorld = glm::mat3_cast(wanted.orientation());
    for (const glm::vec3& point : points) {
        const glm::vec3 seen = glm::transpose(toWorld) * (point - wanted.target());
        x.add(seen.x, seen.z);
        y.add(seen.y, seen.z);
    }
    const float back = std::clamp(std::max({wanted.distance(), x.leastBack(), y.leastBack()}), OrbitCamera::kNearest,
                                  OrbitCamera::kFarthest);
    const glm::vec3 aside = toWorld * glm::vec3(x.place(back), y.place(back), 0);
    return OrbitCamera(wanted.azimuth(), wanted.elevation(), back, wanted.target() + aside);
}

} // namespace meltpool
