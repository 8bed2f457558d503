#include "core/weld/gauge/weld_stations.hpp"

#include "core/base/text.hpp"
#include "core/weld/gauge/weld_figures.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr double kMm = 1e-3;
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
    if (!seam) seam = weldedStretch(particles, sectionCut(material, 0, 0).fusion);
    std::vector<WeldStation> stations;
    if (seam)
        for (const SectionCut& cut : stationCuts(material, *seam, spacing, settings))
            stations.push_back(stationOf(measureSection(particles, cut), kind, cut.at()));
    WeldMeasures measures = summarise(std::move(stations), kind, settings.pitch, spacing);
    measures.cut = settings.cutLength(spacing);
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
