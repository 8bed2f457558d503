#include "core/weld/gauge/weld_section.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace meltpool {

namespace {

/// The plate's highest temperatures in one slice across x; rows down from the surface, columns across.
struct Slice {
    Slice(int down, int across) : rows(down), columns(across), peak(static_cast<size_t>(down * across), kGone) {}

    static constexpr double kGone = std::numeric_limits<double>::infinity(); ///< molten and left its cell
    double& at(int row, int column) { return peak[static_cast<size_t>(row * columns + column)]; }
    double at(int row, int column) const { return peak[static_cast<size_t>(row * columns + column)]; }

    int rows, columns;
    std::vector<double> peak;
};

/// Where a row of values that begins inside the hot zone falls below `level`, in cells from the first one's middle.
/// Nothing when even the first is colder.
std::optional<double> crossing(const std::vector<double>& values, double level) {
    if (values.empty() || values[0] < level) return std::nullopt;
    for (size_t i = 1; i < values.size(); ++i) {
        if (values[i] >= level) continue;
        const double place = static_cast<double>(i);
        if (std::isfinite(values[i - 1])) return place - (level - values[i]) / (values[i - 1] - values[i]);
        // The hotter cell is gone: go on towards its middle with a slope that grows as it did over the three before it.
        const double slope = i + 1 < values.size() ? values[i] - values[i + 1] : 0;
        const double before = i + 2 < values.size() ? values[i + 1] - values[i + 2] : 0;
        const double steeper = before > 0 ? std::max(slope, slope * slope / before) : slope;
        return place - (slope > 0 ? std::min(1.0, (level - values[i]) / steeper) : 0.5);
    }
    return static_cast<double>(values.size()) - 0.5;
}

/// Depth (cells) of the zone above `level` below the surface, and its width at the surface.
struct Zone {
    double depth = 0;
    double width = 0;
    double area = 0;
};

Zone zoneOf(const Slice& slice, double level) {
    Zone zone;
    for (int column = 0; column < slice.columns; ++column) {
        std::vector<double> down;
        for (int row = 0; row < slice.rows; ++row)
            down.push_back(slice.at(row, column));
        if (const auto depth = crossing(down, level)) {
            zone.depth = std::max(zone.depth, *depth + 0.5); // the first cell's middle lies half a cell down
            zone.area += *depth + 0.5;
        }
    }
    int hottest = 0;
    for (int column = 1; column < slice.columns; ++column)
        if (slice.at(0, column) > slice.at(0, hottest)) hottest = column;
    for (const int side : {-1, 1}) {
        std::vector<double> out;
        for (int column = hottest; column >= 0 && column < slice.columns; column += side)
            out.push_back(slice.at(0, column));
        if (const auto half = crossing(out, level)) zone.width += *half;
    }
    return zone;
}

} // namespace

Section measureSection(const MetalState& state, const SectionCut& cut) {
    const auto spacing = static_cast<double>(state.lattice().spacing);
    const glm::ivec3 cells = state.lattice().cells();
    const auto low = glm::dvec3(state.lattice().low);
    const auto index = [&](double place, double from) {
        return static_cast<int>(std::floor((place - from) / spacing));
    };
    const int firstSlice = index(cut.from + 0.5 * spacing, low.x);
    const int slices = std::max(1, static_cast<int>(std::lround((cut.to - cut.from) / spacing)));
    const int rows = static_cast<int>(std::lround(cut.thickness / spacing));
    std::vector<Slice> plate(static_cast<size_t>(slices), Slice(rows, cells.z));
    std::vector<std::vector<double>> above(static_cast<size_t>(slices),
                                           std::vector<double>(static_cast<size_t>(cells.z)));
    std::vector<size_t> count(static_cast<size_t>(slices));

    const auto positions = state.position.read<vec4>(state.particles());
    const auto heats = state.heat.read<vec4>(state.particles());
    const auto phases = state.phase.read<uint>(state.particles());
    int firstColumn = cells.z, lastColumn = -1;
    for (size_t i = 0; i < positions.size(); ++i) {
        if (!(phases[i] & PHASE_ALIVE)) continue;
        const glm::dvec3 place(positions[i]);
        const int slice = index(place.x, low.x) - firstSlice;
        const int column = index(place.z, low.z);
        if (slice < 0 || slice >= slices || column < 0 || column >= cells.z) continue;
        const auto s = static_cast<size_t>(slice);
        ++count[s];
        if (place.y > cut.surface) above[s][static_cast<size_t>(column)] += 1;
        const int row = index(-place.y, -cut.surface);
        if (!(phases[i] & PHASE_LATTICE) || row < 0 || row >= rows) continue;
        plate[s].at(row, column) = static_cast<double>(heats[i].z);
        firstColumn = std::min(firstColumn, column);
        lastColumn = std::max(lastColumn, column);
    }
    Section sum;
    for (size_t s = 0; s < plate.size(); ++s) {
        // Beside the plate there is air, not molten metal.
        for (int row = 0; row < rows; ++row)
            for (int column = 0; column < cells.z; ++column)
                if (column < firstColumn || column > lastColumn) plate[s].at(row, column) = 0;
        const Zone fusion = zoneOf(plate[s], cut.fusion);
        const Zone affected = zoneOf(plate[s], cut.heatAffected);
        sum.width += fusion.width * spacing;
        sum.penetration += fusion.depth * spacing;
        sum.fused += fusion.area * spacing * spacing;
        sum.heatAffectedWidth += affected.width * spacing;
        sum.heatAffectedDepth += affected.depth * spacing;
        const double had = static_cast<double>(rows * (lastColumn - firstColumn + 1));
        sum.deposited += (static_cast<double>(count[s]) - had) * spacing * spacing;
    }
    // Columns of metal above the surface, evened over the slices and three columns: a single particle is no bead.
    for (int column = 1; column + 1 < cells.z; ++column) {
        double metal = 0;
        for (const auto& slice : above)
            for (int beside = -1; beside <= 1; ++beside)
                metal += slice[static_cast<size_t>(column + beside)] / 3;
        sum.height = std::max(sum.height, metal * spacing);
    }
    const auto all = static_cast<double>(plate.size());
    for (double* value : {&sum.width, &sum.penetration, &sum.height, &sum.deposited, &sum.fused, &sum.heatAffectedWidth,
                          &sum.heatAffectedDepth})
        *value /= all;
    return sum;
}

} // namespace meltpool
