#include "core/training/judging/bands.hpp"

#include "core/base/text.hpp"
#include "core/base/toml_table.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace meltpool {

namespace {

constexpr double kMm = 1e3; // mm in a metre
constexpr NumberRange kHalfWidths{0, 1000};
constexpr NumberRange kWeights{0, 1000};

TechniqueBand readBand(TomlTable group, const QuantityInfo& info) {
    TechniqueBand band;
    band.quantity = info.quantity;
    band.ideal = group.number("ideal", {info.least, info.most});
    band.inner = group.number("inner", kHalfWidths);
    band.outer = group.number("outer", kHalfWidths);
    band.weight = group.number("weight", kWeights, 1);
    if (band.outer < band.inner) group.fail("outer", "is below inner; expected at least " + formatNumber(band.inner));
    if (band.outer <= 0) group.fail("outer", "is 0; expected a half width above 0");
    group.finish();
    return band;
}

TravelDirection readDirection(TomlTable& table) {
    const std::string word = table.text("direction", "either");
    if (word == "either") return TravelDirection::either;
    if (word == "forward") return TravelDirection::forward;
    if (word == "backward") return TravelDirection::backward;
    table.fail("direction", "is " + quote(word) + "; expected one of either, forward, backward");
}

/// The other kind of process has another name for the distance: the message says so instead of "unknown key".
void refuseOtherDistance(const TomlTable& table, DistanceKind distance) {
    const DistanceKind other = distance == DistanceKind::ctwd ? DistanceKind::arcLength : DistanceKind::ctwd;
    const std::string_view wrong = quantityInfo(TechniqueQuantity::distance, other).key;
    const std::string_view right = quantityInfo(TechniqueQuantity::distance, distance).key;
    if (table.has(wrong))
        table.fail(wrong, "is not measured with this lesson's process; expected " + std::string(right));
}

} // namespace

double TechniqueBand::points(double value) const {
    const double off = std::abs(value - ideal);
    if (off <= inner) return 100;
    return off < outer ? 100 * (outer - off) / (outer - inner) : 0;
}

BandZone TechniqueBand::zone(double value) const {
    const double off = std::abs(value - ideal);
    if (off <= inner) return BandZone::inside;
    return off < outer ? BandZone::between : BandZone::beyond;
}

bool TechniqueBand::readsBeyond(double value) const {
    constexpr double kReadDigits = 10;
    const auto read = [](double number) { return std::round(number * kReadDigits); };
    return std::abs(value - ideal) > inner && std::abs(read(value) - read(ideal)) > read(inner);
}

double TechniqueBands::judged(const TechniqueValues& values, int sensed, TechniqueQuantity quantity) const {
    const double value = values[quantity] * quantityInfo(quantity, distance).perSi;
    const int wanted = direction == TravelDirection::forward ? 1 : direction == TravelDirection::backward ? -1 : 0;
    const bool against = wanted * sensed < 0;
    return quantity == TechniqueQuantity::travelSpeed && against ? -value : value;
}

const TechniqueBand* TechniqueBands::find(TechniqueQuantity quantity) const {
    const auto found =
        std::find_if(bands.begin(), bands.end(), [&](const TechniqueBand& each) { return each.quantity == quantity; });
    return found == bands.end() ? nullptr : &*found;
}

TechniqueBands readTechniqueBands(TomlTable& table, DistanceKind distance, const Seam& seam) {
    TechniqueBands result;
    result.distance = distance;
    refuseOtherDistance(table, distance);
    // Whole micrometres: half of a length in mm, converted to m and back, may be a little short.
    const auto whole = [](double place) { return std::round(place * kMm * 1e3) * 1e-3; };
    const NumberRange places{whole(seam.begin()), whole(seam.end())};
    result.lengthFromMm = table.number("length_from_mm", places);
    result.lengthToMm = table.number("length_to_mm", places);
    if (result.lengthToMm < result.lengthFromMm + 1)
        table.fail("length_to_mm", "expected at least 1 mm more than length_from_mm");
    result.direction = readDirection(table);
    result.speedWindow = table.number("speed_window_s", {0.1, 10}, 0.5);
    for (const QuantityInfo& info : quantities(distance)) {
        if (info.key.empty()) continue;
        table.allow(info.key);
        if (table.has(info.key)) result.bands.push_back(readBand(table.table(info.key), info));
    }
    table.finish();
    const double weights = std::accumulate(result.bands.begin(), result.bands.end(), 0.0,
                                           [](double sum, const TechniqueBand& each) { return sum + each.weight; });
    if (!(weights > 0)) table.fail("technique", "judges nothing; expected one band with a weight above 0");
    return result;
}

} // namespace meltpool
