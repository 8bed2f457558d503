#include "core/validation/plate_path.hpp"

#include "core/validation/case_size.hpp"
#include "core/validation/case_weld.hpp"

#include <algorithm>

namespace meltpool {

namespace {

constexpr float kMm = 1e-3F;

} // namespace

PlatePath::PlatePath(const ValidationCase& from) : process(caseProcess(from)), ambient(from.number("ambient_k")) {
    const auto& plate = from.list("plate_mm");
    // The first is along the seam; of the other two the smaller is the thickness, in either order.
    length = static_cast<float>(plate[0]) * kMm;
    thickness = static_cast<float>(std::min(plate[1], plate[2])) * kMm;
    width = static_cast<float>(std::max(plate[1], plate[2])) * kMm;
    speed = static_cast<float>(from.number("speed_mm_s")) * kMm;
    height = caseTorchHeight(from, process);
    const float margin = std::min(0.15F * length, 0.01F);
    end = length / 2 - margin;
    start = -end;
}

void PlatePath::require(const ValidationCase& from) const {
    requireSpacings(from, "plate_mm (thickness)", static_cast<double>(thickness), 2);
    requireSpacings(from, "plate_mm (width)", static_cast<double>(width), 4);
    requireWeldRoom(from, process, static_cast<double>(length * thickness * width), seconds());
}

} // namespace meltpool
