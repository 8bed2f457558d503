#include "core/weld/gauge/weld_stations.hpp"

#include "core/base/text.hpp"
#include "core/weld/gauge/weld_figures.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

using Value = WeldStation::Value;

constexpr double kMm = 1e-3;
constexpr double kCraterReach = 8e-3; ///< m before and behind the stop in which its crater lies
constexpr int kCraterLayers = 3;      ///< layers of each cut through it
constexpr size_t kLeastForLine = 3; ///< least number of stations for a straight line

/// Returns the root mean square distance from the line of least squares through (place, middle).
std::optional<double> straightnessOf(const std::vector<WeldStation>& stations) {
    std::vector<std::pair<double, double>> points;
    for (const WeldStation& station : stations)
        if (station.middle) points.emplace_back(station.place, *station.middle);
    if (points.size() < kLeastForLine) return std::nullopt;
    const double count = static_cast<double>(points.size());
    double along = 0, across = 0;
    for (const auto& [x, z] : points) {
        along += x / count;
        across += z / count;
    }
    double xx = 0, xz = 0, zz = 0;
    for (const auto& [x, z] : points) {
        xx += (x - along) * (x - along);
        xz += (x - along) * (z - across);
        zz += (z - across) * (z - across);
    }
    return std::sqrt(std::max(zz - (xx > 0 ? xz * xz / xx : 0), 0.0) / count);
}

/// Returns a weld's throat, or the height of its surface over the face, negative where it lies under it.
std::optional<double> surfaceOf(const WeldStation& station, WeldKind kind) {
    if (kind == WeldKind::fillet) return station.throat;
    return station.underfill.value_or(0) > 0 ? Value(-*station.underfill) : station.height;
}

/// Measures the surface near a place along the seam.
class Crater {
  public:
    Crater(const WeldParticles& particles, const Material& material, WeldKind kind)
        : particles_(particles), material_(material), kind_(kind) {}

    std::optional<double> surfaceAt(double place, double length) const {
        const SectionCut cut = sectionCut(material_, place - 0.5 * length, place + 0.5 * length);
        return surfaceOf(stationOf(measureSection(particles_, cut), kind_, place), kind_);
    }

    /// Returns the depth of the deepest pit within `reach` of the place, found by cuts of `length`, all in m.
    std::optional<double> pitAround(double place, double reach, double length) const {
        std::vector<double> surface;
        const double spacing = static_cast<double>(particles_.lattice().spacing);
        for (double at = place - reach; at <= place + reach; at += spacing)
            if (const auto height = surfaceAt(at, length)) surface.push_back(*height);
        if (surface.empty()) return std::nullopt;
        std::vector<double> behind = surface; // greatest from each place on
        for (size_t i = behind.size() - 1; i-- > 0;)
            behind[i] = std::max(behind[i], behind[i + 1]);
        double before = surface.front(), deepest = 0;
        for (size_t i = 0; i < surface.size(); ++i) {
            before = std::max(before, surface[i]);
            deepest = std::max(deepest, std::min(before, behind[i]) - surface[i]);
        }
        return deepest;
    }

  private:
    const WeldParticles& particles_;
    const Material& material_;
    WeldKind kind_;
};

/// Returns the stretch in both; of no length if there is none.
FaceStretch commonPart(const FaceStretch& a, const FaceStretch& b) {
    const double low = std::max(a.low, b.low);
    return {low, std::max(low, std::min(a.high, b.high))};
}

} // namespace

WeldKind weldKindOf(const WorkpieceParameters& workpiece) {
    switch (static_cast<WorkpieceKind>(workpiece.kind)) {
    case WorkpieceKind::Tee:
    case WorkpieceKind::Lap:
    case WorkpieceKind::Corner:
        return WeldKind::fillet;
    case WorkpieceKind::Butt:
        return WeldKind::butt;
    case WorkpieceKind::Pipe:
        return workpiece.gapMm > 0 || workpiece.bevelDeg > 0 ? WeldKind::butt : WeldKind::bead;
    case WorkpieceKind::Plate:
    case WorkpieceKind::Cube:
    case WorkpieceKind::Bridge:
        break;
    }
    return WeldKind::bead;
}

std::string_view nameOf(WeldKind kind) {
    if (kind == WeldKind::fillet) return "fillet";
    return kind == WeldKind::butt ? "butt" : "bead";
}

std::vector<SectionCut> stationCuts(const Material& material, const FaceStretch& seam, double spacing,
                                    const StationSettings& settings) {
    const double ends = std::min(settings.ends, 0.25 * seam.length());
    const double length = seam.length() - 2 * ends;
    const double count = std::floor(length / settings.pitch + 1e-9);
    const double half = 0.5 * settings.cutLength(spacing);
    std::vector<SectionCut> cuts;
    const double first = seam.low + ends + 0.5 * (length - (count - 1) * settings.pitch);
    for (double i = 0; i < count; ++i) {
        const double at = first + i * settings.pitch;
        cuts.push_back(sectionCut(material, at - half, at + half));
    }
    return cuts;
}

WeldMeasures summarise(std::vector<WeldStation> stations, WeldKind kind, double pitch, double spacing) {
    WeldMeasures measures;
    measures.kind = kind;
    measures.pitch = pitch;
    measures.spacing = spacing;
    StationSettings usual;
    usual.pitch = pitch;
    measures.cut = usual.cutLength(spacing);
    measures.stations = std::move(stations);
    measures.straightness = straightnessOf(measures.stations);
    for (const WeldFigure& figure : stationFigures()) {
        double sum = 0, count = 0;
        for (const WeldStation& station : measures.stations) {
            const auto& value = station.*figure.member;
            if (!value) continue;
            sum += *value;
            ++count;
            auto& least = measures.least.*figure.member;
            auto& greatest = measures.greatest.*figure.member;
            least = std::min(least.value_or(*value), *value);
            greatest = std::max(greatest.value_or(*value), *value);
        }
        if (count > 0) measures.mean.*figure.member = sum / count;
    }
    return measures;
}

WeldMeasures measureWeld(const MetalState& state, std::span<const MetalSeed> original, const Material& material,
                         WeldKind kind, const StationSettings& settings) {
    return measureWeld(WeldParticles(state, original), material, kind, settings);
}

WeldMeasures measureWeld(const WeldParticles& particles, const Material& material, WeldKind kind,
                         const StationSettings& settings) {
    const double spacing = static_cast<double>(particles.lattice().spacing);
    auto seam = settings.seam;
    if (!seam)
        seam = weldedStretch(particles, sectionCut(material, 0, 0).fusion);
    else if (settings.passed)
        seam = commonPart(*seam, *settings.passed);
    std::vector<WeldStation> stations;
    if (seam)
        for (const SectionCut& cut : stationCuts(material, *seam, spacing, settings))
            stations.push_back(stationOf(measureSection(particles, cut), kind, cut.at()));
    WeldMeasures measures = summarise(std::move(stations), kind, settings.pitch, spacing);
    measures.cut = settings.cutLength(spacing);
    measures.asked = settings.seam ? settings.seam->length() : 0;
    if (!settings.stop) return measures;
    measures.stop = *settings.stop;
    const Crater crater(particles, material, kind);
    measures.craterDepth = crater.pitAround(measures.stop, kCraterReach, kCraterLayers * spacing);
    const FaceStretch end = settings.seam.value_or(FaceStretch{measures.stop, measures.stop});
    measures.craterSurface = crater.surfaceAt(std::clamp(measures.stop, end.low, end.high), measures.cut);
    return measures;
}

std::string weldTable(const WeldMeasures& measures) {
    std::string table = "place_mm";
    for (const WeldFigure& figure : stationFigures())
        table += "," + std::string(figure.key);
    table += "\n";
    const auto put = [&](double value) { appendNumber(table, std::round(value * 1e4) / 1e4); };
    for (const WeldStation& station : measures.stations) {
        put(station.place / kMm);
        for (const WeldFigure& figure : stationFigures()) {
            table += ",";
            if (const auto& value = station.*figure.member) put(*value / figure.inSi());
        }
        table += "\n";
    }
    return table;
}

void writeWeldTable(const std::filesystem::path& file, const WeldMeasures& measures) {
    writeTextFileAtomically(file, weldTable(measures));
}

} // namespace meltpool
