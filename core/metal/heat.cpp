#include "core/metal/heat.hpp"

#include "core/base/error.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace meltpool {

namespace {

constexpr double kStefanBoltzmann = 5.670374e-8; // W/(m² K⁴)
constexpr double kGasConstant = 8.314462;        // J/(mol K)
constexpr double kPressure = 101325;             // Pa
/// Share of the evaporated metal that does not fall back (Knight 1979: about 18 % does).
constexpr double kEvaporationShare = 0.82;

vec4 evaporationTerms(const Material& material) {
    const double exponent = material.vaporisationHeat * material.molarMass / kGasConstant;
    // q = Lv m', m' = share p sqrt(M/(2 pi R T)), p = 1 bar exp(exponent (1/Tb - 1/T)).
    const double factor = material.vaporisationHeat * kEvaporationShare * kPressure *
                          std::sqrt(material.molarMass / (2 * std::numbers::pi * kGasConstant));
    return {static_cast<float>(material.boilingPoint), static_cast<float>(exponent), static_cast<float>(factor),
            static_cast<float>(material.liquidSpecificHeat.at(material.boilingPoint))};
}

gl::Defines definesOf(const HeatSettings& settings, const Material& material) {
    gl::Defines defines;
    if (settings.ledger) defines["LEDGER"] = "1";
    if (settings.evaporation && material.boilingPoint > 0) defines["EVAPORATION"] = "1";
    return defines;
}

void storageBarrier() {
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

} // namespace

HeatSource HeatSource::sphere(glm::vec3 centre, float radius, float power) {
    HeatSource s;
    s.kind = SOURCE_SPHERE;
    s.place = centre;
    s.size = radius;
    s.power = power;
    return s;
}

HeatSource HeatSource::gaussian(glm::vec3 place, glm::vec3 axis, float sigma, float power) {
    HeatSource s;
    s.kind = SOURCE_GAUSSIAN;
    s.place = place;
    s.axis = axis;
    s.size = sigma;
    s.power = power;
    return s;
}

HeatSource HeatSource::ellipsoid(glm::vec3 place, glm::vec3 axis, glm::vec3 ahead, float halfWidth, float depth,
                                 float front, float rear, float frontFraction, float power) {
    HeatSource s;
    s.kind = SOURCE_ELLIPSOID;
    s.place = place;
    s.axis = axis;
    s.ahead = ahead;
    s.size = front;
    s.shape = {halfWidth, depth, rear, frontFraction};
    s.power = power;
    return s;
}

HeatSource HeatSource::hotTip(glm::vec3 place, float radius, float temperature, float coefficient, float power) {
    HeatSource s;
    s.kind = SOURCE_TIP;
    s.place = place;
    s.size = radius;
    s.shape = {temperature, coefficient, 0, 0};
    s.power = power;
    return s;
}

float HeatSource::reach() const {
    constexpr float kSigmas = 4.5F;     // beyond: 4e-5 of a Gaussian's power
    constexpr float kEllipsoids = 2.2F; // beyond: exp(-3 2.2²) = 5e-7 of the peak
    if (kind == SOURCE_GAUSSIAN) return kSigmas * size;
    if (kind == SOURCE_ELLIPSOID) return kEllipsoids * std::max({size, shape.x, shape.y, shape.z});
    return size;
}

HeatSolver::HeatSolver(gl::ShaderLibrary& shaders, MetalState& state, const Material& material,
                       const HeatSettings& settings)
    : state_(state),
      material_(material),
      settings_(settings),
      refresh_(&shaders.compute("metal/heat_refresh.comp")),
      tiles_(&shaders.compute("metal/heat_tiles.comp")),
      weigh_(&shaders.compute("metal/heat_weigh.comp")),
      total_(&shaders.compute("metal/heat_total.comp")),
      conduct_(&shaders.compute("metal/heat_conduct.comp", definesOf(settings, material))),
      apply_(&shaders.compute("metal/heat_apply.comp", definesOf(settings, material))),
      advance_(&shaders.compute("metal/heat_advance.comp", definesOf(settings, material))),
      blockBuffer_("heat block", sizeof(HeatBlock)),
      table_("heat table", sizeof(HeatTableData)),
      cellTheta_("heat cell theta", state.lattice().cellCount() * sizeof(float)),
      cellPower_("heat cell power", state.lattice().cellCount() * sizeof(float)),
      cellArea_("heat cell area", settings.evaporation ? state.lattice().cellCount() * sizeof(float) : 4),
      tileState_("heat tiles", state.lattice().tileCount() * sizeof(HeatTile)),
      tileStamps_("heat tile stamps", state.lattice().tileCount() * sizeof(int)),
      tileList_("heat tile list", state.lattice().tileCount() * sizeof(uint)),
      indirect_("heat indirect", sizeof(uvec4)),
      partial_("heat partial sums", (HEAT_SOURCES * (state.lattice().tileCount() + 1)) * sizeof(float)),
      ledger_("heat ledger", settings.ledger ? state.capacity() * sizeof(vec4) : 4) {
    auto data = std::make_unique<HeatTableData>();
    for (int piece = 0; piece < 3; ++piece) {
        const HeatTable::Piece& from = state.table().pieces()[static_cast<size_t>(piece)];
        data->start[piece] = from.start;
        data->inverseStep[piece] = from.inverseStep;
        for (int i = 0; i < HEAT_TABLE_ROW; ++i) {
            const auto& sample = from.samples[static_cast<size_t>(i)];
            data->samples[piece * HEAT_TABLE_ROW + i] = {sample[0], sample[1]};
        }
    }
    table_.writeValue(*data);

    const double emissivity = settings.radiation ? material.emissivity.at(material.liquidus) : 0;
    block_.time = vec4(0, settings.convection, settings.ambient, emissivity * kStefanBoltzmann);
    if (settings.evaporation && material.boilingPoint > 0) block_.evaporation = evaporationTerms(material);
    // A tile that cools by itself rests between its turns while they change it by little.
    constexpr double kRestChange = 0.05; // K a step
    const double capacity = state.particleMass() * material.solidSpecificHeat.at(settings.ambient);
    block_.waking =
        vec4(settings.wakingKelvin * material.solidConductivity.at(settings.ambient), 1, kRestChange * capacity, 0);
    block_.step = ivec4(0, 0, settings.meltedLeaves ? 1 : 0, static_cast<int>(state.lattice().tileCount()));
    refresh();
}

double HeatSolver::longestStep(double hottest) const {
    const double alpha = state_.table().largestDiffusivity(state_.density(), settings_.ambient, hottest);
    const auto spacing = static_cast<double>(state_.lattice().spacing);
    return settings_.stepShare * spacing * spacing / alpha;
}

void HeatSolver::bind() const {
    state_.bind();
    blockBuffer_.bindUniform(HEAT_BLOCK);
    table_.bindStorage(HEAT_TABLE);
    cellTheta_.bindStorage(HEAT_CELL_THETA);
    cellPower_.bindStorage(HEAT_CELL_POWER);
    cellArea_.bindStorage(HEAT_CELL_AREA);
    tileState_.bindStorage(HEAT_TILES);
    tileStamps_.bindStorage(HEAT_TILE_STAMPS);
    tileList_.bindStorage(HEAT_TILE_LIST);
    indirect_.bindStorage(HEAT_INDIRECT);
    partial_.bindStorage(HEAT_PARTIAL);
    ledger_.bindStorage(HEAT_LEDGER);
}

void HeatSolver::refresh() {
    blockBuffer_.writeValue(block_);
    bind();
    refresh_->dispatch(state_.lattice().cellCount(), GROUP_SIZE);
    storageBarrier();
}

void HeatSolver::writeBlock(double seconds, std::span<const HeatSource> sources) {
    if (sources.size() > HEAT_SOURCES)
        throw RuntimeFault("at most " + std::to_string(HEAT_SOURCES) + " heat sources can burn at once");
    const MetalLattice& lattice = state_.lattice();
    block_.time.x = static_cast<float>(seconds);
    block_.step.x += 1;
    block_.step.y = static_cast<int>(sources.size());
    sourceGroups_ = 0;
    int offset = HEAT_SOURCES; // the totals stand in front
    for (size_t i = 0; i < sources.size(); ++i) {
        const HeatSource& s = sources[i];
        HeatSourceData& data = block_.sources[i];
        data.place = vec4(s.place, static_cast<float>(s.kind));
        data.axis = vec4(s.axis, s.power);
        data.ahead = vec4(s.ahead, s.size);
        data.shape = s.shape;
        const glm::ivec3 lastTile = lattice.tiles - 1;
        const glm::ivec3 cellLimit = lattice.cells();
        // Clamped before the division, which rounds towards zero, and against sources that reach beyond every number.
        const auto tileAt = [&](glm::vec3 place) {
            const glm::vec3 cell =
                glm::clamp((place - lattice.low) / lattice.spacing, glm::vec3(-1), glm::vec3(cellLimit));
            return glm::ivec3(glm::floor(cell / static_cast<float>(TILE_EDGE)));
        };
        const glm::ivec3 low = glm::clamp(tileAt(s.place - s.reach()), glm::ivec3(0), lastTile);
        const glm::ivec3 high = glm::clamp(tileAt(s.place + s.reach()), glm::ivec3(0), lastTile);
        const glm::ivec3 count = high - low + 1;
        const int groups = count.x * count.y * count.z;
        data.lowTile = ivec4(low, offset);
        data.tileCount = ivec4(count, groups);
        offset += groups;
        sourceGroups_ = std::max(sourceGroups_, groups);
    }
    blockBuffer_.writeValue(block_);
}

void HeatSolver::listTiles() {
    indirect_.writeValue(uvec4(0, 1, 1, 0));
    tiles_->dispatch(state_.lattice().tileCount(), GROUP_SIZE);
}

void HeatSolver::weighSources() {
    const auto sources = static_cast<unsigned>(block_.step.y);
    if (sources == 0) return;
    weigh_->dispatchGroups(static_cast<unsigned>(sourceGroups_), sources);
    storageBarrier();
    total_->dispatchGroups(sources);
}

void HeatSolver::applySources() {
    for (int i = 0; i < block_.step.y; ++i) {
        apply_->set("source", i);
        apply_->dispatchGroups(static_cast<unsigned>(block_.sources[i].tileCount.w));
        storageBarrier(); // two sources may reach the same cell
    }
}

void HeatSolver::step(double seconds, std::span<const HeatSource> sources, gl::Profiler* profiler) {
    const gl::Scope scope(profiler, "heat");
    writeBlock(seconds, sources);
    bind();
    listTiles();    // tile states -> list of tiles, indirect groups
    weighSources(); // cell theta, temperatures -> totals of the sources' weights
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, indirect_.name());
    conduct_->use(); // cell theta, temperatures -> cell power
    glDispatchComputeIndirect(0);
    storageBarrier();
    applySources();  // totals of the weights -> cell power
    advance_->use(); // cell power -> enthalpy, temperature, cell theta, phase
    glDispatchComputeIndirect(0);
    storageBarrier();
}

unsigned HeatSolver::readActiveTiles() const {
    return indirect_.read<uvec4>(1)[0].x;
}

HeatBalance HeatSolver::readBalance() const {
    HeatBalance balance;
    if (!settings_.ledger) return balance;
    for (const vec4& entry : ledger_.read<vec4>(state_.particles())) {
        balance.gained += static_cast<double>(entry.x) + static_cast<double>(entry.y);
        balance.lost += static_cast<double>(entry.z) + static_cast<double>(entry.w);
    }
    return balance;
}

size_t HeatSolver::bytes() const {
    return blockBuffer_.bytes() + table_.bytes() + cellTheta_.bytes() + cellPower_.bytes() + cellArea_.bytes() +
           tileState_.bytes() + tileStamps_.bytes() + tileList_.bytes() + indirect_.bytes() + partial_.bytes() +
           ledger_.bytes();
}

} // namespace meltpool
