#include "core/render/effects/spatter.hpp"

#include "core/render/effects/counted_chance.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace meltpool {

namespace {

// Amounts of spatter. No source gives numbers of drops; all are chosen by the look of films of such arcs.
constexpr float kFullPower = 5000;                    // W of a short circuit that throws kMostOfBurst drops
constexpr float kLeastOfBurst = 3, kMostOfBurst = 14; // drops
constexpr int kStrikeDrops = 25;                      // drops of an arc that strikes
constexpr double kLongRate = 400;                     // 1/s more for an arc that is about to go out
constexpr double kStubRate = 120;                     // 1/s of a wire that stubs
constexpr float kSlowest = 0.5F, kFastest = 3.5F;     // m/s: films show 1 to 4
constexpr float kFlattest = 0.10F, kSteepest = 0.92F; // cosine from the torch's axis
/// m about the arc in which the pool takes up falling metal and beads on the plate melt.
constexpr float kPool = 4e-3F;

/// Returns the rate (1/s) of drops in addition to those of short circuits.
double openRate(const ArcState& arc, const Equipment& tools) {
    const double stretched = static_cast<double>(arc.stretch) * static_cast<double>(arc.stretch);
    if (tools.wire > 0 && arc.action == ArcAction::stubbed) return kStubRate;
    // Spatter of a dip transfer comes with the short circuits.
    if (tools.wire > 0 && arc.action == ArcAction::shorting) return 0;
    return tools.spatter + kLongRate * stretched;
}

} // namespace

void Spatter::reset() {
    for (Drop& drop : flying_)
        drop.landing = -1;
    for (Bead& bead : beads_)
        bead.diameter = 0;
    nextDrop_ = nextBead_ = 0;
    bursts_ = born_ = 0;
}

void Spatter::step(const ArcEffectsStep& step) {
    draws_ = 0;
    if (!step.arc.burns() || step.process == nullptr) return;
    const Equipment tools = equipmentOf(*step.process);
    if (tools.spatter <= 0) return;
    meltBeads(step);
    const double begin = step.time - step.seconds;
    if (step.arc.action == ArcAction::striking) burst(step, begin, kStrikeDrops);
    const auto reignitions = tools.controlledShorts ? std::span<const Reignition>() : step.reignitions;
    for (const Reignition& each : reignitions) {
        const float share = std::clamp(each.power / kFullPower, 0.0F, 1.0F);
        const float more = (kMostOfBurst - kLeastOfBurst) * share * countedChance(step.number, draws_++);
        burst(step, begin + static_cast<double>(each.at), static_cast<int>(kLeastOfBurst + more));
    }
    const double mean = openRate(step.arc, tools) * step.seconds;
    const auto drops = static_cast<int>(mean + static_cast<double>(countedChance(step.number, draws_++)));
    for (int i = 0; i < drops; ++i)
        throwDrop(step, begin + step.seconds * static_cast<double>(countedChance(step.number, draws_++)));
}

void Spatter::burst(const ArcEffectsStep& step, double at, int drops) {
    ++bursts_;
    for (int i = 0; i < drops; ++i)
        throwDrop(step, at);
}

/// Throws a drop. Small drops are many and fast, large ones few and slow; most fly low.
void Spatter::throwDrop(const ArcEffectsStep& step, double at) {
    const auto chance = [&] { return countedChance(step.number, draws_++); };
    const float size = chance(), speed = chance(), steep = chance(), around = chance();
    Drop& drop = flying_[nextDrop_++ % kMostFlying];
    ++born_;
    drop.birth = at;
    drop.diameter = static_cast<float>(kSmallestSpatter) *
                    std::pow(static_cast<float>(kLargestSpatter / kSmallestSpatter), size * size * size);
    const float cosine = std::lerp(kFlattest, kSteepest, steep * steep);
    const float sine = std::sqrt(1 - cosine * cosine), angle = 2 * std::numbers::pi_v<float> * around;
    const glm::vec3 helper = std::abs(step.axis.x) < 0.9F ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1);
    const glm::vec3 across = glm::normalize(glm::cross(helper, step.axis)), along = glm::cross(step.axis, across);
    const glm::vec3 way = -step.axis * cosine + (across * std::cos(angle) + along * std::sin(angle)) * sine;
    drop.flight.from = step.place;
    drop.flight.velocity = way * std::lerp(kSlowest, kFastest, speed * (1 - 0.7F * size));
    drop.flight.gravity = -9.81F * ground_.up;
    const auto landing = landingOf(drop.flight, ground_);
    drop.landing = landing ? landing->age : cooling_.lifetime(drop.diameter);
    if (landing) keepBead(drop, *landing);
}

/// Metal that falls into the pool makes no bead.
void Spatter::keepBead(const Drop& drop, const Landing& landing) {
    const glm::vec3 place = drop.flight.at(landing.age);
    if (drop.diameter < kSticks || glm::distance(place, drop.flight.from) < kPool) return;
    // The drop was soft when it landed and flattened: a part of the ball is under the face.
    beads_[nextBead_++ % kMostBeads] = {place + 0.2F * drop.diameter * landing.normal, drop.diameter, drop.birth,
                                        drop.birth + static_cast<double>(landing.age), landing.onTable};
}

void Spatter::meltBeads(const ArcEffectsStep& step) {
    for (Bead& bead : beads_)
        if (bead.diameter > 0 && bead.landed < step.time && glm::distance(bead.place, step.place) < kPool)
            bead.diameter = 0;
}

size_t Spatter::show(double time, std::vector<Spark>& sparks) const {
    for (const Drop& drop : flying_) {
        const auto age = static_cast<float>(time - drop.birth);
        if (age < 0 || age >= drop.landing || age >= cooling_.lifetime(drop.diameter)) continue;
        sparks.push_back({drop.flight.at(age), 0.5F * drop.diameter, drop.flight.velocityAt(age) * kGathered,
                          cooling_.temperature(drop.diameter, age)});
    }
    size_t shown = 0;
    for (const bool onTable : {false, true}) {
        shown = 0;
        for (const Bead& bead : beads_) {
            if (bead.diameter <= 0 || bead.onTable != onTable || time < bead.landed) continue;
            const float kelvin = cooling_.temperature(bead.diameter, static_cast<float>(time - bead.birth));
            sparks.push_back({bead.place, 0.5F * bead.diameter, glm::vec3(0), kelvin});
            ++shown;
        }
    }
    return shown;
}

} // namespace meltpool
