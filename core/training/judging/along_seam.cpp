#include "core/training/judging/along_seam.hpp"

#include "core/base/text.hpp"
#include "core/training/judging/stretch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace meltpool {

namespace {

constexpr double kMm = 1e3;             // mm in a metre
constexpr double kBeyondMm = 20;        // beyond each end of the seam
constexpr double kShortestWayMm = 1e-4; // way within a millimetre; a shorter one is rounding of places

/// Means over time of the known values.
class Means {
  public:
    void add(const TechniqueValues& values, double seconds) {
        seconds_ += seconds;
        for (size_t i = 0; i < kTechniqueQuantities; ++i) {
            const auto quantity = static_cast<TechniqueQuantity>(i);
            if (std::isnan(values[quantity])) continue;
            double& sum = sums_[quantity];
            sum = (std::isnan(sum) ? 0 : sum) + values[quantity] * seconds;
            weights_[i] += seconds;
        }
    }
    double seconds() const { return seconds_; }
    TechniqueValues values() const {
        TechniqueValues means;
        for (size_t i = 0; i < kTechniqueQuantities; ++i) {
            const auto quantity = static_cast<TechniqueQuantity>(i);
            if (weights_[i] > 0) means[quantity] = sums_[quantity] / weights_[i];
        }
        return means;
    }

  private:
    double seconds_ = 0;
    TechniqueValues sums_;
    std::array<double, kTechniqueQuantities> weights_{};
};

struct Bin {
    Means judged, other;
    double direction = 0; ///< s forwards minus s backwards
    double charge = 0;    ///< A s of the arc
    double flux = 0;      ///< V s
};

/// The seam's millimetres, from kBeyondMm before its start to kBeyondMm behind its end; a circle has one turn of them.
class Bins {
  public:
    explicit Bins(const Seam& seam)
        : seam_(seam),
          first_(seam.closed() ? 0 : std::floor(seam.begin() * kMm) - kBeyondMm),
          bins_(static_cast<size_t>(std::ceil(seam.end() * kMm) - first_ + (seam.closed() ? 0 : kBeyondMm))) {}

    /// Spreads the time of `step` over the way from the step before it.
    void add(const TechniqueStep& before, const TechniqueStep& step, const StretchValues& values, bool judged) {
        if (!std::isfinite(before.place) || !std::isfinite(step.place)) return;
        const double low = std::min(before.place, step.place) * kMm, high = std::max(before.place, step.place) * kMm;
        const double seconds = step.time - before.time;
        if (high - low < kShortestWayMm) return addAt(low, seconds, step, values, judged);
        if (high - low > static_cast<double>(bins_.size())) return;
        for (double mm = std::floor(low); mm < high; ++mm) {
            const double begin = std::max(low, mm), end = std::min(high, mm + 1);
            if (end - begin < kShortestWayMm) continue;
            addAt((begin + end) / 2, seconds * (end - begin) / (high - low), step, values, judged);
        }
    }

    std::vector<SeamMillimetre> result() const {
        std::vector<SeamMillimetre> all;
        for (size_t i = 0; i < bins_.size(); ++i) {
            const Bin& bin = bins_[i];
            if (bin.judged.seconds() + bin.other.seconds() <= 0) continue;
            SeamMillimetre& mm = all.emplace_back();
            mm.place = (first_ + static_cast<double>(i) + 0.5) / kMm;
            mm.seconds = bin.judged.seconds() + bin.other.seconds();
            mm.judged = bin.judged.seconds() > 0;
            mm.direction = bin.direction > 0 ? 1 : bin.direction < 0 ? -1 : 0;
            mm.current = bin.charge / mm.seconds;
            mm.voltage = bin.flux / mm.seconds;
            mm.values = (mm.judged ? bin.judged : bin.other).values();
        }
        return all;
    }

  private:
    void addAt(double mm, double seconds, const TechniqueStep& step, const StretchValues& values, bool judged) {
        if (seam_.closed()) mm -= std::floor(mm / (seam_.length() * kMm)) * seam_.length() * kMm;
        const double index = std::floor(mm) - first_;
        if (!(index >= 0 && index < static_cast<double>(bins_.size())) || !(seconds > 0)) return;
        Bin& bin = bins_[static_cast<size_t>(index)];
        (judged ? bin.judged : bin.other).add(values.values, seconds);
        bin.direction += values.direction * seconds;
        bin.charge += step.current * seconds;
        bin.flux += step.voltage * seconds;
    }

    const Seam& seam_;
    double first_; ///< mm
    std::vector<Bin> bins_;
};

/// The first judged step that welds, and the one behind the last.
std::pair<size_t, size_t> judgedSteps(std::span<const TechniqueStep> steps, std::span<const StepRange> stretches) {
    const auto lasts = [&](const StepRange& each) {
        return steps[each.end - 1].time - steps[each.begin].time >= kStrikeSeconds;
    };
    const auto struck = std::find_if(stretches.begin(), stretches.end(), lasts);
    if (struck == stretches.end()) return {0, 0};
    const TechniqueStep& strike = steps[struck->begin];
    size_t first = struck->begin;
    double way = 0;
    for (; first < steps.size(); ++first) {
        way = std::max(way, std::abs(steps[first].place - strike.place));
        if (way >= kStrikeLength && steps[first].time - strike.time >= kStrikeSeconds) break;
    }
    size_t last = stretches.back().end;
    const double crater = steps[last - 1].place;
    while (last > first && std::abs(steps[last - 1].place - crater) < kCraterLength)
        --last;
    return {first, last};
}

void appendCell(std::string& text, double value) {
    text += ',';
    if (!std::isnan(value)) appendNumber(text, static_cast<float>(value));
}

/// Adds the numbers of the millimetres from `low` to `high` (m) on or near the seam.
void addMillimetres(std::set<double>& found, const Seam& seam, double low, double high) {
    const double length = seam.length() * kMm;
    const double first =
        seam.closed() ? std::floor(low * kMm) : std::max(std::floor(low * kMm), seam.begin() * kMm - kBeyondMm);
    const double last =
        seam.closed() ? std::min(high * kMm, first + length) : std::min(high * kMm, seam.end() * kMm + kBeyondMm);
    for (double mm = std::floor(first); mm <= last; ++mm)
        found.insert(seam.closed() ? mm - std::floor((mm + 0.5) / length) * length : mm);
}

} // namespace

std::optional<WeldedRange> weldedRange(const Technique& technique) {
    const std::span<const TechniqueStep> steps = technique.steps();
    std::optional<WeldedRange> range;
    for (const StepRange& each : weldedStretches(steps)) {
        if (steps[each.end - 1].time - steps[each.begin].time < kStrikeSeconds) continue;
        for (const TechniqueStep& step : steps.subspan(each.begin, each.end - each.begin)) {
            if (!std::isfinite(step.place)) continue;
            if (!range) range = {{step.place, step.place}, step.place};
            range->stretch.low = std::min(range->stretch.low, step.place);
            range->stretch.high = std::max(range->stretch.high, step.place);
            range->stop = step.place;
        }
    }
    return range;
}

std::vector<double> unknownPlaces(const Technique& technique) {
    const std::span<const TechniqueStep> steps = technique.steps();
    std::set<double> found;
    for (size_t i = 0; i < steps.size(); ++i) {
        if (steps[i].known) continue;
        const size_t begin = i > 0 ? i - 1 : 0; // range from the last known place to the next one
        while (i + 1 < steps.size() && !steps[i].known)
            ++i;
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const TechniqueStep& step : steps.subspan(begin, i + 1 - begin)) {
            if (!std::isfinite(step.place)) continue;
            low = std::min(low, step.place);
            high = std::max(high, step.place);
        }
        if (low <= high) addMillimetres(found, technique.seam(), low, high);
    }
    std::vector<double> places;
    for (const double mm : found)
        places.push_back((std::floor(mm) + 0.5) / kMm);
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
}

std::vector<SeamMillimetre> alongSeam(const Technique& technique) {
    const std::span<const TechniqueStep> steps = technique.steps();
    const std::vector<StepRange> stretches = weldedStretches(steps);
    if (stretches.empty()) return {};
    const auto [first, last] = judgedSteps(steps, stretches);
    Bins bins(technique.seam());
    int direction = 0;
    for (const StepRange& range : stretches) {
        const std::vector<StretchValues> values =
            analyseStretch(steps.subspan(range.begin, range.end - range.begin), technique.settings(), direction);
        direction = values.back().direction;
        for (size_t i = range.begin + 1; i < range.end; ++i)
            bins.add(steps[i - 1], steps[i], values[i - range.begin], i >= first && i < last);
    }
    std::vector<SeamMillimetre> seam = bins.result();
    const std::vector<double> unknown = unknownPlaces(technique);
    for (SeamMillimetre& mm : seam) {
        mm.known = !std::binary_search(unknown.begin(), unknown.end(), mm.place);
        if (mm.known) continue;
        mm.judged = false;
        mm.values = {};
    }
    return seam;
}

std::string techniqueCsv(std::span<const SeamMillimetre> seam, DistanceKind distance) {
    std::string text = "place_mm,arc_s,judged,known,direction";
    for (const QuantityInfo& info : quantities(distance))
        text += "," + std::string(info.column);
    text += ",current_a,voltage_v\n";
    for (const SeamMillimetre& mm : seam) {
        appendNumber(text, static_cast<float>(mm.place * kMm));
        appendCell(text, mm.seconds);
        text += mm.judged ? ",1" : ",0";
        text += mm.known ? ",1," : ",0,";
        text += std::to_string(mm.direction);
        for (const QuantityInfo& info : quantities(distance))
            appendCell(text, mm.values[info.quantity] * info.perSi);
        appendCell(text, mm.current);
        appendCell(text, mm.voltage);
        text += '\n';
    }
    return text;
}

void writeTechniqueCsv(const std::filesystem::path& file, std::span<const SeamMillimetre> seam, DistanceKind distance) {
    writeTextFileAtomically(file, techniqueCsv(seam, distance));
}

} // namespace meltpool
