#include "core/training/judging/quantity.hpp"

#include <numbers>

namespace meltpool {

namespace {

using enum TechniqueQuantity;
using List = std::array<QuantityInfo, kTechniqueQuantities>;

constexpr double kMm = 1e3;
constexpr double kDegrees = 180 / std::numbers::pi;

constexpr List listOf(std::string_view key, std::string_view column, std::string_view words) {
    return {{
        {aim, "aim", "aim_mm", "aim", "mm", kMm, -100, 100},
        {height, "", "height_mm", "height", "mm", kMm, 0, 0},
        {distance, key, column, words, "mm", kMm, 0, 200},
        {workAngle, "work_angle", "work_angle_deg", "work angle", "°", kDegrees, -90, 90},
        {travelAngle, "travel_angle", "travel_angle_deg", "travel angle", "°", kDegrees, -90, 90},
        {travelSpeed, "travel_speed", "speed_mm_s", "travel speed", "mm/s", kMm, 0, 1000},
        {weaveWidth, "weave_width", "weave_mm", "weave's width", "mm", kMm, 0, 100},
        {weaveFrequency, "weave_frequency", "weave_hz", "weave's frequency", "Hz", 1, 0, 50},
        {weaveDwell, "weave_dwell", "weave_dwell_s", "dwell at the toes", "s", 1, 0, 10},
        {whipLength, "whip_length", "whip_mm", "whip's length", "mm", kMm, 0, 100},
        {whipPeriod, "whip_period", "whip_period_s", "whip's period", "s", 1, 0, 10},
        {whipDwell, "whip_dwell", "whip_dwell_s", "dwell in the pool", "s", 1, 0, 10},
        {rodAngle, "rod_angle", "rod_angle_deg", "rod's angle", "°", kDegrees, -90, 90},
        {rodFrequency, "rod_frequency", "rod_hz", "rod's rhythm", "Hz", 1, 0, 50},
    }};
}

constexpr List kWire = listOf("ctwd", "ctwd_mm", "contact tip to work distance");
constexpr List kElectrode = listOf("arc_length", "arc_length_mm", "arc length");

} // namespace

const std::array<QuantityInfo, kTechniqueQuantities>& quantities(DistanceKind kind) {
    return kind == DistanceKind::ctwd ? kWire : kElectrode;
}

const QuantityInfo& quantityInfo(TechniqueQuantity quantity, DistanceKind kind) {
    return quantities(kind)[static_cast<size_t>(quantity)];
}

} // namespace meltpool
