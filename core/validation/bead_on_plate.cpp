// A bead on a plate: the trainer's process welds along a straight path, and the section is measured as from a cut.
#include "core/base/error.hpp"
#include "core/validation/case_size.hpp"
#include "core/validation/torch_run.hpp"
#include "core/validation/validation.hpp"
#include "core/weld/gauge/weld_section.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace meltpool {

namespace {

constexpr float kMm = 1e-3F;
constexpr double kFreezing = 1.5;    // s after the arc
constexpr double kFillerSpare = 1.1; // of the room for wire

/// The case in SI. x along the seam with the plate's middle at 0, y up with the plate's top at 0.
struct Bead {
    ProcessSettings process;
    float height, speed, length, thickness, width;
    float start, end; // of the path, m
    double ambient;

    double seconds() const { return static_cast<double>((end - start) / speed); }
    double wireRate() const { // m³/s
        if (!process.is<Gmaw>()) return 0;
        const GmawSettings& gmaw = process.of<Gmaw>();
        const double diameter = static_cast<double>(gmaw.wireDiameterMm) * 1e-3;
        return std::numbers::pi / 4 * diameter * diameter * static_cast<double>(gmaw.wireFeedMPerMin) / 60;
    }
};

Bead beadOf(const ValidationCase& from) {
    Bead b{};
    const auto& plate = from.list("plate_mm");
    // The first is along the seam; of the other two the smaller is the thickness, in whichever order they stand.
    b.length = static_cast<float>(plate[0]) * kMm;
    b.thickness = static_cast<float>(std::min(plate[1], plate[2])) * kMm;
    b.width = static_cast<float>(std::max(plate[1], plate[2])) * kMm;
    b.ambient = from.number("ambient_k");
    b.speed = static_cast<float>(from.number("speed_mm_s")) * kMm;
    b.process = caseProcess(from);
    b.height = caseTorchHeight(from, b.process);
    const float margin = std::min(0.15F * b.length, 0.01F);
    b.end = b.length / 2 - margin;
    b.start = -b.end;
    return b;
}

/// The measured stretch: where the pool has settled, and well before its end. Fed metal lies in waves, so it is long.
SectionCut cutOf(const Bead& b, const Material& material) {
    const auto path = static_cast<double>(b.end - b.start);
    return sectionCut(material, static_cast<double>(b.start) + 0.35 * path, static_cast<double>(b.start) + 0.8 * path);
}

/// Means over the time in which the arc burned.
struct ArcMeans {
    double current = 0, voltage = 0, length = 0, burning = 0;

    void add(const ArcState& arc, double seconds) {
        if (!arc.burns() || arc.action == ArcAction::striking) return;
        current += static_cast<double>(arc.current) * seconds;
        voltage += static_cast<double>(arc.voltage) * seconds;
        length += static_cast<double>(arc.length) * seconds;
        burning += seconds;
    }
    void tell(ValidationResult& result) const {
        const double time = std::max(burning, 1e-9);
        result.tell("current_a", current / time);
        result.tell("voltage_v", voltage / time);
        result.tell("arc_length_mm", 1e3 * length / time);
    }
};

/// The deposited section has a bound of its own, whatever the case's tolerance.
ValidationCase withinThree(ValidationCase from) {
    from.tolerancePercent = 3;
    return from;
}

/// The bead is thin where it begins and humps after it: on a short plate no stretch has the mean section.
void compareDeposit(const ValidationCase& from, const Bead& b, const Weld& weld, const Workpiece& plate,
                    ValidationResult& result) {
    const double half = 0.5 * static_cast<double>(b.length);
    const SectionCut whole = sectionCut(from.material, -half, half);
    const double volume =
        measureSection(weld.metal().state(), plate.seeds, whole).deposited * static_cast<double>(b.length);
    // What melted, which is what was fed and what the wire became shorter by.
    const WireAccount wire = weld.process().wire();
    result.compareExact(withinThree(from), "deposited_mm2",
                        wire.melted * wire.area / static_cast<double>(b.end - b.start) * 1e6,
                        volume / static_cast<double>(b.end - b.start) * 1e6);
}

void compareSection(const ValidationCase& from, const Section& section, bool fed, ValidationResult& result) {
    result.compareMeasured(from, "width_mm", section.fusion.width * 1e3);
    result.compareMeasured(from, "penetration_mm", section.fusion.depth * 1e3);
    if (fed) {
        result.compareMeasured(from, "height_mm", (section.bead ? section.bead->height : 0) * 1e3);
        result.compareMeasured(from, "section_mm2", section.deposited * 1e6);
    }
    result.tell("fused_plate_mm2", section.fusion.area * 1e6);
    result.tell("heat_affected_width_mm", section.heatAffected ? section.heatAffected->width * 1e3 : 0);
    result.tell("heat_affected_depth_mm", section.heatAffected ? section.heatAffected->depth * 1e3 : 0);
}

} // namespace

void runBeadOnPlate(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result) {
    const Bead b = beadOf(from);
    requireSpacings(from, "plate_mm, its thickness", static_cast<double>(b.thickness), 2);
    requireSpacings(from, "plate_mm, its width", static_cast<double>(b.width), 4);
    const double cell = std::pow(from.spacing, 3);
    const double wire = b.wireRate() * b.seconds() / cell;
    const double count = static_cast<double>(b.length * b.thickness * b.width) / cell + wire;
    const double cells = 4 * count; // with the space around the plate
    requireRoom(from, {cells, count, count, cells});

    const Workpiece plate = casePlate(from, b.length, b.thickness, b.width, b.ambient);
    WeldSurroundings around;
    around.ambient = b.ambient;
    around.fillerRoom = static_cast<size_t>(kFillerSpare * wire) + 100;
    Weld weld(shaders, from.material, plate, b.process, around);
    const TorchPath path = straightRun(b.start, b.end, b.height, b.seconds());
    ArcMeans means;
    const double step = weld.timeStep();
    for (double time = 0; time < b.seconds() + kFreezing; time += step) {
        weld.step(path.sample(time + 0.5 * step), nullptr);
        means.add(weld.arc(), step);
        ++result.steps;
    }
    result.particles = weld.metal().state().particles();
    if (means.burning < 0.5 * b.seconds())
        throw InputError(from.file, 0,
                         "[case]: the arc burned for less than half of the path; expected a distance and "
                         "settings at which it holds");
    means.tell(result);
    const bool fed = b.wireRate() > 0;
    if (fed) {
        result.tell("refused_filler", static_cast<double>(weld.metal().refusedFiller()));
        compareDeposit(from, b, weld, plate, result);
    }
    compareSection(from, measureSection(weld.metal().state(), plate.seeds, cutOf(b, from.material)), fed, result);
}

} // namespace meltpool
