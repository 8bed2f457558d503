#include "core/weld/gauge/weld_stations.hpp"

#include "core/base/text.hpp"
#include "core/weld/gauge/weld_figures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace meltpool {

namespace {

constexpr double kMm = 1e-3;
constexpr size_t kLeastForLine = 3; ///< stations that a straight line is told from

/// A weld without toes is as wide as nothing.
void takeBead(const BeadShape& bead, const std::optional<FaceStretch>& fused, WeldStation& station) {
    station.toeWidth = bead.toeWidth();
    station.height = bead.height;
    if (bead.toes) {
        station.edgeAngle1 = (*bead.toes)[0].angle;
        station.edgeAngle2 = (*bead.toes)[1].angle;
        station.middle = 0.5 * ((*bead.toes)[0].place + (*bead.toes)[1].place);
        station.overlap1 = fused ? fused->low - bead.cover.low : 0.5 * bead.cover.length();
        station.overlap2 = fused ? bead.cover.high - fused->high : 0.5 * bead.cover.length();
    } else if (fused) {
        station.middle = 0.5 * (fused->low + fused->high);
    }
}

void takeButt(const Section& section, WeldStation& station) {
    station.rootFused = section.rootFused;
    station.facesFused = section.facesFused;
    station.rootConcavity = section.rootConcavity;
    if (!section.unfusedEdges) return;
    const auto [less, more] = std::minmax((*section.unfusedEdges)[0], (*section.unfusedEdges)[1]);
    station.rootMissing = less > 0 ? less : -section.root.height;
    station.lackOfFusion = more > 0 ? more - less : -section.root.height;
}

/// Length of a fillet's face that is not fused from the corner outwards.
double unfusedFrom(const FaceStretch& fused, double leg) {
    return fused.length() > 0 ? std::min(fused.low, leg) : leg;
}

void takeFillet(const Section& section, WeldStation& station) {
    const FilletShape fillet = section.fillet.value_or(FilletShape{});
    station.leg1 = fillet.toes[0].place;
    station.leg2 = fillet.toes[1].place;
    station.throat = fillet.throat;
    station.convexity = fillet.convexity;
    station.toeWidth = fillet.faceWidth();
    station.rootFused = section.rootFused;
    station.facesFused = section.facesFused;
    station.rootFusion = section.rootFusion;
    if (section.fillet) {
        station.edgeAngle1 = fillet.toes[0].angle;
        station.edgeAngle2 = fillet.toes[1].angle;
        station.middle = (*station.leg1 - *station.leg2) / (2 * std::numbers::sqrt2);
    }
    if (!section.fusedFaces) return;
    const auto& [lying, standing] = *section.fusedFaces;
    const double unfused = std::max(unfusedFrom(lying, *station.leg1), unfusedFrom(standing, *station.leg2));
    station.lackOfFusion = unfused > 0 ? unfused : -section.rootFusion.value_or(0);
    if (!section.fillet) return;
    station.overlap1 = *station.leg1 - lying.high;
    station.overlap2 = *station.leg2 - standing.high;
}

/// Root mean square distance from the line of least squares through (place, middle).
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

WeldStation stationOf(const Section& section, WeldKind kind, double place) {
    WeldStation station;
    station.place = place;
    if (section.layers == 0) return station;
    station.fusedWidth = section.fusion.width;
    station.penetration = section.fusion.depth;
    station.undercut1 = section.undercut[0];
    station.undercut2 = section.undercut[1];
    if (!section.openCorner) {
        station.excessPenetration = section.root.height;
        station.rootWidth = section.root.toeWidth();
    }
    station.hole = section.hole;
    station.deposited = section.deposited;
    if (section.heatAffected)
        station.hazWidth = std::max(0.5 * (section.heatAffected->width - section.fusion.width), 0.0);
    station.coolingTime = section.coolingTime;
    if (kind == WeldKind::fillet) {
        takeFillet(section, station);
        return station;
    }
    takeBead(section.bead.value_or(BeadShape{}), section.fusedTop, station);
    station.underfill = section.underfill;
    if (kind == WeldKind::butt) {
        takeButt(section, station);
        return station;
    }
    station.facesFused = section.fusion.depth > 0 ? 1 : 0;
    station.lackOfFusion = section.fusion.depth > 0 ? -section.fusion.depth : *station.toeWidth;
    return station;
}

std::vector<SectionCut> stationCuts(const Material& material, const FaceStretch& seam, double spacing,
                                    const StationSettings& settings) {
    const double ends = std::min(settings.ends, 0.25 * seam.length());
    const double length = seam.length() - 2 * ends;
    const double count = std::floor(length / settings.pitch + 1e-9);
    const double half = 0.5 * std::max(settings.pitch, settings.layers * spacing);
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
    return summarise(std::move(stations), kind, settings.pitch, spacing);
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
