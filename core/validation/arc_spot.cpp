// An arc spot: the torch burns for a while over one place of a plate, and the spot is cut through its middle.
#include "core/validation/case_size.hpp"
#include "core/validation/case_weld.hpp"

#include <algorithm>

namespace meltpool {

namespace {

constexpr float kMm = 1e-3F;
constexpr double kFreezing = 1.5; // s after the arc

} // namespace

void runArcSpot(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result) {
    const ProcessSettings process = caseProcess(from);
    const auto& plate = from.list("plate_mm");
    const auto length = static_cast<float>(plate[0]) * kMm;
    const auto thickness = static_cast<float>(std::min(plate[1], plate[2])) * kMm;
    const auto width = static_cast<float>(std::max(plate[1], plate[2])) * kMm;
    const double ambient = from.number("ambient_k"), on = from.number("on_s");
    requireSpacings(from, "plate_mm (thickness)", static_cast<double>(thickness), 2);
    requireSpacings(from, "plate_mm (width)", static_cast<double>(width), 4);
    requireWeldRoom(from, process, static_cast<double>(length * thickness * width), on);
    CaseWeld weld(from, shaders, process, casePlate(from, length, thickness, width, ambient), ambient, on);
    weld.run(straightRun(0, 0, caseTorchHeight(from, process), on), on + kFreezing, result);
    weld.tellArc(from, result);
    // Three layers: a longer cut would also take the narrower parts of the circle next to its middle.
    const Section section = weld.section(-1.5 * from.spacing, 1.5 * from.spacing);
    result.compareMeasured(from, "fused_diameter_mm", section.fusion.width * 1e3);
    result.compareMeasured(from, "penetration_mm", section.fusion.depth * 1e3);
    const BeadShape spot = section.bead.value_or(BeadShape{});
    if (weld.fed()) result.compareMeasured(from, "diameter_mm", spot.toeWidth() * 1e3);
    if (weld.fed()) result.compareMeasured(from, "height_mm", spot.height * 1e3);
    weld.requireArc(from);
}

} // namespace meltpool
