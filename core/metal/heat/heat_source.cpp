#include "core/metal/heat/heat_source.hpp"

#include <algorithm>
#include <numbers>

namespace meltpool {

HeatSource HeatSource::sphere(glm::vec3 centre, float radius, float power) {
    HeatSource s;
    s.kind = SOURCE_SPHERE;
    s.position = centre;
    s.size = radius;
    s.power = power;
    return s;
}

HeatSource HeatSource::gaussian(glm::vec3 position, glm::vec3 axis, float sigma, float power) {
    HeatSource s;
    s.kind = SOURCE_GAUSSIAN;
    s.position = position;
    s.axis = axis;
    s.size = sigma;
    s.power = power;
    return s;
}

HeatSource HeatSource::inFront(float torchBefore, float shadowBeyond) const {
    HeatSource s = *this;
    s.before = torchBefore;
    s.beyond = shadowBeyond;
    return s;
}

HeatSource HeatSource::catching(float share) const {
    HeatSource s = *this;
    s.fullWeight = share * 2 * std::numbers::pi_v<float> * size * size;
    return s;
}

HeatSource HeatSource::ellipsoid(glm::vec3 position, glm::vec3 axis, glm::vec3 travel, float halfWidth, float depth,
                                 float front, float rear, float frontFraction, float power) {
    HeatSource s;
    s.kind = SOURCE_ELLIPSOID;
    s.position = position;
    s.axis = axis;
    s.travel = travel;
    s.size = front;
    s.halfWidth = halfWidth;
    s.depth = depth;
    s.rear = rear;
    s.frontFraction = frontFraction;
    s.power = power;
    return s;
}

HeatSource HeatSource::hotTip(glm::vec3 position, float radius, float temperature, float conductance, float power) {
    HeatSource s;
    s.kind = SOURCE_TIP;
    s.position = position;
    s.size = radius;
    s.tipTemperature = temperature;
    s.tipConductance = conductance;
    s.power = power;
    return s;
}

float HeatSource::reach() const {
    constexpr float kSigmas = 4.5F;     // cutoff: 4e-5 of a Gaussian's power is beyond
    constexpr float kEllipsoids = 2.2F; // cutoff: exp(-3 2.2²) = 5e-7 of the peak
    if (kind == SOURCE_GAUSSIAN) return kSigmas * size;
    if (kind == SOURCE_ELLIPSOID) return kEllipsoids * std::max({size, halfWidth, depth, rear});
    return size;
}

} // namespace meltpool
