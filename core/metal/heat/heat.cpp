#include "core/metal/heat/heat.hpp"

#include "core/metal/heat/heat_barriers.hpp"

#include <cmath>
#include <numbers>

namespace meltpool {

namespace {

constexpr double kStefanBoltzmann = 5.670374e-8; // W/(m² K⁴)
constexpr double kGasConstant = 8.314462;        // J/(mol K)
constexpr double kPressure = 101325;             // Pa
/// Share of the evaporated metal that does not fall back (Knight 1979: about 18 % does).
constexpr double kEvaporationShare = 0.82;
constexpr double kEvaporates = 0.5; ///< share of the boiling point: far below any flux that counts

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
    if (settings.directedMixing) defines["DIRECTED_MIXING"] = "1";
    return defines;
}

} // namespace

HeatSolver::HeatSolver(gl::ShaderLibrary& shaders, MetalState& state, const Material& material,
                       const HeatSettings& settings)
    : state_(state),
      material_(material),
      settings_(settings),
      tiles_(shaders, definesOf(settings, material), state.lattice().tileCount(), state.capacity()),
      sources_(shaders),
      conduction_(shaders, definesOf(settings, material), state.lattice().cellCount(), state.capacity(),
                  settings.ledger),
      refresh_(shaders.compute("metal/heat/refresh.comp")),
      xorOutDerived_(shaders.compute("metal/heat/xor_out_derived.comp")),
      blockBuffer_("heat block", sizeof(HeatBlock)) {
    makeTexels();
    begin();
}

void HeatSolver::begin() {
    block_ = {};
    time_ = 0;
    regroupings_ = 0;
    onTableChanged();
    refresh();
}

void HeatSolver::reset() {
    tiles_.clear();
    conduction_.clear();
    begin();
}

void HeatSolver::onTableChanged() {
    conduction_.setTable(state_.table(), block_);
    prepareBlock();
}

void HeatSolver::onCapacityChanged() {
    tiles_.setSlots(state_.capacity());
    conduction_.setSlots(state_.capacity());
    texels_.clear();
    makeTexels();
}

void HeatSolver::makeTexels() {
    const auto see = [&](const gl::Buffer& buffer, GLenum format, size_t texelBytes, GLuint unit) {
        texels_.push_back({gl::BufferView("heat texels", buffer, format, texelBytes), unit});
    };
    see(state_.latticeSlots, GL_R32UI, sizeof(uint), HEAT_TEXELS_LATTICE);
    see(state_.heat, GL_RGBA32F, sizeof(vec4), HEAT_TEXELS_HEATS);
    see(state_.position, GL_RGBA32F, sizeof(vec4), HEAT_TEXELS_POSITIONS);
    see(state_.phase, GL_R32UI, sizeof(uint), HEAT_TEXELS_PHASES);
    see(state_.latticeSlots, GL_RGBA32UI, sizeof(uvec4), HEAT_TEXELS_LATTICE_ROWS);
}

void HeatSolver::prepareBlock() {
    const double emissivity = settings_.radiation ? material_.emissivity.at(material_.liquidus) : 0;
    block_.convection = static_cast<float>(settings_.convection);
    block_.ambient = static_cast<float>(settings_.ambient);
    block_.radiation = static_cast<float>(emissivity * kStefanBoltzmann);
    if (settings_.evaporation && material_.boilingPoint > 0) writeEvaporation(block_, material_);
    // Largest cooling of a sleeping tile with a warm surface in a step.
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
    // Capacity of one 32-bit sum, in particles of the hottest metal: drops may be fed in one place.
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
    conduction_.bind();
    tiles_.bind();
}

void HeatSolver::refresh() {
    blockBuffer_.writeValue(block_);
    tiles_.forget();
    searched_ = 0;
    bind();
    refresh_.dispatch(state_.lattice().cellCount(), GROUP_SIZE);
    storageBarrier();
}

void HeatSolver::writeBlock(double seconds, std::span<const HeatSource> sources) {
    sources_.write(sources, state_.lattice(), block_);
    block_.timeStep = static_cast<float>(seconds);
    block_.stepNumber += 1;
    time_ += seconds;
    block_.time = static_cast<float>(time_);
    block_.endTime = static_cast<uint>(std::llround(time_ * 1e6)); // wraps; differences stay correct
    blockBuffer_.writeValue(block_);
}

/// Searches only slots that came since the last step, unless the state has regrouped the metal.
void HeatSolver::listOffLattice() {
    const unsigned regroupings = state_.regroupings() + state_.labellings();
    const size_t first = regroupings_ == regroupings ? searched_ : 0;
    regroupings_ = regroupings;
    searched_ = state_.particles();
    tiles_.listOffLattice(first, searched_);
}

void HeatSolver::step(double seconds, std::span<const HeatSource> sources, gl::Profiler* profiler) {
    const gl::Scope scope(profiler, "heat");
    writeBlock(seconds, sources);
    bind();
    storageBarrier(); // heat reads the writes of others as texels
    {
        const gl::Scope part(profiler, "heat off-lattice shares");
        listOffLattice();
        conduction_.depositOffLattice();
    }
    {
        const gl::Scope part(profiler, "heat tiles");
        tiles_.listTiles();
        conduction_.averageCells();
        tiles_.listMixedRows();
    }
    {
        const gl::Scope part(profiler, "heat sources");
        sources_.sum();
    }
    {
        const gl::Scope part(profiler, "heat mixed tiles");
        conduction_.conductMixedTiles();
        tiles_.bindKnownCells();
        conduction_.advanceOffLattice();
    }
    {
        const gl::Scope part(profiler, "heat lattice metal");
        conduction_.advanceLattice();
    }
}

void HeatSolver::transfer(gl::StateArchive& archive) {
    archive.values(block_, regroupings_, time_);
    archive.count(searched_, state_.capacity());
    conduction_.transfer(archive);
    tiles_.transfer(archive);
    if (archive.restores()) blockBuffer_.writeValue(block_);
}

void HeatSolver::xorOutDerivedState() {
    const size_t cells = state_.lattice().cellCount();
    bind();
    xorOutDerived_.set("cells", static_cast<unsigned>(cells));
    xorOutDerived_.set("slots", static_cast<unsigned>(state_.particles()));
    xorOutDerived_.dispatch(cells + state_.particles(), GROUP_SIZE);
}

size_t HeatSolver::bytes() const {
    return blockBuffer_.bytes() + tiles_.bytes() + sources_.bytes() + conduction_.bytes();
}

} // namespace meltpool
