#include "core/metal/heat/heat.hpp"

#include "core/base/error.hpp"
#include "core/gl/order.hpp"

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
constexpr double kEvaporates = 0.5; ///< of the boiling point: far below any flux that counts

/// Flux q = Lv m', m' = share p sqrt(M/(2 pi R T)), p = 1 bar exp(exponent (1/Tb - 1/T)).
void writeEvaporation(HeatBlock& block, const Material& material) {
    const double exponent = material.vaporisationHeat * material.molarMass / kGasConstant;
    const double factor = material.vaporisationHeat * kEvaporationShare * kPressure *
                          std::sqrt(material.molarMass / (2 * std::numbers::pi * kGasConstant));
    block.boilingPoint = static_cast<float>(material.boilingPoint);
    block.evaporatesFrom =
        static_cast<float>(material.evaporatesFrom > 0 ? material.evaporatesFrom : kEvaporates * material.boilingPoint);
    block.evaporationExponent = static_cast<float>(exponent);
    block.evaporationFactor = static_cast<float>(factor);
    block.liquidSpecificHeat = static_cast<float>(material.liquidSpecificHeat.at(material.boilingPoint));
}

gl::Defines definesOf(const HeatSettings& settings, const Material& material) {
    gl::Defines defines;
    if (settings.ledger) defines["LEDGER"] = "1";
    if (settings.evaporation && material.boilingPoint > 0) defines["EVAPORATION"] = "1";
    if (settings.ledStirring) defines["LED_STIRRING"] = "1";
    return defines;
}

constexpr uvec4 kNoGroups(0, 1, 1, 0);
constexpr HeatControl kNothingListed{{1, 1, 1, 0}, kNoGroups,        kNoGroups, kNoGroups,        kNoGroups,
                                     kNoGroups,    uvec3(kNoGroups), 0,         uvec3(kNoGroups), 0};
constexpr size_t kTileLists = 3; ///< in HEAT_LISTS, before the list of slots
constexpr size_t kOffLatticeDispatch = offsetof(HeatControl, offLatticeGroups);

void storageBarrier() {
    gl::memoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

void indirectBarrier() {
    gl::memoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
}

} // namespace

HeatSolver::HeatSolver(gl::ShaderLibrary& shaders, MetalState& state, const Material& material,
                       const HeatSettings& settings)
    : state_(state), material_(material), settings_(settings) {
    const gl::Defines defines = definesOf(settings, material);
    refresh_ = &shaders.compute("metal/heat/refresh.comp");
    listOffLattice_ = &shaders.compute("metal/heat/list_off_lattice.comp");
    deposit_ = &shaders.compute("metal/heat/deposit.comp");
    listTiles_ = &shaders.compute("metal/heat/list_tiles.comp", defines);
    averageCells_ = &shaders.compute("metal/heat/average_cells.comp");
    listRows_ = &shaders.compute("metal/heat/list_rows.comp");
    sourceWeights_ = &shaders.compute("metal/heat/source_weights.comp");
    normaliseSources_ = &shaders.compute("metal/heat/normalise_sources.comp");
    conductUnreached_ = &shaders.compute("metal/heat/conduct_mixed.comp", defines);
    gl::Defines withSources = defines;
    withSources["SOURCES"] = "1";
    conductReached_ = &shaders.compute("metal/heat/conduct_mixed.comp", withSources);
    advanceOffLattice_ = &shaders.compute("metal/heat/advance_off_lattice.comp", defines);
    conductPlain_ = &shaders.compute("metal/heat/conduct_plain.comp", defines);
    advanceMixed_ = &shaders.compute("metal/heat/advance_mixed.comp", defines);
    fold_ = &shaders.compute("metal/heat/fold.comp");
    makeBuffers();
    makeTexels();
    begin();
}

void HeatSolver::begin() {
    block_ = {};
    time_ = 0;
    regroupings_ = 0;
    takeTable();
    refresh();
}

void HeatSolver::reset() {
    for (const gl::Buffer* buffer :
         {&cellTheta_, &cellWeight_, &cellSums_, &cellRanges_, &tiles_, &tileStamps_, &lists_, &knownCells_, &ledger_})
        buffer->clear();
    begin();
}

void HeatSolver::takeTable() {
    writeTable();
    prepareBlock();
}

void HeatSolver::takeCapacity() {
    const size_t slots = state_.capacity();
    lists_.resize((kTileLists * state_.lattice().tileCount() + slots) * sizeof(uint));
    knownCells_.resize(slots * sizeof(uint));
    if (settings_.ledger) ledger_.resize((state_.lattice().cellCount() + slots) * sizeof(vec4));
    texels_.clear();
    makeTexels();
}

void HeatSolver::makeBuffers() {
    const size_t cells = state_.lattice().cellCount();
    const size_t tiles = state_.lattice().tileCount();
    const size_t slots = state_.capacity();
    blockBuffer_ = gl::Buffer("heat block", sizeof(HeatBlock));
    table_ = gl::Buffer("heat table", HEAT_TABLE_ENTRIES * sizeof(vec4));
    cellTheta_ = gl::Buffer::gpuOnly("heat cell theta", 2 * cells * sizeof(float));
    cellWeight_ = gl::Buffer::gpuOnly("heat cell weight", cells * sizeof(uint));
    cellSums_ = gl::Buffer::gpuOnly("heat cell sums", cells * sizeof(uint));
    cellRanges_ = gl::Buffer::gpuOnly("heat cell ranges", cells * sizeof(uvec2));
    tiles_ = gl::Buffer::gpuOnly("heat tiles", tiles * sizeof(HeatTile));
    tileStamps_ = gl::Buffer::gpuOnly("heat tile stamps", tiles * sizeof(int));
    lists_ = gl::Buffer::gpuOnly("heat lists", (kTileLists * tiles + slots) * sizeof(uint));
    listedRows_ = gl::Buffer::gpuOnly("heat listed rows", TILE_ROWS * tiles * sizeof(uint));
    control_ = gl::Buffer("heat control", sizeof(HeatControl));
    knownCells_ = gl::Buffer::gpuOnly("heat known cells", slots * sizeof(uint));
    ledger_ = gl::Buffer::gpuOnly("heat ledger", settings_.ledger ? (cells + slots) * sizeof(vec4) : 4);
}

/// They hold within a step, so that none is kept where there must be more.
void HeatSolver::makeSourceSums(int count) {
    const size_t bytes = static_cast<size_t>(count) * sizeof(float);
    if (sourceSums_.bytes() < bytes) sourceSums_ = gl::Buffer::gpuOnly("heat source sums", bytes + bytes / 2);
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
    table_.write(std::span<const vec4>(samples));
}

void HeatSolver::makeTexels() {
    const auto see = [&](const gl::Buffer& buffer, GLenum format, size_t texelBytes, GLuint unit) {
        texels_.push_back({gl::BufferView("heat texels", buffer, format, texelBytes), unit});
    };
    see(table_, GL_RGBA32F, sizeof(vec4), HEAT_TEXELS_TABLE);
    see(cellTheta_, GL_R32F, sizeof(float), HEAT_TEXELS_THETA);
    see(cellWeight_, GL_R32UI, sizeof(uint), HEAT_TEXELS_WEIGHT);
    see(tileStamps_, GL_R32I, sizeof(int), HEAT_TEXELS_STAMPS);
    see(tiles_, GL_RGBA32I, sizeof(ivec4), HEAT_TEXELS_TILES);
    see(lists_, GL_R32UI, sizeof(uint), HEAT_TEXELS_LISTS);
    see(state_.latticeSlots, GL_R32UI, sizeof(uint), HEAT_TEXELS_LATTICE);
    see(state_.heat, GL_RGBA32F, sizeof(vec4), HEAT_TEXELS_HEATS);
    see(state_.position, GL_RGBA32F, sizeof(vec4), HEAT_TEXELS_POSITIONS);
    see(state_.phase, GL_R32UI, sizeof(uint), HEAT_TEXELS_PHASES);
    see(cellTheta_, GL_RGBA32F, sizeof(vec4), HEAT_TEXELS_THETA_ROWS);
    see(state_.latticeSlots, GL_RGBA32UI, sizeof(uvec4), HEAT_TEXELS_LATTICE_ROWS);
    see(listedRows_, GL_R32UI, sizeof(uint), HEAT_TEXELS_LISTED_ROWS);
}

void HeatSolver::prepareBlock() {
    const double emissivity = settings_.radiation ? material_.emissivity.at(material_.liquidus) : 0;
    block_.convection = static_cast<float>(settings_.convection);
    block_.ambient = static_cast<float>(settings_.ambient);
    block_.radiation = static_cast<float>(emissivity * kStefanBoltzmann);
    if (settings_.evaporation && material_.boilingPoint > 0) writeEvaporation(block_, material_);
    // A sleeping tile with a warm surface cools by this much a step at most.
    constexpr double kSleepingChange = 0.05; // K a step
    const double capacity = state_.particleMass() * material_.solidSpecificHeat.at(settings_.ambient);
    const double conductivity = material_.solidConductivity.at(settings_.ambient);
    block_.wakingThetaDifference = static_cast<float>(settings_.wakingKelvin * conductivity);
    block_.warmAboveAmbient = 1;
    block_.mostTurns = 20;
    block_.wakingLoss = static_cast<float>(kSleepingChange * capacity);
    block_.meltLeavesLattice = settings_.meltedLeaves ? 1 : 0;
    block_.liquidTheta = static_cast<float>(state_.table().kirchhoffAt(state_.table().liquidusEnthalpy()));
    block_.tileCount = static_cast<int>(state_.lattice().tileCount());
    // So many particles' worth of the hottest metal fit into one sum of 32 bits: drops may be fed in one place.
    constexpr double kMostInCell = 32;
    constexpr double kHottest = 8000;
    constexpr double kWholeSum = 4294967295.0;
    const double most = state_.table().kirchhoffAt(state_.table().enthalpyAt(kHottest));
    block_.thetaUnit = static_cast<float>(kMostInCell * most / kWholeSum);
    block_.weldingTableNormal = settings_.tableNormal;
    block_.weldingTableHeight = static_cast<float>(settings_.tableHeight);
    block_.weldingTableConductance = static_cast<float>(settings_.tableConductance);
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
    state_.frozenAt.bindStorage(HEAT_FROZEN_AT);
    cellTheta_.bindStorage(HEAT_CELL_THETA);
    cellWeight_.bindStorage(HEAT_CELL_WEIGHT);
    cellSums_.bindStorage(HEAT_CELL_SUMS);
    tiles_.bindStorage(HEAT_TILES);
    cellRanges_.bindStorage(HEAT_CELL_RANGE);
    tileStamps_.bindStorage(HEAT_TILE_STAMPS);
    lists_.bindStorage(HEAT_LISTS);
    control_.bindStorage(HEAT_CONTROL);
    knownCells_.bindStorage(HEAT_KNOWN_CELLS);
    ledger_.bindStorage(HEAT_LEDGER);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, control_.name());
}

void HeatSolver::refresh() {
    blockBuffer_.writeValue(block_);
    control_.writeValue(kNothingListed);
    searched_ = 0;
    bind();
    knownCells_.clear();
    refresh_->dispatch(state_.lattice().cellCount(), GROUP_SIZE);
    storageBarrier();
}

void HeatSolver::writeSource(HeatSourceData& data, const HeatSource& source, int firstRowSum) const {
    const MetalLattice& lattice = state_.lattice();
    data.position = source.position;
    data.kind = source.kind;
    data.axis = source.axis;
    data.power = source.power;
    data.travel = source.travel;
    data.size = source.size;
    data.halfWidth = source.halfWidth;
    data.depth = source.depth;
    data.rear = source.rear;
    data.frontFraction = source.frontFraction;
    data.tipTemperature = source.tipTemperature;
    data.tipConductance = source.tipConductance;
    data.before = source.before;
    data.beyond = source.beyond;
    data.fullWeight = source.fullWeight;
    const glm::ivec3 lastTile = lattice.tiles - 1;
    const glm::ivec3 cellLimit = lattice.cells();
    // Clamped before the division, which rounds towards zero, and against sources that reach beyond every number.
    const auto tileAt = [&](glm::vec3 place) {
        const glm::vec3 cell = glm::clamp((place - lattice.low) / lattice.spacing, glm::vec3(-1), glm::vec3(cellLimit));
        return glm::ivec3(glm::floor(cell / static_cast<float>(TILE_EDGE)));
    };
    const glm::ivec3 low = glm::clamp(tileAt(source.position - source.reach()), glm::ivec3(0), lastTile);
    const glm::ivec3 high = glm::clamp(tileAt(source.position + source.reach()), glm::ivec3(0), lastTile);
    data.firstTile = low;
    data.firstRowSum = firstRowSum;
    data.tileExtent = high - low + 1;
    data.tileCount = data.tileExtent.x * data.tileExtent.y * data.tileExtent.z;
}

void HeatSolver::writeBlock(double seconds, std::span<const HeatSource> sources) {
    if (sources.size() > HEAT_SOURCES)
        throw RuntimeFault("at most " + std::to_string(HEAT_SOURCES) + " heat sources can burn at once");
    block_.timeStep = static_cast<float>(seconds);
    block_.stepNumber += 1;
    block_.sourceCount = static_cast<int>(sources.size());
    time_ += seconds;
    block_.time = static_cast<float>(time_);
    block_.endTime = static_cast<uint>(std::llround(time_ * 1e6)); // wraps, which differences do not mind
    int firstRowSum = HEAT_SOURCES;                                // behind the sums of the sources
    for (size_t i = 0; i < sources.size(); ++i) {
        writeSource(block_.sources[i], sources[i], firstRowSum);
        firstRowSum += TILE_ROWS * block_.sources[i].tileCount;
    }
    makeSourceSums(firstRowSum);
    blockBuffer_.writeValue(block_);
}

void HeatSolver::indirect(const gl::Program& program, size_t groups) const {
    program.dispatchIndirect(groups);
}

/// The list already holds the metal that heat itself took off the lattice.
void HeatSolver::depositOffLattice() {
    const unsigned regroupings = state_.regroupings() + state_.labellings();
    const size_t first = regroupings_ == regroupings ? searched_ : 0;
    regroupings_ = regroupings;
    searched_ = state_.particles();
    if (first < searched_) {
        listOffLattice_->set("first", static_cast<unsigned>(first));
        listOffLattice_->set("last", static_cast<unsigned>(searched_));
        listOffLattice_->dispatch(searched_ - first, GROUP_SIZE); // phases -> list of slots off the lattice
        indirectBarrier();
    }
    indirect(*deposit_,
             kOffLatticeDispatch); // enthalpies, positions -> cell sums, weights, tiles with metal off the lattice
    indirectBarrier();
}

void HeatSolver::listTiles() {
    // The lists of slots off the lattice and of tiles that ever held metal are kept.
    control_.write(std::as_bytes(std::span(&kNothingListed, 1)).first(offsetof(HeatControl, offLatticeGroups)));
    listedRows_.bindStorage(HEAT_LISTED_ROWS);
    indirect(*listTiles_, offsetof(HeatControl, metalTileGroups)); // tiles -> lists of tiles, of plain tiles' rows
    indirectBarrier();
    indirect(*averageCells_, offsetof(HeatControl, offLatticeTiles)); // cell sums, weights -> cell theta
    storageBarrier();
    indirect(*listRows_, offsetof(HeatControl, mixedTiles)); // cell theta -> list of rows with metal
    indirectBarrier();
}

void HeatSolver::normaliseSources() {
    const auto sources = static_cast<unsigned>(block_.sourceCount);
    sourceSums_.bindStorage(HEAT_SOURCE_SUMS);
    if (sources == 0) return;
    gl::memoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    sourceSums_.clear();                                           // of rows without metal, too
    indirect(*sourceWeights_, offsetof(HeatControl, reachedRows)); // cell theta, weight -> sum of weights a row
    storageBarrier();
    normaliseSources_->dispatchGroups(sources); // -> sum of weights a source
    storageBarrier();
}

void HeatSolver::stepMixedCells() {
    // Cell theta, weight, sums of sources -> cell power, area.
    indirect(*conductReached_, offsetof(HeatControl, reachedRows));
    indirect(*conductUnreached_, offsetof(HeatControl, unreachedRows));
    storageBarrier();
    knownCells_.bindStorage(HEAT_KNOWN_CELLS);
    indirect(*advanceOffLattice_, kOffLatticeDispatch); // cell power, area, theta -> enthalpy of metal off the lattice
    storageBarrier();
}

/// Metal that melts here is off the lattice from the next step on. The plain tiles come first: they read what the mixed
/// ones change.
void HeatSolver::stepLatticeMetal() {
    indirect(*conductPlain_, offsetof(HeatControl, plainRows)); // cell theta -> enthalpy, theta in the other half
    storageBarrier();
    // Cell power, area -> enthalpy of the lattice, cell theta; cell sums cleared.
    indirect(*advanceMixed_, offsetof(HeatControl, mixedRows));
    indirectBarrier();
}

void HeatSolver::step(double seconds, std::span<const HeatSource> sources, gl::Profiler* profiler) {
    const gl::Scope scope(profiler, "heat");
    writeBlock(seconds, sources);
    bind();
    storageBarrier(); // heat reads as texels what others wrote
    const auto pass = [&](const char* name, void (HeatSolver::*work)()) {
        const gl::Scope part(profiler, name);
        (this->*work)();
    };
    pass("heat off-lattice shares", &HeatSolver::depositOffLattice);
    pass("heat tiles", &HeatSolver::listTiles);
    pass("heat sources", &HeatSolver::normaliseSources);
    pass("heat mixed tiles", &HeatSolver::stepMixedCells);
    pass("heat lattice metal", &HeatSolver::stepLatticeMetal);
}

OffLatticeList HeatSolver::offLattice() const {
    return {lists_, kTileLists * state_.lattice().tileCount(), control_, offsetof(HeatControl, offLatticeCount),
            kOffLatticeDispatch};
}

unsigned HeatSolver::readActiveTiles() const {
    const std::vector<int> stamps = tileStamps_.read<int>(state_.lattice().tileCount());
    return static_cast<unsigned>(std::count_if(
        stamps.begin(), stamps.end(), [&](int stamp) { return stamp >> TILE_STEP_SHIFT == block_.stepNumber; }));
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
         {&blockBuffer_, &table_, &cellTheta_, &cellWeight_, &cellSums_, &cellRanges_, &tiles_, &tileStamps_, &lists_,
          &listedRows_, &control_, &knownCells_, &sourceSums_, &ledger_})
        sum += buffer->bytes();
    return sum;
}

} // namespace meltpool
