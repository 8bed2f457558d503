#include "tests/training/judging/synthetic_weld.hpp"

#include "tests/support/catch.hpp"

#include <glm/gtx/quaternion.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace meltpool::test {

namespace {

std::vector<double> judgedValues(const std::vector<SeamMillimetre>& seam, TechniqueQuantity quantity, double fromMm,
                                 double toMm) {
    std::vector<double> values;
    for (const SeamMillimetre& mm : seam)
        if (mm.judged && mm.place * 1e3 > fromMm && mm.place * 1e3 < toMm)
            values.push_back(mm.values[quantity] * quantityInfo(quantity, DistanceKind::ctwd).perSi);
    REQUIRE_FALSE(values.empty());
    return values;
}

} // namespace

TorchSample torchOf(const Seam& seam, double time, const Hand& hand) {
    const SeamFrame frame = seam.at(hand.placeMm * 1e-3);
    const double work = glm::radians(hand.workDeg), travel = glm::radians(hand.travelDeg);
    // The handle leans by the work angle in the plane across the seam, then against the travel direction.
    const glm::dvec3 handle = std::cos(work) * frame.up + std::sin(work) * frame.across;
    const glm::dvec3 back = std::cos(travel) * handle - std::sin(travel) * double(hand.direction) * frame.tangent;
    const glm::dvec3 foot = frame.point + hand.aimMm * 1e-3 * frame.across;
    TorchSample torch;
    torch.time = time;
    torch.tip = glm::vec3(foot + hand.tipHeightMm * 1e-3 * back);
    torch.orientation = glm::rotation(glm::vec3(0, 0, -1), glm::vec3(-back));
    if (hand.rodGapMm >= 0) {
        const double angle = glm::radians(hand.rodDeg);
        const glm::dvec3 out = std::sin(angle) * frame.up + std::cos(angle) * frame.tangent;
        torch.rod = RodSample{glm::vec3(foot + hand.rodGapMm * 1e-3 * out),
                              glm::rotation(glm::vec3(0, 0, -1), glm::vec3(-out))};
    }
    return torch;
}

ArcState arcOf(const Hand& hand) {
    ArcState arc;
    arc.distance = static_cast<float>(hand.distanceMm * 1e-3);
    if (!hand.burns) return arc;
    arc.action = ArcAction::burning;
    arc.length = arc.distance;
    return arc;
}

Technique weldWith(const Seam& seam, double seconds, const std::function<Hand(double)>& hand,
                   const TechniqueSettings& settings) {
    Technique technique(seam, settings);
    const int steps = static_cast<int>(std::round(seconds / kTimeStep));
    for (int i = 0; i <= steps; ++i) {
        const Hand now = hand(i * kTimeStep);
        technique.add(torchOf(seam, i * kTimeStep, now), arcOf(now), now.tracked);
    }
    return technique;
}

Seam plateSeam() {
    return Seam::line({}, {1, 0, 0}, {0, 1, 0}, -0.05, 0.05);
}

double meanOf(const std::vector<SeamMillimetre>& seam, TechniqueQuantity quantity, double fromMm, double toMm) {
    const std::vector<double> values = judgedValues(seam, quantity, fromMm, toMm);
    double sum = 0;
    for (const double value : values)
        sum += value;
    return sum / static_cast<double>(values.size());
}

double farthestFrom(double expected, const std::vector<SeamMillimetre>& seam, TechniqueQuantity quantity, double fromMm,
                    double toMm) {
    double farthest = 0;
    for (const double value : judgedValues(seam, quantity, fromMm, toMm)) {
        if (std::isnan(value)) return value;
        farthest = std::max(farthest, std::abs(value - expected));
    }
    return farthest;
}

} // namespace meltpool::test
