#include "core/metal/physical_metal.hpp"

#include "core/base/error.hpp"
#include "core/base/hash.hpp"
#include "core/gl/buffer_view.hpp"
#include "core/gl/order.hpp"

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace meltpool {

namespace {

constexpr int kFragmentSteps = 8; ///< steps of free fragments a frame: those at rest stay within 0.1 mm of the floor
constexpr double kHottest = 3500; ///< K, upper limit for the heat step: no metal here stays liquid above it
constexpr double kRoomTemperature = 293.15;
constexpr float kLongestFlight = 0.03F; ///< m that a drop may fly outside the space before it enters

/// The density of the masses: that of the solid at room temperature, for which workpieces are measured.
double massDensity(const Material& material) {
    return material.solidDensity.at(kRoomTemperature);
}

TensionSlopes slopesOf(const Material& material) {
    TensionSlopes slopes;
    slopes.from = material.solidus;
    slopes.step = (kHottest - slopes.from) / static_cast<double>(slopes.values.size() - 1);
    for (size_t i = 0; i < slopes.values.size(); ++i)
        slopes.values[i] = material.tensionSlopeAt(slopes.from + slopes.step * static_cast<double>(i));
    return slopes;
}

FlowFluid fluidOf(const PhysicalSetup& setup, const EdgeArrest& edge) {
    const Material& material = setup.material;
    FlowFluid fluid;
    fluid.spacing = static_cast<double>(setup.lattice.spacing);
    fluid.density = massDensity(material);
    fluid.coldBelow = edge.coldShare * material.solidus;
    fluid.warmAbove = edge.warmShare * material.solidus;
    fluid.tension = material.tensionAt(material.liquidus);
    fluid.wetting = setup.wetting;
    fluid.coldWetting = std::min(setup.wetting, wettingForAngle(edge.coldAngle, capillarySpacings(fluid)));
    if (setup.marangoni) fluid.tensionSlopes = slopesOf(material);
    fluid.viscosity = material.viscosity.at(material.liquidus);
    fluid.expansion = material.expansion.at(material.liquidus);
    fluid.referenceTemperature = material.liquidus;
    return fluid;
}

/// The time step for an upper limit `most`, heat steps up to `heatStep` and flow steps up to `flowStep` (s). Shorter
/// steps cost more elsewhere, so it is shortened by a fifth at most, and only if it saves more heat than that; then so
/// that whole flow steps fill it.
double chooseTimeStep(double most, double heatStep, double flowStep) {
    constexpr double kWorth = 0.8;
    constexpr double kFewFlowSteps = 8;
    const double heatSteps = most / heatStep;
    const double whole = std::floor(heatSteps);
    if (whole < kWorth * heatSteps || heatSteps > kWorth * std::ceil(heatSteps)) return most;
    const double bearable = whole * heatStep;
    const double flowSteps = std::floor(bearable / flowStep);
    const double wanted = flowSteps >= kFewFlowSteps ? flowSteps * flowStep : bearable;
    return 1 / std::ceil(1 / wanted); // a whole number of steps a second
}

/// Moves a drop outside the space along its velocity to its entry; returns false if there is none within
/// kLongestFlight.
bool fliesIn(MetalSeed& seed, const FlowSpace& space) {
    const auto inside = [&](glm::vec3 place) {
        return glm::all(glm::greaterThanEqual(place, space.low)) && glm::all(glm::lessThanEqual(place, space.high));
    };
    const float speed = glm::length(seed.velocity);
    constexpr float kPart = 0.5e-3F; // m
    for (float way = 0; way <= kLongestFlight; way += kPart) {
        const glm::vec3 place = speed > 0 ? seed.position + seed.velocity * (way / speed) : seed.position;
        if (!inside(place)) continue;
        seed.position = place;
        return true;
    }
    return false;
}

} // namespace

PhysicalMetal::PhysicalMetal(gl::ShaderLibrary& shaders, const PhysicalSetup& setup)
    : shaders_(shaders),
      setup_(setup),
      timeStep_(setup.timeStep),
      table_(setup.material),
      count_(shaders.compute("metal/statistics.comp")),
      parts_("metal statistics", sizeof(Parts)),
      answers_("metal statistics", sizeof(Parts), kStatisticsInFlight) {
    setup_.heat.meltedLeaves = true;
    for (int axis = 0; axis < 3; ++axis) { // fragments have the limits of the liquid
        if (setup.space.repeats[axis]) continue;
        setup_.fragments.low[axis] = setup.space.low[axis];
        setup_.fragments.high[axis] = setup.space.high[axis];
    }
    make();
    begin();
}

void PhysicalMetal::make() {
    state_ = std::make_unique<MetalState>(setup_.lattice, table_, massDensity(setup_.material),
                                          setup_.seeds.size() + setup_.fillerRoom);
    state_->setGravity(setup_.gravity);
    state_->add(setup_.seeds);
    heat_ = std::make_unique<HeatSolver>(shaders_, *state_, setup_.material, setup_.heat);
    edge_ = setup_.edge;
    flow_ = std::make_unique<Flow>(shaders_, *state_, fluidOf(setup_, setup_.edge), setup_.space);
    fragments_ = std::make_unique<RigidFragments>(shaders_, *state_, setup_.fragments);
    capacity_ = state_->capacity();
}

/// Grows the state first: if the driver has no memory for the others, only the state has spare capacity.
void PhysicalMetal::setCapacity(size_t capacity) {
    state_->setCapacity(capacity);
    heat_->onCapacityChanged();
    flow_->onCapacityChanged();
    fragments_->onCapacityChanged();
    capacity_ = capacity;
}

/// Reserves more than asked for, so that growth is rare.
void PhysicalMetal::reserve(size_t particles) {
    constexpr size_t kLeast = 2048, kShare = 16;
    if (particles <= capacity_ || !grows_) return;
    const size_t capacity = std::min(particles + std::max(kLeast, particles / kShare), setup_.mostParticles);
    if (capacity <= capacity_) return;
    try {
        setCapacity(capacity);
    } catch (const RuntimeFault&) {
        grows_ = false; // filler without capacity is refused and counted in the metal's figures
    }
}

void PhysicalMetal::reset() {
    answers_.forget();
    gl::memoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT); // clears bytes that shaders wrote
    state_->reset();
    state_->add(setup_.seeds);
    heat_->reset();
    flow_->reset();
    edge_ = setup_.edge;
    fragments_->reset();
    begin();
}

void PhysicalMetal::begin() {
    fragments_->relabelNow(nullptr);
    timeStep_ = static_cast<float>(chooseTimeStep(static_cast<double>(setup_.timeStep), heat_->longestStep(kHottest),
                                                  flow_->constants().longestStep));
    refused_ = 0;
}

void PhysicalMetal::transfer(gl::StateArchive& archive) {
    size_t capacity = capacity_;
    archive.count(capacity, setup_.mostParticles);
    if (archive.restores() && capacity != capacity_) setCapacity(capacity);
    archive.values(timeStep_);
    archive.count(refused_, std::numeric_limits<size_t>::max());
    state_->transfer(archive);
    heat_->transfer(archive);
    flow_->transfer(archive);
    fragments_->transfer(archive);
    if (!archive.restores()) return;
    edge_.reset();
    answers_.forget();
}

void PhysicalMetal::xorOutDerivedState() {
    constexpr GLbitfield kBarrier = GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT |
                                    GL_BUFFER_UPDATE_BARRIER_BIT | GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT;
    gl::memoryBarrier(kBarrier);
    heat_->xorOutDerivedState(); // neither reads values that the other changes
    flow_->xorOutDerivedState();
    gl::memoryBarrier(kBarrier);
}

void PhysicalMetal::setEdgeArrest(const EdgeArrest& edge) {
    if (edge == edge_) return;
    edge_ = edge;
    flow_->setWetting(fluidOf(setup_, edge));
}

void PhysicalMetal::setLiquidConductivity(const Property& conductivity) {
    setup_.material.liquidConductivity = conductivity;
    table_ = HeatTable(setup_.material);
    state_->setTable(table_);
    heat_->onTableChanged();
}

/// Moves nearby drops outside the space straight into it; refuses the others, because the flow would move them to the
/// end of the space from anywhere.
void PhysicalMetal::addFiller(std::span<const MetalSeed> filler) {
    accepted_.clear();
    for (MetalSeed seed : filler)
        if (fliesIn(seed, setup_.space)) accepted_.push_back(seed);
    reserve(state_->particles() + accepted_.size());
    accepted_.resize(std::min(accepted_.size(), capacity_ - state_->particles()));
    state_->add(accepted_);
    refused_ += filler.size() - accepted_.size();
}

void PhysicalMetal::step(std::span<const HeatSource> sources, std::span<const MetalSeed> filler,
                         gl::Profiler* profiler) {
    addFiller(filler);

    const auto frame = static_cast<double>(timeStep_);
    const double heatSteps = std::max(1.0, std::ceil(frame / heat_->longestStep(kHottest)));
    for (int i = 0; i < static_cast<int>(heatSteps); ++i)
        heat_->step(frame / heatSteps, sources, profiler);

    fragments_->relabel(profiler); // before the flow: a new fragment moves with the fragments and not with both
    flow_->step(frame, profiler);
    fragments_->move(timeStep_ / kFragmentSteps, kFragmentSteps, profiler);
}

void PhysicalMetal::gatherStatistics() {
    gl::memoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    const gl::BufferView positions("metal positions", state_->position, GL_RGBA32F, sizeof(vec4));
    const gl::BufferView phases("metal phases", state_->phase, GL_R32UI, sizeof(uint));
    positions.bind(METAL_STATISTICS_POSITIONS);
    phases.bind(METAL_STATISTICS_PHASES);
    parts_.bindStorage(METAL_STATISTICS);
    count_.set("particles", static_cast<unsigned>(state_->particles()));
    count_.set("low", setup_.space.low);
    count_.set("high", setup_.space.high);
    count_.dispatch(METAL_STATISTICS_PARTS, GROUP_SIZE);
    gl::memoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

MetalStatistics PhysicalMetal::joined(const Parts& parts) const {
    MetalStatistics sum;
    sum.lost = refused_;
    double temperatures = 0, least = 1e30, most = 0;
    for (const MetalPart& part : parts) {
        if (part.alive == 0) continue;
        sum.particles += part.alive;
        sum.molten += part.molten;
        sum.lost += part.outside;
        sum.nonFinite += part.broken;
        temperatures += static_cast<double>(part.sum);
        least = std::min(least, static_cast<double>(part.least));
        most = std::max(most, static_cast<double>(part.most));
    }
    if (sum.particles == 0) return sum;
    sum.minTemperature = least;
    sum.meanTemperature = temperatures / static_cast<double>(sum.particles);
    sum.maxTemperature = most;
    return sum;
}

MetalStatistics PhysicalMetal::statistics() {
    gatherStatistics();
    Parts parts{};
    const auto values = parts_.read<MetalPart>(parts.size());
    std::copy(values.begin(), values.end(), parts.begin());
    return joined(parts);
}

void PhysicalMetal::requestStatistics() {
    gatherStatistics();
    answers_.request(parts_);
}

std::optional<MetalStatistics> PhysicalMetal::pollStatistics() {
    const auto* parts = static_cast<const Parts*>(answers_.pollInPlace());
    return parts == nullptr ? std::nullopt : std::optional(joined(*parts));
}

std::optional<MetalStatistics> PhysicalMetal::awaitStatistics() {
    const auto* parts = static_cast<const Parts*>(answers_.awaitInPlace());
    return parts == nullptr ? std::nullopt : std::optional(joined(*parts));
}

std::uint64_t PhysicalMetal::stateHash() const {
    StateHash hash;
    const size_t count = state_->particles();
    hash.add(std::span<const vec4>(state_->position.read<vec4>(count)));
    hash.add(std::span<const vec4>(state_->velocity.read<vec4>(count)));
    hash.add(std::span<const vec4>(state_->heat.read<vec4>(count)));
    hash.add(std::span<const uint>(state_->phase.read<uint>(count)));
    return hash.value();
}

size_t PhysicalMetal::bytes() const {
    return state_->bytes() + heat_->bytes() + flow_->bytes() + fragments_->bytes() + parts_.bytes();
}

} // namespace meltpool
