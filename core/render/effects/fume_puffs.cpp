#include "core/render/effects/fume_puffs.hpp"

#include "core/render/effects/counted_chance.hpp"
#include "core/render/effects/spatter.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace meltpool {

namespace {

constexpr double kPi = std::numbers::pi;

/// Share of the arc's electric power that goes into the air over it as heat. No source: chosen, low, as most of the
/// power that the metal does not take leaves as light.
constexpr double kWarmsAir = 0.02;
/// Power of a step without known voltage and current, W.
constexpr double kLeastPower = 100;
/// m²: scattering cross-section of a puff's smoke for a scattering of 1/m. Chosen by the look: fume rates give some
/// times as much, but pool and seam must stay in sight.
constexpr float kSeen = 1.6e-4F;
/// Places in the plume at which puffs rise, in its half widths from the axis; the outer ones are slow, as the profile
/// of a real plume is about exp(-(r/b)²).
constexpr float kFarthest = 0.9F;
/// Sway of the plume, in its half widths, and its rates, 1/s. A plume of this size meanders at some 1 to 3 Hz; the
/// second is in no simple ratio to the first, so that no moment repeats another.
constexpr double kSways = 0.5, kSwayRates[2] = {1.13, 1.87};
/// m/s: the air of a workshop is never still.
constexpr float kDraught = 0.035F;
/// Half of a puff's length, in rises of one period: it overlaps its neighbours.
constexpr double kReaches = 1.3;
/// Texels of the noise that a puff's middle wanders while its radius grows by e: smoke rolls as it rises.
constexpr float kRolls = 0.5F;
/// Share of a period by which births are late, so that none is at the end of a step of 1/90 s.
constexpr double kLate = 0.37;

/// Returns the moment of birth of a puff, s.
double birthOf(std::int64_t number) {
    return (static_cast<double>(number) + kLate) / FumePuffs::kRate;
}

struct LevelAxes {
    glm::vec3 across, along;
};

LevelAxes levelAxes(const glm::vec3& up) {
    const glm::vec3 helper = std::abs(up.x) < 0.9F ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1);
    const glm::vec3 along = glm::normalize(glm::cross(helper, up));
    return {glm::cross(up, along), along};
}

/// Returns the free way (m) from `place` along `up` to the first block over it; infinite: none.
float freeAbove(const glm::vec3& place, const SpatterGround& ground) {
    float free = std::numeric_limits<float>::infinity();
    for (const WorkpieceBlock& block : ground.blocks) {
        float entry = 0, exit = free;
        for (int axis = 0; axis < 3; ++axis) {
            const float way = std::abs(ground.up[axis]) < 1e-6F ? 1e-6F : ground.up[axis];
            const float a = (block.low[axis] - place[axis]) / way, b = (block.high[axis] - place[axis]) / way;
            entry = std::max(entry, std::min(a, b));
            exit = std::min(exit, std::max(a, b));
        }
        if (entry > 0 && entry < exit) free = std::min(free, entry);
    }
    return free;
}

float falling(double from, double to, double at) {
    const auto share = static_cast<float>(std::clamp((to - at) / (to - from), 0.0, 1.0));
    return share * share * (3 - 2 * share);
}

} // namespace

double FumePlume::speedAtMetre(double power) {
    constexpr double kGravity = 9.81, kDensity = 1.2, kHeat = 1005, kKelvin = 293;
    const double buoyancy = kGravity * power / (kPi * kDensity * kHeat * kKelvin);
    return 5 / (6 * kEntrains) * std::cbrt(0.9 * kEntrains * buoyancy);
}

double FumePlume::height(double from, double speedAtMetre, double age) {
    return std::pow(std::pow(from, 4.0 / 3) + 4.0 / 3 * speedAtMetre * age, 0.75);
}

void FumePuffs::step(const ArcEffectsStep& step, float scattering) {
    if (!step.arc.burns()) return;
    pool_ = step.place;
    if (scattering <= 0) return;
    // The moments follow from the time alone: after a seek these puffs are born again.
    const auto until = [](double time) { return static_cast<std::int64_t>(std::floor(time * kRate - kLate)); };
    const std::int64_t last = until(step.time);
    const auto most = static_cast<std::int64_t>(kMost);
    for (std::int64_t k = std::max(until(step.time - step.seconds) + 1, last - most + 1); k <= last; ++k) {
        if (k < 0) continue;
        Puff& puff = puffs_[static_cast<size_t>(k % most)];
        puff = born(step, k);
        puff.seen *= scattering;
        newest_ = k;
    }
}

FumePuffs::Puff FumePuffs::born(const ArcEffectsStep& step, std::int64_t number) const {
    const auto chance = [&](std::uint64_t draw) { return countedChance(static_cast<std::uint64_t>(number), draw); };
    const LevelAxes level = levelAxes(ground_.up);
    const float far = kFarthest * std::sqrt(chance(0)), angle = 2 * std::numbers::pi_v<float> * chance(1);
    const auto sway = [&](double rate, double ahead) {
        return static_cast<float>(kSways * std::sin(2 * kPi * (rate * birthOf(number) + ahead)));
    };
    Puff puff;
    puff.number = number;
    puff.from = step.place;
    puff.aside = level.across * (far * std::cos(angle) + sway(kSwayRates[0], 0)) +
                 level.along * (far * std::sin(angle) + sway(kSwayRates[1], 0.3));
    puff.seen = kSeen * (0.75F + 0.5F * chance(2));
    const double power = std::max(kLeastPower, static_cast<double>(step.arc.current * step.arc.voltage));
    puff.speedAtMetre = static_cast<float>(FumePlume::speedAtMetre(kWarmsAir * power)) * std::exp(-far * far);
    puff.ceiling = freeAbove(step.place, ground_);
    return puff;
}

/// Smoke under a plate spreads along it at the speed of its free rise.
FumePuff FumePuffs::shown(const Puff& puff, double age) const {
    const double source = kSource / FumePlume::kWidens; // the arc is no point: its distance over the plume's origin
    const auto speed = static_cast<double>(puff.speedAtMetre);
    const double height = FumePlume::height(source, speed, age);
    const auto risen = static_cast<float>(height - source), half = static_cast<float>(FumePlume::kWidens * height);
    const float up = std::isinf(puff.ceiling) ? risen : puff.ceiling * (1 - std::exp(-risen / puff.ceiling));
    const LevelAxes level = levelAxes(ground_.up);
    const float turn = 2 * std::numbers::pi_v<float> * countedChance(static_cast<std::uint64_t>(puff.number), 3);
    const glm::vec3 spread = (level.across * std::cos(turn) + level.along * std::sin(turn)) * (risen - up);
    const glm::vec3 draught = level.across * (kDraught * static_cast<float>(age));
    // At the arc all are on the axis: the plume has no width there yet.
    const glm::vec3 aside = puff.aside * (half - static_cast<float>(kSource));
    FumePuff shown{};
    shown.place = puff.from + ground_.up * up + aside + spread + draught;
    shown.radius = static_cast<float>(kSpreads) * half;
    // The smoke of one period is as long as its rise in one period: near the arc the plume is fast and narrow.
    const auto length = static_cast<float>(kReaches * speed / std::cbrt(height) / kRate);
    const float longer = std::max(shown.radius, length);
    shown.way = ground_.up * longer;
    shown.depth = puff.seen / (std::numbers::pi_v<float> * shown.radius * longer) * (1 - falling(0, 1 / kRate, age)) *
                  falling(kThins, kHighest, static_cast<double>(risen)) *
                  falling(kThins / kHighest * kLongest, kLongest, age);
    const auto chance = [&](std::uint64_t draw) {
        return countedChance(static_cast<std::uint64_t>(puff.number), draw);
    };
    shown.grain = glm::vec3(chance(4), chance(5), chance(6)) * 32.0F - ground_.up * (kRolls * std::log(half));
    return shown;
}

size_t FumePuffs::show(double time, std::array<FumePuff, kMost>& puffs) const {
    size_t count = 0;
    const auto most = static_cast<std::int64_t>(kMost);
    for (std::int64_t k = std::max<std::int64_t>(newest_ - most + 1, 0); k <= newest_; ++k) {
        const Puff& puff = puffs_[static_cast<size_t>(k % most)];
        const double age = time - birthOf(k);
        if (puff.number != k || age < 0 || age >= kLongest) continue;
        const FumePuff one = shown(puff, age);
        if (one.depth > 0) puffs[count++] = one;
    }
    return count;
}

} // namespace meltpool
