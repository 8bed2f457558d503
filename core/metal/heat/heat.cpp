#include "core/metal/heat/heat.hpp"

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

constexpr uvec4 kNoGroups(0, 1, 1, 0);

void storageBarrier() {
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

void indirectBarrier() {
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
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
    : state_(state), material_(material), settings_(settings) {
    const gl::Defines defines = definesOf(settings, material);
    refresh_ = &shaders.compute("metal/heat/refresh.comp");
    collect_ = &shaders.compute("metal/heat/collect.comp");
    deposit_ = &shaders.compute("metal/heat/deposit.comp");
    tiles_ = &shaders.compute("metal/heat/tiles.comp", defines);
    mean_ = &shaders.compute("metal/heat/mean.comp");
    weigh_ = &shaders.compute("metal/heat/weigh.comp");
    total_ = &shaders.compute("metal/heat/total.comp");
    spread_ = &shaders.compute("metal/heat/spread.comp", defines);
    conduct_ = &shaders.compute("metal/heat/conduct.comp", defines);
    advanceLoose_ = &shaders.compute("metal/heat/advance_loose.comp", defines);
    advance_ = &shaders.compute("metal/heat/advance.comp", defines);
    makeBuffers();
    writeTable();
    makeTexels();
    prepareBlock();
    refresh();
}

void HeatSolver::makeBuffers() {
    const size_t cells = state_.lattice().cellCount();
    const size_t tiles = state_.lattice().tileCount();
    const size_t slots = state_.capacity();
    blockBuffer_ = gl::Buffer("heat block", sizeof(HeatBlock));
    cellTheta_ = gl::Buffer("heat cell theta", 2 * cells * sizeof(float));
    cellWeight_ = gl::Buffer("heat cell weight", cells * sizeof(float));
    cellPower_ = gl::Buffer("heat cell power", cells * sizeof(float));
    cellArea_ = gl::Buffer("heat cell area", cells * sizeof(float));
    cellSums_ = gl::Buffer("heat cell sums", cells * sizeof(HeatSum));
    tileState_ = gl::Buffer("heat tiles", tiles * sizeof(HeatTile));
    tileStamps_ = gl::Buffer("heat tile stamps", tiles * sizeof(int));
    lists_ = gl::Buffer("heat lists", (3 * tiles + slots) * sizeof(uint));
    control_ = gl::Buffer("heat control", sizeof(HeatControl));
    homes_ = gl::Buffer("heat homes", slots * sizeof(uint));
    partial_ = gl::Buffer("heat partial sums", HEAT_SOURCES * (tiles + 1) * sizeof(float));
    ledger_ = gl::Buffer("heat ledger", settings_.ledger ? (cells + slots) * sizeof(vec4) : 4);
}

void HeatSolver::writeTable() {
    std::vector<vec4> samples;
    for (int piece = 0; piece < 3; ++piece) {
        const HeatTable::Piece& from = state_.table().pieces()[static_cast<size_t>(piece)];
        block_.tableStart[piece] = from.start;
        block_.tableScale[piece] = from.inverseStep;
        for (size_t i = 0; i < HEAT_TABLE_ROW; ++i) {
            const auto& own = from.samples[i];
            const auto& next = from.samples[std::min<size_t>(i + 1, HEAT_TABLE_STEPS)];
            samples.emplace_back(own[0], own[1], next[0], next[1]);
        }
    }
    table_ = gl::Buffer("heat table", std::span<const vec4>(samples));
}

void HeatSolver::makeTexels() {
    const auto see = [&](const gl::Buffer& buffer, GLenum format, size_t texelBytes, GLuint unit) {
        texels_.push_back({gl::BufferView("heat texels", buffer, format, texelBytes), unit});
    };
    see(table_, GL_RGBA32F, sizeof(vec4), HEAT_TEXELS_TABLE);
    see(cellTheta_, GL_R32F, sizeof(float), HEAT_TEXELS_THETA);
    see(cellWeight_, GL_R32F, sizeof(float), HEAT_TEXELS_WEIGHT);
    see(tileStamps_, GL_R32I, sizeof(int), HEAT_TEXELS_STAMPS);
    see(tileState_, GL_RGBA32I, sizeof(ivec4), HEAT_TEXELS_TILES);
    see(lists_, GL_R32UI, sizeof(uint), HEAT_TEXELS_LISTS);
    see(state_.latticeSlots, GL_R32UI, sizeof(uint), HEAT_TEXELS_LATTICE);
    see(state_.heat, GL_RGBA32F, sizeof(vec4), HEAT_TEXELS_HEATS);
    see(state_.position, GL_RGBA32F, sizeof(vec4), HEAT_TEXELS_POSITIONS);
    see(state_.phase, GL_R32UI, sizeof(uint), HEAT_TEXELS_PHASES);
    see(cellTheta_, GL_RGBA32F, sizeof(vec4), HEAT_TEXELS_THETA_ROWS);
    see(state_.latticeSlots, GL_RGBA32UI, sizeof(uvec4), HEAT_TEXELS_LATTICE_ROWS);
}

void HeatSolver::prepareBlock() {
    const double emissivity = settings_.radiation ? material_.emissivity.at(material_.liquidus) : 0;
    block_.time = vec4(0, settings_.convection, settings_.ambient, emissivity * kStefanBoltzmann);
    if (settings_.evaporation && material_.boilingPoint > 0) block_.evaporation = evaporationTerms(material_);
    // A tile that cools by itself rests between its turns while they change it by little.
    constexpr double kRestChange = 0.05; // K a step
    const double capacity = state_.particleMass() * material_.solidSpecificHeat.at(settings_.ambient);
    block_.waking =
        vec4(settings_.wakingKelvin * material_.solidConductivity.at(settings_.ambient), 1, kRestChange * capacity, 0);
    block_.step = ivec4(0, 0, settings_.meltedLeaves ? 1 : 0, static_cast<int>(state_.lattice().tileCount()));
    // Eight particles' worth of the hottest metal fit into one sum of 32 bits.
    constexpr double kHottest = 8000;
    constexpr double kWholeSum = 4294967295.0;
    const double most = state_.table().kirchhoffAt(state_.table().enthalpyAt(kHottest));
    block_.loose = vec4(8 * most / kWholeSum, 0, settings_.tableHeight, settings_.tableConductance);
}

double HeatSolver::longestStep(double hottest) const {
    const double alpha = state_.table().largestDiffusivity(state_.density(), settings_.ambient, hottest);
    const auto spacing = static_cast<double>(state_.lattice().spacing);
    return settings_.stepShare * spacing * spacing / alpha;
}

void HeatSolver::bind() const {
    state_.bind();
    blockBuffer_.bindUniform(HEAT_BLOCK);
    for (const Texels& texels : texels_)
        texels.view.bind(texels.unit);
    state_.changes.bindStorage(HEAT_CHANGES);
    cellTheta_.bindStorage(HEAT_CELL_THETA);
    cellWeight_.bindStorage(HEAT_CELL_WEIGHT);
    cellPower_.bindStorage(HEAT_CELL_POWER);
    cellArea_.bindStorage(HEAT_CELL_AREA);
    cellSums_.bindStorage(HEAT_CELL_SUMS);
    tileState_.bindStorage(HEAT_TILES);
    tileStamps_.bindStorage(HEAT_TILE_STAMPS);
    lists_.bindStorage(HEAT_LISTS);
    control_.bindStorage(HEAT_CONTROL);
    homes_.bindStorage(HEAT_HOMES);
    ledger_.bindStorage(HEAT_LEDGER);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, control_.name());
}

void HeatSolver::refresh() {
    blockBuffer_.writeValue(block_);
    control_.writeValue(HeatControl{kNoGroups, kNoGroups, kNoGroups, kNoGroups});
    looked_ = 0;
    bind();
    homes_.clear();
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
    time_ += seconds;
    block_.clock.x = static_cast<uint>(std::llround(time_ * 1e6)); // wraps, which differences do not mind
    int offset = HEAT_SOURCES;                                     // the totals stand in front
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
    }
    blockBuffer_.writeValue(block_);
}

void HeatSolver::indirect(const gl::Program& program, size_t groups) const {
    program.dispatchIndirect(groups);
}

/// Metal that heat itself takes off the lattice is in the list by then.
void HeatSolver::findLoose() {
    const size_t first = regroupings_ == state_.regroupings() ? looked_ : 0;
    regroupings_ = state_.regroupings();
    looked_ = state_.particles();
    if (first < looked_) {
        collect_->set("first", static_cast<unsigned>(first));
        collect_->set("last", static_cast<unsigned>(looked_));
        collect_->dispatch(looked_ - first, GROUP_SIZE); // phases -> list of loose slots
        indirectBarrier();
    }
    indirect(*deposit_, offsetof(HeatControl, loose)); // enthalpies, positions -> cell sums, tiles with loose metal
    storageBarrier();
}

void HeatSolver::listTiles() {
    control_.writeValue(std::array{kNoGroups, kNoGroups, kNoGroups}); // the loose ones are kept
    tiles_->dispatch(state_.lattice().tileCount(), GROUP_SIZE);       // tile states -> lists of tiles
    indirectBarrier();
    indirect(*mean_, offsetof(HeatControl, sums)); // cell sums -> cell theta, weight
    storageBarrier();
}

void HeatSolver::weighSources() {
    const auto sources = static_cast<unsigned>(block_.step.y);
    partial_.bindStorage(HEAT_PARTIAL);
    if (sources == 0) return;
    indirect(*weigh_, offsetof(HeatControl, mixed)); // cell theta, weight -> partial sums
    storageBarrier();
    total_->dispatchGroups(sources); // partial sums -> totals
    storageBarrier();
}

void HeatSolver::conduct() {
    indirect(*conduct_, offsetof(HeatControl, mixed)); // cell theta, weight, totals -> cell power, area
    storageBarrier();
    homes_.bindStorage(HEAT_HOMES);
    indirect(*advanceLoose_, offsetof(HeatControl, loose)); // cell power, theta -> enthalpy of loose metal
    storageBarrier();
}

/// Metal that melts here is loose from the next step on. The plain tiles come first: they read what the mixed ones
/// change.
void HeatSolver::advance() {
    indirect(*spread_, offsetof(HeatControl, plain)); // cell theta -> enthalpy, theta in the other half
    storageBarrier();
    indirect(*advance_,
             offsetof(HeatControl, mixed)); // cell power -> enthalpy of the lattice, cell theta; sums cleared
    indirectBarrier();
}

void HeatSolver::step(double seconds, std::span<const HeatSource> sources, gl::Profiler* profiler) {
    const gl::Scope scope(profiler, "heat");
    writeBlock(seconds, sources);
    bind();
    storageBarrier(); // whatever others wrote is read as texels
    const auto pass = [&](const char* name, void (HeatSolver::*work)()) {
        const gl::Scope part(profiler, name);
        (this->*work)();
    };
    pass("heat loose metal", &HeatSolver::findLoose);
    pass("heat tiles", &HeatSolver::listTiles);
    pass("heat sources weighed", &HeatSolver::weighSources);
    pass("heat mixed tiles", &HeatSolver::conduct);
    pass("heat plain tiles", &HeatSolver::advance);
}

OffLatticeList HeatSolver::offLattice() const {
    const size_t arguments = offsetof(HeatControl, loose);
    return {lists_, 3 * state_.lattice().tileCount(), control_, arguments + 3 * sizeof(uint), arguments};
}

unsigned HeatSolver::readActiveTiles() const {
    const auto control = control_.read<HeatControl>(1)[0];
    return control.plain.x + control.mixed.x;
}

HeatBalance HeatSolver::readBalance() const {
    HeatBalance balance;
    if (!settings_.ledger) return balance;
    for (const vec4& entry : ledger_.read<vec4>(ledger_.bytes() / sizeof(vec4))) {
        balance.gained += static_cast<double>(entry.x) + static_cast<double>(entry.y);
        balance.lost += static_cast<double>(entry.z) + static_cast<double>(entry.w);
    }
    return balance;
}

size_t HeatSolver::bytes() const {
    size_t sum = 0;
    for (const gl::Buffer* buffer :
         {&blockBuffer_, &table_, &cellTheta_, &cellWeight_, &cellPower_, &cellArea_, &cellSums_, &tileState_,
          &tileStamps_, &lists_, &control_, &homes_, &partial_, &ledger_})
        sum += buffer->bytes();
    return sum;
}

} // namespace meltpool
