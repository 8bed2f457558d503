#include "core/training/judging/quantity.hpp"

#include "core/base/words.hpp"

#include <algorithm>
#include <numbers>

namespace meltpool {

namespace {

using enum TechniqueQuantity;
using List = std::array<QuantityInfo, kTechniqueQuantities>;

constexpr double kMm = 1e3;
constexpr double kDegrees = 180 / std::numbers::pi;

constexpr List listOf(std::string_view key, std::string_view column, std::string_view wordsKey) {
    return {{
        {aim, "aim", "aim_mm", "quantity.aim", "mm", kMm, -100, 100},
        {height, "", "height_mm", "quantity.height", "mm", kMm, 0, 0},
        {distance, key, column, wordsKey, "mm", kMm, 0, 200},
        {workAngle, "work_angle", "work_angle_deg", "quantity.work_angle", "°", kDegrees, -90, 90},
        {travelAngle, "travel_angle", "travel_angle_deg", "quantity.travel_angle", "°", kDegrees, -90, 90},
        {travelSpeed, "travel_speed", "speed_mm_s", "quantity.travel_speed", "mm/s", kMm, 0, 1000},
        {weaveWidth, "weave_width", "weave_mm", "quantity.weave_width", "mm", kMm, 0, 100},
        {weaveFrequency, "weave_frequency", "weave_hz", "quantity.weave_frequency", "Hz", 1, 0, 50},
        {weaveDwell, "weave_dwell", "weave_dwell_s", "quantity.weave_dwell", "s", 1, 0, 10},
        {whipLength, "whip_length", "whip_mm", "quantity.whip_length", "mm", kMm, 0, 100},
        {whipPeriod, "whip_period", "whip_period_s", "quantity.whip_period", "s", 1, 0, 10},
        {whipDwell, "whip_dwell", "whip_dwell_s", "quantity.whip_dwell", "s", 1, 0, 10},
        {rodAngle, "rod_angle", "rod_angle_deg", "quantity.rod_angle", "°", kDegrees, -90, 90},
        {rodFrequency, "rod_frequency", "rod_hz", "quantity.rod_frequency", "Hz", 1, 0, 50},
    }};
}

constexpr List kWire = listOf("ctwd", "ctwd_mm", "quantity.ctwd");
constexpr List kElectrode = listOf("arc_length", "arc_length_mm", "quantity.arc_length");

} // namespace

std::string_view QuantityInfo::words() const {
    return phrase(wordsKey);
}

const std::array<QuantityInfo, kTechniqueQuantities>& quantities(DistanceKind kind) {
    return kind == DistanceKind::ctwd ? kWire : kElectrode;
}

const QuantityInfo& quantityInfo(TechniqueQuantity quantity, DistanceKind kind) {
    return quantities(kind)[static_cast<size_t>(quantity)];
}

std::string keysOf(const QuantitySet& set, DistanceKind distance) {
    std::string keys;
    for (const QuantityInfo& each : quantities(distance))
        if (set.test(static_cast<size_t>(each.quantity)) && !each.key.empty())
            keys.append(keys.empty() ? "" : " ").append(each.key);
    return keys;
}

std::string wordsOfKeys(std::string_view keys) {
    std::string words;
    while (!keys.empty()) {
        const size_t end = std::min(keys.find(' '), keys.size());
        std::string_view word = keys.substr(0, end);
        for (const List* list : {&kElectrode, &kWire})
            for (const QuantityInfo& each : *list)
                if (each.key == keys.substr(0, end) && !each.key.empty()) word = each.words();
        words.append(words.empty() ? "" : phrase("list.separator")).append(word);
        keys.remove_prefix(std::min(end + 1, keys.size()));
    }
    return words;
}

} // namespace meltpool
