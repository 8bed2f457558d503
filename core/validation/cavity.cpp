// Melting of metal in a closed box from one of its walls; its own convection takes part.
#include "core/base/text.hpp"
#include "core/metal/flow/flow.hpp"
#include "core/validation/case_size.hpp"
#include "core/validation/heat_rig.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr double kGravity = 9.81;     // m/s²
constexpr float kWall = 3;            // layers of particles, more than a support
constexpr float kDeep = 8;            // spacings after which the cavity repeats: the least that the flow supports
constexpr double kConfinement = 0.02; // makes the pressure positive everywhere at these speeds

/// The cavity in spacings: x from the hot to the cold wall, y up, z along the repeating axis.
struct Cavity {
    float spacing, width, height;
    double hot, cold, initial;
    MetalLattice lattice;

    explicit Cavity(const ValidationCase& from)
        : spacing(static_cast<float>(from.spacing)),
          width(cellsOf(from.number("width_mm"))),
          height(cellsOf(from.number("height_mm"))),
          hot(from.number("hot_k")),
          cold(from.number("cold_k")),
          initial(from.number("initial_k")),
          // Two empty layers take the share of liquid at the ends that falls into the cells beyond them.
          lattice(MetalLattice::covering(glm::vec3(-kWall, -2, -2) * spacing,
                                         glm::vec3(width + kWall, height + 2, kDeep + 2) * spacing, spacing)) {}

    /// Returns held walls at both sides, floor and roof that no heat crosses, metal between them; the metal comes
    /// first.
    std::vector<MetalSeed> seeds() const {
        std::vector<MetalSeed> all = block({0, 0}, {width, height}, initial, 0);
        const auto add = [&](glm::vec2 low, glm::vec2 high, double temperature, bool conducts) {
            auto wall = block(low, high, temperature, PHASE_HELD);
            if (!conducts)
                for (MetalSeed& seed : wall)
                    seed.phase &= ~PHASE_LATTICE;
            all.insert(all.end(), wall.begin(), wall.end());
        };
        add({-kWall, 0}, {0, height}, hot, true);
        add({width, 0}, {width + kWall, height}, cold, true);
        add({-kWall, -kWall}, {width + kWall, 0}, initial, false);
        add({-kWall, height}, {width + kWall, height + kWall}, initial, false);
        return all;
    }

    FlowSpace space() const {
        FlowSpace result;
        result.low = glm::vec3(-kWall, -kWall, 0) * spacing;
        result.high = glm::vec3(width + kWall, height + kWall, kDeep) * spacing;
        result.repeats = {false, false, true};
        result.acceleration = {0, kGravity, 0}; // a full box: only the differences in weight are left of gravity
        return result;
    }

  private:
    float cellsOf(double millimetres) const { return std::round(static_cast<float>(millimetres * 1e-3) / spacing); }

    std::vector<MetalSeed> block(glm::vec2 low, glm::vec2 high, double temperature, unsigned phase) const {
        std::vector<MetalSeed> seeds;
        for (float z = 0; z < kDeep; ++z)
            for (float y = low.y; y < high.y; ++y)
                for (float x = low.x; x < high.x; ++x)
                    seeds.push_back({(glm::vec3(x, y, z) + 0.5F) * spacing, static_cast<float>(temperature),
                                     PHASE_ALIVE | PHASE_LATTICE | phase, glm::vec3(0)});
        return seeds;
    }
};

FlowFluid liquidIn(const Cavity& cavity, const ValidationCase& from) {
    const Material& m = from.material;
    FlowFluid fluid;
    fluid.spacing = from.spacing;
    fluid.density = m.solidDensity.at(cavity.initial);
    fluid.tension = 0; // the box is full: no surface
    fluid.viscosity = m.viscosity.at(m.liquidus);
    fluid.expansion = m.expansion.at(m.liquidus);
    fluid.referenceTemperature = 0.5 * (m.liquidus + cavity.hot);
    fluid.confinement = kConfinement;
    // The flow's own lower bound holds for the viscosity: four times gallium's in the shipped case. With gallium's own
    // value the circulation is half as fast again, and the errors are between 1 and 11 % instead of -5 and 5 %. The
    // speed is half of the free one of a layer at the wall; the layer reaches a third.
    fluid.fastest = 0.5 * std::sqrt(std::abs(fluid.expansion) * kGravity * std::max(0.0, cavity.hot - m.liquidus) *
                                    static_cast<double>(cavity.height * cavity.spacing));
    return fluid;
}

double meltedShare(const MetalState& state, size_t metal) {
    const auto heats = state.heat.read<vec4>(metal);
    double sum = 0;
    for (const vec4& h : heats)
        sum += state.table().liquidFractionAt(static_cast<double>(h.x) + static_cast<double>(h.y));
    return sum / static_cast<double>(metal);
}

/// Returns the fastest and the root mean square speed of the liquid, m/s.
glm::dvec2 speeds(const MetalState& state, size_t metal) {
    const auto velocities = state.velocity.read<vec4>(metal);
    const auto phases = state.phase.read<uint>(metal);
    double most = 0, sum = 0, count = 0;
    for (size_t i = 0; i < metal; ++i) {
        if (!(phases[i] & PHASE_LIQUID)) continue;
        const glm::dvec3 v(velocities[i]);
        most = std::max(most, glm::length(v));
        sum += glm::dot(v, v);
        count += 1;
    }
    return {most, std::sqrt(sum / std::max(count, 1.0))};
}

} // namespace

void runCavityMelting(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result) {
    requireSpacings(from, "width_mm", from.number("width_mm") * 1e-3, 4);
    requireSpacings(from, "height_mm", from.number("height_mm") * 1e-3, 4);
    const double layer = (from.number("width_mm") * 1e-3 / from.spacing + 2.0 * static_cast<double>(kWall)) *
                         (from.number("height_mm") * 1e-3 / from.spacing + 2.0 * static_cast<double>(kWall));
    const double count = layer * static_cast<double>(kDeep + 4);
    requireCapacity(from, {count, count, count, count});
    const Cavity cavity(from);
    const auto seeds = cavity.seeds();
    const auto metal = static_cast<size_t>(cavity.width * cavity.height * kDeep);
    MetalState state(cavity.lattice, HeatTable(from.material), from.material.solidDensity.at(cavity.initial),
                     seeds.size());
    state.setGravity({0, -static_cast<float>(kGravity), 0});
    state.add(seeds);
    HeatSettings settings;
    settings.ambient = cavity.initial;
    settings.wakingKelvin = 1e-5; // small, as the whole drive is ten kelvin
    settings.meltedLeaves = true;
    settings.ledger = true;
    HeatSolver heat(shaders, state, from.material, settings);
    const FlowFluid fluid = liquidIn(cavity, from);
    Flow flow(shaders, state, fluid, cavity.space());
    // Heat and flow take turns, so short that nothing moves by more than a spacing in one.
    const double longest = from.spacing / std::max(fluid.fastest, 1e-4);
    const bool convects = fluid.fastest > 0; // without expansion nothing drives the flow
    result.particles = metal;
    const double start = state.readEnergy();
    double now = 0;
    const auto& times = from.list("times_s");
    for (size_t i = 0; i < times.size(); ++i) {
        const auto turns = static_cast<size_t>(std::ceil((times[i] - now) / longest));
        const double turn = (times[i] - now) / static_cast<double>(turns);
        const double heatSteps = std::ceil(turn / heat.longestStep(cavity.hot));
        for (size_t k = 0; k < turns; ++k) {
            for (int h = 0; h < static_cast<int>(heatSteps); ++h)
                heat.step(turn / heatSteps, {});
            if (convects) flow.step(turn, nullptr);
        }
        result.steps += turns * (convects ? flow.constants().substeps(turn) : static_cast<size_t>(heatSteps));
        now = times[i];
        const std::string moment = formatNumber(now) + " s";
        result.compareMeasured(from, "melted_fraction", meltedShare(state, metal), i, moment);
    }
    const glm::dvec2 speed = speeds(state, metal);
    result.tell("fastest_mm_s", speed.x * 1e3);
    result.tell("rms_speed_mm_s", speed.y * 1e3);
    const HeatBalance balance = heat.readBalance();
    result.tell("balance_percent",
                100 * std::abs(state.readEnergy() - start - balance.gained) / std::max(std::abs(balance.gained), 1e-9));
    if (flow.readFaults().any()) result.tell("flow_faults", 1);
}

} // namespace meltpool
