#include "core/validation/case_weld.hpp"

#include "core/base/error.hpp"
#include "core/validation/case_size.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr double kFillerSpare = 1.1; // factor on the room for wire

WeldSurroundings surroundings(const ValidationCase& from, const ProcessSettings& settings, double ambient,
                              double seconds) {
    WeldSurroundings around;
    around.ambient = ambient;
    around.fillerRoom =
        static_cast<size_t>(kFillerSpare * caseFillerRate(from, settings) * seconds / std::pow(from.spacing, 3)) + 100;
    return around;
}

/// Returns the case with a bound of its own for the deposit, whatever the case's tolerance.
ValidationCase withinThree(ValidationCase from) {
    from.tolerancePercent = 3;
    return from;
}

} // namespace

void requireWeldRoom(const ValidationCase& from, const ProcessSettings& settings, double volume, double seconds) {
    const double count = (volume + caseFillerRate(from, settings) * seconds) / std::pow(from.spacing, 3);
    const double cells = 4 * count; // cells with the space around the workpiece
    requireCapacity(from, {cells, count, count, cells});
}

CaseWeld::CaseWeld(const ValidationCase& from, gl::ShaderLibrary& shaders, const ProcessSettings& settings,
                   Workpiece piece, double ambient, double seconds)
    : piece_(std::move(piece)),
      material_(from.material),
      weld_(shaders, material_, piece_, settings, surroundings(from, settings, ambient, seconds)),
      seconds_(seconds),
      fed_(caseFillerRate(from, settings) > 0) {}

void CaseWeld::run(const TorchPath& path, FunctionRef<bool(double)> watch, ValidationResult& result) {
    const double step = weld_.timeStep();
    for (double time = 0;;) {
        weld_.step(path.sample(time + 0.5 * step), nullptr);
        addMeans();
        ++result.steps;
        elapsed_ = time += step;
        if (!watch(time)) break;
    }
    result.particles = weld_.metal().state().particles();
}

void CaseWeld::run(const TorchPath& path, double until, ValidationResult& result) {
    run(
        path, [until](double time) { return time < until; }, result);
}

void CaseWeld::addMeans() {
    const ArcState& arc = weld_.arc();
    if (!arc.burns() || arc.action == ArcAction::striking) return;
    const double step = weld_.timeStep();
    arc_.current += static_cast<double>(arc.current) * step;
    arc_.voltage += static_cast<double>(arc.voltage) * step;
    arc_.length += static_cast<double>(arc.length) * step;
    arc_.burning += step;
}

Section CaseWeld::section(double low, double high) const {
    return measureSection(weld_.metal().state(), piece_.seeds, sectionCut(material_, low, high));
}

ParticleValues CaseWeld::particles() const {
    const MetalState& state = weld_.metal().state();
    const size_t count = state.particles();
    return {state.position.read<vec4>(count), state.heat.read<vec4>(count), state.phase.read<uint>(count)};
}

WeldMeasures CaseWeld::measure(WeldKind kind, const StationSettings& stations) const {
    return measureWeld(weld_.metal().state(), piece_.seeds, material_, kind, stations);
}

void CaseWeld::tellArc(const ValidationCase& from, ValidationResult& result) const {
    result.compareMeasured(from, "current_a", meanCurrent());
    result.tell("voltage_v", meanVoltage());
    result.tell("arc_length_mm", 1e3 * arc_.length / std::max(arc_.burning, kNoTime));
    if (fed_) result.tell("refused_filler", static_cast<double>(weld_.metal().refusedFiller()));
}

void CaseWeld::requireArc(const ValidationCase& from) const {
    if (arc_.burning < 0.5 * std::min(seconds_, elapsed_))
        throw InputError(from.file, 0,
                         "[case]: the arc burned for less than half of its time; expected a distance and settings that "
                         "keep it burning");
}

void CaseWeld::compareDeposit(const ValidationCase& from, double length, ValidationResult& result) const {
    if (!fed_) return;
    const double low = static_cast<double>(piece_.bodyLow.x), high = static_cast<double>(piece_.bodyHigh.x);
    const double volume = section(low, high).deposited * (high - low);
    // The melted wire is the fed wire plus the loss of extension.
    const WireAccount wire = weld_.process().wire();
    result.compareExact(withinThree(from), "deposited_mm2", wire.melted * wire.area / length * 1e6,
                        volume / length * 1e6);
}

} // namespace meltpool
