// A bead on a plate: an arc travels, wire melts into its pool, and the section is measured as from a cut.
#include "core/base/error.hpp"
#include "core/metal/physical_metal.hpp"
#include "core/validation/case_size.hpp"
#include "core/validation/heat_bench.hpp"
#include "core/weld/gauge/weld_section.hpp"
#include "core/weld/process/filler.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace meltpool {

namespace {

constexpr float kMm = 1e-3F;
constexpr double kDropTemperature = 2500; ///< K, of wire metal that arrives in the pool
constexpr float kDropSpeed = 0.3F;        ///< m/s
constexpr float kAirAbove = 0.008F;       ///< m of lattice over the plate, for the bead
constexpr float kBeadConvection = 15;     ///< W/(m² K)

/// The case in SI. x along the seam, y up with the plate's top at 0, z across with the seam at 0.
struct Bead {
    double power;     ///< W into the workpiece, wire included
    double wirePower; ///< W of it that arrives with the wire
    double wireRate;  ///< m³/s
    double current;   ///< A, of the arc that presses the pool down
    float sigma, speed, length, thickness, width;
    float start, end; ///< of the path, m
    double ambient;
};

Bead beadOf(const ValidationCase& from, const Material& material) {
    Bead b{};
    const auto& plate = from.list("plate_mm");
    // The first is along the seam; of the other two the smaller is the thickness, in whichever order they stand.
    b.length = static_cast<float>(plate[0]) * kMm;
    b.thickness = static_cast<float>(std::min(plate[1], plate[2])) * kMm;
    b.width = static_cast<float>(std::max(plate[1], plate[2])) * kMm;
    b.ambient = from.number("ambient_k");
    b.power = from.number("power_w") * from.number("efficiency");
    const double diameter = from.number("wire_diameter_mm") * 1e-3;
    b.wireRate = std::numbers::pi / 4 * diameter * diameter * from.number("wire_feed_m_min") / 60;
    b.current = from.number("current_a");
    const HeatTable table(material);
    b.wirePower = b.wireRate * material.solidDensity.at(b.ambient) *
                  (table.enthalpyAt(kDropTemperature) - table.enthalpyAt(b.ambient));
    if (b.wirePower > b.power)
        throw InputError(from.file, 0,
                         "[case] power_w: the arc cannot melt that much wire; expected at least " +
                             std::to_string(std::lround(b.wirePower / from.number("efficiency"))) + " W");
    b.sigma = static_cast<float>(from.number("arc_sigma_mm")) * kMm;
    b.speed = static_cast<float>(from.number("speed_mm_s")) * kMm;
    const float margin = std::min(0.15F * b.length, 0.01F);
    b.start = margin;
    b.end = b.length - margin;
    return b;
}

Material stirred(const ValidationCase& from) {
    Material material = from.material;
    for (Property::Point& point : material.liquidConductivity.points)
        point.value *= from.number("liquid_conductivity_factor");
    return material;
}

MetalLattice latticeOf(const Bead& b, float spacing, float above) {
    const float half = std::ceil(b.width / (2 * spacing)) * spacing;
    const float depth = std::round(b.thickness / spacing) * spacing;
    return MetalLattice::covering({0, -depth, -half}, {b.length, above, half}, spacing);
}

std::vector<MetalSeed> plateOf(const Bead& b, const MetalLattice& lattice) {
    // The whole plate is clamped: nothing of it may fall while the seam is made.
    return latticeSeeds(lattice, lattice.low, {b.length, 0, 0.5F * b.width}, static_cast<float>(b.ambient),
                        PHASE_CLAMPED);
}

HeatSettings surroundings(const Bead& b) {
    HeatSettings settings;
    settings.ambient = b.ambient;
    settings.convection = kBeadConvection;
    settings.radiation = true;
    settings.evaporation = true;
    return settings;
}

HeatSource arcAt(const Bead& b, float x) {
    return HeatSource::gaussian({x, 0, 0}, {0, -1, 0}, b.sigma, static_cast<float>(b.power - b.wirePower));
}

ArcPressure pressureAt(const Bead& b, float x) {
    const double peak = arcPressurePeak(b.current, static_cast<double>(b.sigma));
    return {{x, 0, 0}, {0, -1, 0}, b.sigma, static_cast<float>(peak)};
}

/// The measured stretch: where the pool has settled, and well before its end. Fed metal lies in waves, so it is long.
SectionCut cutOf(const Bead& b, const Material& material) {
    const double path = static_cast<double>(b.end - b.start);
    return sectionCut(material, static_cast<double>(b.start) + 0.35 * path, static_cast<double>(b.start) + 0.8 * path);
}

/// Without wire the surface stays where it is: heat alone, on the lattice.
Section burnIn(const ValidationCase& from, gl::ShaderLibrary& shaders, const Bead& b, ValidationResult& result) {
    const Material material = stirred(from);
    const MetalLattice lattice = latticeOf(b, static_cast<float>(from.spacing), 0);
    // Without stirring the surface under the arc is far hotter than any pool is, and evaporation at that temperature
    // would take power that a stirred pool keeps: the fitted efficiency stands for what evaporates.
    HeatSettings settings = surroundings(b);
    settings.evaporation = false;
    const std::vector<MetalSeed> plate = plateOf(b, lattice);
    HeatBench bench(shaders, lattice, material, plate, settings);
    const double duration = static_cast<double>((b.end - b.start) / b.speed);
    result.particles = bench.state.particles();
    constexpr double kHottest = 3500;
    result.steps = bench.run(0, duration, kHottest, [&](double time) {
        return std::vector{arcAt(b, b.start + b.speed * static_cast<float>(time))};
    });
    return measureSection(bench.state, plate, cutOf(b, material));
}

/// The deposited section has a bound of its own, whatever the case's tolerance.
ValidationCase withinThree(ValidationCase from) {
    from.tolerancePercent = 3;
    return from;
}

/// With wire: heat, flow and filler, until the seam has frozen.
Section deposit(const ValidationCase& from, gl::ShaderLibrary& shaders, const Bead& b, ValidationResult& result) {
    const auto spacing = static_cast<float>(from.spacing);
    PhysicalSetup setup;
    setup.material = stirred(from);
    setup.lattice = latticeOf(b, spacing, kAirAbove);
    setup.seeds = plateOf(b, setup.lattice);
    setup.space.low = setup.lattice.low;
    setup.space.high = setup.lattice.low + glm::vec3(setup.lattice.cells()) * spacing;
    setup.fragments.floorHeight = setup.lattice.low.y;
    setup.heat = surroundings(b);
    const double duration = static_cast<double>((b.end - b.start) / b.speed);
    setup.fillerRoom = static_cast<size_t>(1.1 * b.wireRate * duration / std::pow(from.spacing, 3)) + 100;
    PhysicalMetal metal(shaders, setup);
    Filler filler(spacing);
    constexpr double kFreezing = 1.5; // s after the arc
    const auto frame = static_cast<double>(metal.timeStep());
    for (double time = 0; time < duration + kFreezing; time += frame) {
        const bool burns = time < duration;
        const float x = b.start + b.speed * static_cast<float>(time + 0.5 * frame);
        const glm::vec3 tip(x, 0.004F, 0);
        metal.setArc(burns ? pressureAt(b, x) : ArcPressure{});
        metal.step(burns ? std::vector{arcAt(b, x)} : std::vector<HeatSource>{},
                   burns ? filler.feed(b.wireRate * frame, tip, {b.speed, -kDropSpeed, 0},
                                       static_cast<float>(kDropTemperature))
                         : std::span<const MetalSeed>{},
                   nullptr);
        ++result.steps;
    }
    result.particles = metal.state().particles();
    result.tell("refused_filler", static_cast<double>(metal.refusedFiller()));
    const Section section = measureSection(metal.state(), setup.seeds, cutOf(b, setup.material));
    // The bead is thin where it begins and humps after it: on a short plate no stretch has the mean section.
    const SectionCut whole = sectionCut(setup.material, 0, static_cast<double>(b.length));
    const double volume = measureSection(metal.state(), setup.seeds, whole).deposited * static_cast<double>(b.length);
    result.compareExact(withinThree(from), "deposited_mm2", b.wireRate / static_cast<double>(b.speed) * 1e6,
                        volume / static_cast<double>(b.end - b.start) * 1e6);
    return section;
}

} // namespace

void runBeadOnPlate(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result) {
    const Bead b = beadOf(from, from.material);
    const bool fed = b.wireRate > 0;
    requireSpacings(from, "plate_mm, its thickness", static_cast<double>(b.thickness), 2);
    requireSpacings(from, "plate_mm, its width", static_cast<double>(b.width), 4);
    const auto cells =
        static_cast<double>(latticeOf(b, static_cast<float>(from.spacing), fed ? kAirAbove : 0).cellCount());
    const double wire = b.wireRate * static_cast<double>((b.end - b.start) / b.speed);
    const double count = (static_cast<double>(b.length * b.thickness * b.width) + wire) / std::pow(from.spacing, 3);
    requireRoom(from, {cells, count, fed ? count : 0, fed ? cells : 0});
    const Section section = fed ? deposit(from, shaders, b, result) : burnIn(from, shaders, b, result);
    result.compareMeasured(from, "width_mm", section.fusion.width * 1e3);
    result.compareMeasured(from, "penetration_mm", section.fusion.depth * 1e3);
    if (fed) {
        result.compareMeasured(from, "height_mm", section.height.value_or(0) * 1e3);
        result.compareMeasured(from, "section_mm2", section.deposited * 1e6);
    }
    result.tell("fused_plate_mm2", section.fusion.area * 1e6);
    if (section.heatAffected) {
        result.tell("heat_affected_width_mm", section.heatAffected->width * 1e3);
        result.tell("heat_affected_depth_mm", section.heatAffected->depth * 1e3);
    }
}

} // namespace meltpool
