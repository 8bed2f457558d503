// Energy balance: the trainer's process melts a plate, at a spot or along a seam, with wire or without; the metal flows
// and freezes.
#include "core/validation/case_size.hpp"
#include "core/validation/torch_run.hpp"
#include "core/validation/validation.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr float kSide = 0.032F; // m, side of the plate; longer if the seam needs it
constexpr float kThickness = 0.008F;
constexpr float kMargin = 0.008F; // m between the seam's ends and the plate's
constexpr double kAmbient = 293.15;

/// The case in SI.
struct Seam {
    ProcessSettings process;
    float height;
    double on; // s
    float speed, length;

    explicit Seam(const ValidationCase& from)
        : process(caseProcess(from)),
          height(caseTorchHeight(from, process)),
          on(std::min(from.number("on_s"), from.time)),
          speed(static_cast<float>(from.number("speed_mm_s") * 1e-3)),
          length(std::max(kSide, speed * static_cast<float>(on) + 2 * kMargin)) {}

    TorchPath path() const {
        const float half = 0.5F * speed * static_cast<float>(on);
        return straightRun(-half, half, height, on);
    }
};

WeldSurroundings surroundings(const ValidationCase& from, double wireCount) {
    WeldSurroundings around;
    around.ambient = kAmbient;
    around.convection = from.number("loss");
    around.lossless = around.convection <= 0;
    around.ledger = true;
    around.fillerRoom = static_cast<size_t>(1.05 * wireCount) + 50;
    return around;
}

/// Energy that the process has put in, J.
struct Input {
    double surface = 0, wire = 0;

    void add(const Weld& weld) {
        for (const HeatSource& source : weld.process().sources())
            surface += static_cast<double>(source.power) * weld.timeStep();
        for (const MetalSeed& drop : weld.process().drops())
            wire += weld.metal().state().particleMass() *
                    weld.metal().table().enthalpyAt(static_cast<double>(drop.temperature));
    }
    double sum() const { return surface + wire; }
};

} // namespace

void runEnergy(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result) {
    const Seam seam(from);
    requireSpacings(from, "plate of 32x8x32 mm (thickness)", static_cast<double>(kThickness), 1);
    const double cell = std::pow(from.spacing, 3);
    const double plateCount = static_cast<double>(seam.length * kThickness * kSide) / cell;
    const double wireCount = equipmentOf(seam.process).wireRate() * seam.on / cell;
    requireCapacity(from, {4 * plateCount, plateCount + wireCount, plateCount + wireCount, 4 * plateCount});
    const Workpiece plate = casePlate(from, seam.length, kThickness, kSide, kAmbient);
    Weld weld(shaders, from.material, plate, seam.process, surroundings(from, wireCount));
    const double before = weld.metal().state().readEnergy();
    const size_t plateParticles = weld.metal().state().particles();
    const TorchPath path = seam.path();
    Input input;
    double peak = 0;
    const auto steps = static_cast<size_t>(std::ceil(from.time / weld.timeStep()));
    for (size_t i = 0; i < steps; ++i) {
        weld.step(path.sample((static_cast<double>(i) + 0.5) * weld.timeStep()), nullptr);
        input.add(weld);
        constexpr size_t kLook = 30; // steps between two looks at the molten metal
        if (i % kLook == kLook - 1) peak = std::max(peak, static_cast<double>(weld.metal().statistics().molten));
    }
    result.steps = steps;
    const MetalStatistics end = weld.metal().statistics();
    result.particles = end.particles;
    const HeatBalance balance = weld.metal().heat().readBalance();
    const double change = weld.metal().state().readEnergy() - before;
    const double scale = input.sum() > 0 ? input.sum() : before;
    result.compareExact(from, "energy_change_j", input.sum() - balance.lost, change, scale);
    result.compareExact(from, "source_j", input.surface, balance.gained, scale);
    result.tell("wire_j", input.wire);
    result.tell("lost_j", balance.lost);
    result.tell("balance_percent", 100 * std::abs(change - input.wire - balance.gained + balance.lost) / scale);
    const auto all = static_cast<double>(end.particles);
    result.tell("molten_peak_share", peak / all);
    result.tell("molten_end_share", static_cast<double>(end.molten) / all);
    // Every particle of plate and wire is still there.
    const double fed = static_cast<double>(weld.process().filler().fed());
    result.compareLimit("particles_missing", 0, static_cast<double>(plateParticles) + fed - all);
    result.compareLimit("particles_lost_or_not_finite", 0, static_cast<double>(end.lost + end.nonFinite));
}

} // namespace meltpool
