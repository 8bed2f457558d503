#include "core/weld/process/filler_rod.hpp"

#include "core/gl/state_archive.hpp"
#include "core/weld/process/weld_constants.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace meltpool {

namespace {

constexpr float kLookBefore = 0.01F;    // m before the rod's end from which its metal is looked for
constexpr float kLookBeyond = 0.02F;    // m beyond the rod's end
constexpr double kContact = 0.25e-3;    // m: accuracy with which the surface is known
constexpr float kLiquidShare = 0.5F;    // liquid share of the metal at the end, from which on it is a pool
constexpr float kFreeWay = 3;           // spacings of a drop's least fall: metal is not put into metal
constexpr double kPourParticles = 2;    // particles of a ball that fall in one step
constexpr float kShownRod = 0.3F;       // m of rod behind its end that may touch the electrode
constexpr float kElectrodeOut = 0.015F; // m of electrode before its nozzle
/// Times the arc's radius of heat, within which the arc melts a rod that is held in it.
constexpr double kColumn = 1.5;

/// Returns the distance of two segments, each from `a` over `along` (m).
float segmentDistance(const glm::vec3& a, const glm::vec3& alongA, const glm::vec3& b, const glm::vec3& alongB) {
    // Alternates between the place on A nearest to B's line and the reverse until both are on their segments.
    const auto nearest = [](const glm::vec3& from, const glm::vec3& along, const glm::vec3& point) {
        return glm::clamp(glm::dot(point - from, along) / std::max(glm::dot(along, along), 1e-12F), 0.0F, 1.0F);
    };
    const float aa = glm::dot(alongA, alongA), bb = glm::dot(alongB, alongB), ab = glm::dot(alongA, alongB);
    const glm::vec3 gap = a - b;
    const float determinant = aa * bb - ab * ab;
    float s = 0;
    if (determinant > 1e-6F * aa * bb)
        s = glm::clamp((ab * glm::dot(gap, alongB) - bb * glm::dot(gap, alongA)) / determinant, 0.0F, 1.0F);
    const float t = nearest(b, alongB, a + s * alongA);
    s = nearest(a, alongA, b + t * alongB);
    return glm::distance(a + s * alongA, b + t * alongB);
}

/// m³
double ballVolume(double diameter) {
    return std::numbers::pi / 6 * diameter * diameter * diameter;
}

} // namespace

void FillerRod::reset() {
    eaten_ = melted_ = ball_ = falling_ = 0;
    inPool_ = false;
}

void FillerRod::transfer(gl::StateArchive& archive) {
    archive.values(eaten_, melted_, ball_, falling_, inPool_);
}

double FillerRod::area() const {
    return std::numbers::pi / 4 * diameter_ * diameter_;
}

double FillerRod::ballDiameter() const {
    return std::cbrt(ball_ * 6 / std::numbers::pi);
}

TorchRay FillerRod::ray(const RodSample& rod) const {
    const glm::vec3 axis = rod.axis();
    return {rod.tip - axis * (static_cast<float>(eaten_) + kLookBefore), axis, kLookBefore + kLookBeyond};
}

bool FillerRod::touches(const RodSample& rod, const TorchRay& electrode, double electrodeDiameter) const {
    const glm::vec3 axis = rod.axis();
    const glm::vec3 end = rod.tip - axis * static_cast<float>(eaten_);
    const float gap = segmentDistance(end, -axis * kShownRod, electrode.origin, -electrode.axis * kElectrodeOut);
    // The electrode is ground to a cone, half as thick near its tip.
    return static_cast<double>(gap) < std::max(diameter_, ballDiameter()) / 2 + electrodeDiameter / 4;
}

/// Melts the end in the pool back to the surface; `most`: m³ that the heat suffices for.
double FillerRod::meltBack(const MetalAhead& ahead, double most) {
    const double depth = static_cast<double>(kLookBefore) - static_cast<double>(ahead.distance);
    inPool_ = depth > -kContact && ahead.liquid >= kLiquidShare;
    if (!inPool_) return 0;
    return std::min(std::max(depth, 0.0) * area(), most);
}

/// Melts the end in the arc's column into a ball.
double FillerRod::meltBall(const RodArc& arc, const glm::vec3& end, double most) {
    const glm::vec3 way = end - arc.electrode.origin;
    const float along = glm::dot(way, arc.electrode.axis);
    if (along < 0 || static_cast<double>(along) > arc.length) return 0;
    const float beside = glm::length(way - along * arc.electrode.axis);
    if (static_cast<double>(beside) > kColumn * arc.radius + diameter_ / 2) return 0;
    return most;
}

/// Returns the part of a detached ball that falls in one step.
double FillerRod::pour(double spacing) {
    const double poured = std::min(falling_, kPourParticles * spacing * spacing * spacing);
    falling_ -= poured;
    return poured;
}

RodMelt FillerRod::step(const RodSample& rod, const MetalAhead& ahead, const RodArc* arc, const ProcessMetal& metal,
                        double seconds) {
    eaten_ = std::max(eaten_ - static_cast<double>(rod.feed) * seconds, 0.0);
    inPool_ = false;
    RodMelt melt;
    if (arc == nullptr) return melt;
    const double cold = metal.table.enthalpyAt(metal.ambient);
    const double perVolume = metal.density * (metal.table.liquidusEnthalpy() - cold);
    const auto most = [&](double share) { return share * arc->power * seconds / perVolume; };
    const glm::vec3 axis = rod.axis();
    const glm::vec3 end = rod.tip - axis * static_cast<float>(eaten_);
    double volume = meltBack(ahead, most(kRodPoolShare));
    double pooled = volume;
    if (!inPool_) {
        volume = meltBall(*arc, end, most(kRodArcShare));
        ball_ += volume;
    }
    eaten_ += volume / area();
    melted_ += volume / area();
    const double gap = static_cast<double>(ahead.distance - kLookBefore);
    if (ball_ > 0 && (inPool_ || gap < ballDiameter() / 2 || ball_ > ballVolume(kRodBall * diameter_))) {
        falling_ += ball_;
        ball_ = 0;
    }
    melt.volume = pooled + pour(static_cast<double>(metal.spacing));
    melt.heat = volume * perVolume / seconds;
    melt.temperature = static_cast<float>(metal.table.temperatureAt(metal.table.liquidusEnthalpy()));
    const float reach = std::isfinite(ahead.distance) ? ahead.distance - kLookBefore : 0.0F;
    melt.place = end + axis * reach - arc->electrode.axis * (kFreeWay * metal.spacing);
    return melt;
}

} // namespace meltpool
