// A bead on a plate: the trainer's process welds along a straight path, and the section is measured as from a cut.
#include "core/validation/case_size.hpp"
#include "core/validation/case_weld.hpp"
#include "core/validation/plate_path.hpp"

#include <numbers>

namespace meltpool {

namespace {

constexpr double kFreezing = 1.5; // s after the arc

/// Compares the section's figures of a bead of wire.
void compareBead(const ValidationCase& from, const Section& section, ValidationResult& result) {
    const BeadShape bead = section.bead.value_or(BeadShape{});
    const auto overlap = bead.overlap(section.fusion.stretch);
    result.compareMeasured(from, "toe_width_mm", bead.toeWidth() * 1e3);
    result.compareMeasured(from, "height_mm", bead.height * 1e3);
    if (bead.toes)
        result.compareMeasured(from, "edge_angle_deg",
                               0.5 * ((*bead.toes)[0].angle + (*bead.toes)[1].angle) * 180 / std::numbers::pi);
    result.compareMeasured(from, "overlap_mm", (overlap[0] + overlap[1]) * 1e3);
    result.compareMeasured(from, "section_mm2", section.deposited * 1e6);
}

} // namespace

void runBeadOnPlate(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result) {
    const PlatePath plate(from);
    plate.require(from);
    CaseWeld weld(from, shaders, plate.process, plate.workpiece(from), plate.ambient, plate.seconds());
    weld.run(plate.torch(), plate.seconds() + kFreezing, result);
    weld.tellArc(from, result);
    weld.compareDeposit(from, plate.way(), result);
    // The stretch begins after the pool has settled, and ends well before the bead does. Fed metal is in waves, so the
    // stretch is long.
    const double start = static_cast<double>(plate.start);
    const Section section = weld.section(start + 0.35 * plate.way(), start + 0.8 * plate.way());
    result.compareMeasured(from, "fused_width_mm", section.fusion.width * 1e3);
    result.compareMeasured(from, "penetration_mm", section.fusion.depth * 1e3);
    if (weld.fed()) compareBead(from, section, result);
    result.compareMeasured(from, "fused_plate_mm2", section.fusion.area * 1e6);
    result.tell("heat_affected_width_mm", section.heatAffected ? section.heatAffected->width * 1e3 : 0);
    result.tell("heat_affected_depth_mm", section.heatAffected ? section.heatAffected->depth * 1e3 : 0);
    weld.requireArc(from);
}

} // namespace meltpool
