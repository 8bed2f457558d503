// A fillet in a tee joint: the torch points into the corner and welds along it; legs, throat and root are measured.
#include "core/validation/case_size.hpp"
#include "core/validation/case_weld.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace meltpool {

namespace {

constexpr float kMm = 1e-3F;
constexpr double kFreezing = 2; // s after the arc
constexpr double kDegree = std::numbers::pi / 180;

/// The case in SI. x along the seam with the joint's middle at 0; the corner between the plates at y = z = 0.
struct Fillet {
    ProcessSettings process;
    WorkpieceParameters tee;
    float speed, start, end;
    TorchPose held;
    double ambient;

    explicit Fillet(const ValidationCase& from) : process(caseProcess(from)), ambient(from.number("ambient_k")) {
        const auto& plate = from.list("plate_mm");
        tee.kind = static_cast<int>(WorkpieceKind::Tee);
        tee.spacingMm = static_cast<float>(from.spacing * 1e3);
        tee.lengthMm = wholeSpacings(plate[0], tee.spacingMm);
        tee.thicknessMm = wholeSpacings(std::min(plate[1], plate[2]), tee.spacingMm);
        tee.widthMm = wholeSpacings(std::max(plate[1], plate[2]), tee.spacingMm);
        tee.heightMm = wholeSpacings(from.number("standing_mm"), tee.spacingMm);
        tee.temperatureC = static_cast<float>(ambient - 273.15);
        speed = static_cast<float>(from.number("speed_mm_s")) * kMm;
        held = {caseTorchHeight(from, process), from.number("work_angle_deg") * kDegree,
                from.number("travel_angle_deg") * kDegree};
        end = (tee.lengthMm / 2 - std::min(0.15F * tee.lengthMm, 10.0F)) * kMm;
        start = -end;
    }

    double seconds() const { return static_cast<double>((end - start) / speed); }
    double way() const { return static_cast<double>(end - start); }
    void require(const ValidationCase& from) const {
        const auto thickness = static_cast<double>(tee.thicknessMm) * 1e-3;
        requireSpacings(from, "plate_mm (thickness)", thickness, 2);
        requireSpacings(from, "plate_mm (width)", static_cast<double>(tee.widthMm) * 1e-3, 6);
        requireSpacings(from, "standing_mm", static_cast<double>(tee.heightMm) * 1e-3, 4);
        const double across = static_cast<double>(tee.widthMm + tee.heightMm) * 1e-3 * thickness;
        // The box around a tee is mostly empty, and its cells take room too.
        requireWeldRoom(from, process, 2 * across * static_cast<double>(tee.lengthMm) * 1e-3, seconds());
    }
};

void compareFillet(const ValidationCase& from, const FilletShape& fillet, ValidationResult& result) {
    const double base = fillet.toes[0].place * 1e3, upright = fillet.toes[1].place * 1e3;
    result.compareMeasured(from, "leg_mm", 0.5 * (base + upright));
    result.compareMeasured(from, "leg_lying_mm", base);
    result.compareMeasured(from, "leg_standing_mm", upright);
    result.compareMeasured(from, "throat_mm", fillet.throat * 1e3);
    result.compareMeasured(from, "edge_angle_lying_deg", fillet.toes[0].angle / kDegree);
    result.compareMeasured(from, "edge_angle_standing_deg", fillet.toes[1].angle / kDegree);
}

} // namespace

void runFillet(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result) {
    const Fillet f(from);
    f.require(from);
    CaseWeld weld(from, shaders, f.process, makeWorkpiece(f.tee), f.ambient, f.seconds());
    weld.run(heldRun(f.start, f.end, f.held, f.seconds()), f.seconds() + kFreezing, result);
    weld.tellArc(from, result);
    weld.compareDeposit(from, f.way(), result);
    const double start = static_cast<double>(f.start);
    const Section section = weld.section(start + 0.35 * f.way(), start + 0.8 * f.way());
    // Without metal across the corner there is no leg: the case's measured value is then missing, and fails.
    if (section.fillet) compareFillet(from, *section.fillet, result);
    result.compareMeasured(from, "root_fusion_mm", section.rootFusion.value_or(0) * 1e3);
    result.compareMeasured(from, "penetration_mm", section.fusion.depth * 1e3);
    result.tell("fused_width_mm", section.fusion.width * 1e3);
    result.tell("fused_plate_mm2", section.fusion.area * 1e6);
    weld.requireArc(from);
}

} // namespace meltpool
