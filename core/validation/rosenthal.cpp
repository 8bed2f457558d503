// A source that moves along a plate, compared with Rosenthal's point and line sources once it has settled.
#include "core/validation/case_size.hpp"
#include "core/validation/exact_solutions.hpp"
#include "core/validation/heat_rig.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

/// The plate and the path: x along the travel from 0, y up with the surface at 0, z across with the path at 0.
struct MovingPlate {
    exact::MovingSource source;
    double thickness = 0; ///< thickness of a thin plate, m; 0: thick
    double time = 0;      ///< s until all compared places have settled; at least the case's
    double travel = 0;    ///< length of the path, m
    double behind = 0, ahead = 0, side = 0, depth = 0;
};

/// Returns points relative to the source: xi ahead, across, down; m.
std::vector<glm::dvec3> pointsOf(const ValidationCase& from) {
    std::vector<glm::dvec3> points;
    const auto& at = from.list("at_mm");
    for (size_t i = 0; i + 2 < at.size(); i += 3)
        points.emplace_back(at[i] * 1e-3, at[i + 1] * 1e-3, at[i + 2] * 1e-3);
    return points;
}

double distanceOf(const MovingPlate& p, const glm::dvec3& point) {
    return p.thickness > 0 ? std::hypot(point.x, point.y) : glm::length(point);
}

/// Returns the time of travel until the field around the source is constant within a thousandth, at least `least` (s).
double settlingTime(const MovingPlate& p, const std::vector<glm::dvec3>& points, double least) {
    std::vector<double> distances{p.behind};
    for (const glm::dvec3& point : points)
        distances.push_back(distanceOf(p, point));
    const auto settled = [&](double time) {
        for (const double distance : distances)
            if (exact::settledShare(p.source, distance, time, p.thickness > 0) < 0.999) return false;
        return true;
    };
    double time = least;
    while (!settled(time))
        time *= 1.05;
    return time;
}

MovingPlate plan(const ValidationCase& from, const Material& m) {
    MovingPlate p;
    const double initial = from.number("initial_temperature_k");
    const double k = m.solidConductivity.at(0);
    const double alpha = k / (m.solidDensity.at(0) * m.solidSpecificHeat.at(0));
    p.source = {from.number("power_w"), from.number("speed_mm_s") * 1e-3, k, alpha, initial};
    if (from.kind->name == "rosenthal_thin") p.thickness = from.number("thickness_mm") * 1e-3;
    const auto points = pointsOf(from);
    double across = 0;
    for (const glm::dvec3& point : points) {
        p.behind = std::max(p.behind, -point.x);
        p.ahead = std::max(p.ahead, point.x);
        across = std::max({across, std::abs(point.y), std::abs(point.z)});
    }
    p.behind = std::max({p.behind, across, 5 * from.spacing});
    p.time = settlingTime(p, points, from.time);
    p.travel = p.source.speed * p.time;
    // Heat that is `behind` old has spread so far; three and a half deviations keep the edges out of it. Beside and
    // before the source the rise falls by e within 2 alpha/v and alpha/v.
    const double spread = std::sqrt(2 * alpha * 1.5 * p.behind / p.source.speed);
    const double reach = alpha / p.source.speed;
    p.side = std::max({3.5 * spread, 1.4 * across, across + 6 * reach}) + 4 * from.spacing;
    p.ahead = std::max({0.5 * p.side, 7 * reach, 1.2 * p.ahead + 4 * reach}) + 2 * from.spacing;
    p.depth = p.thickness > 0 ? std::max(1.0, std::round(p.thickness / from.spacing)) * from.spacing : p.side;
    return p;
}

/// A lattice field that can be read anywhere, mirrored at the surface.
class Field {
  public:
    Field(const MetalLattice& lattice, const MetalState& state, int top)
        : lattice_(lattice), top_(top), values_(lattice.cellCount(), std::nan("")) {
        for (const vec4& p : state.position.read<vec4>(state.particles()))
            values_[lattice.index(lattice.cellAt(glm::vec3(p)))] = static_cast<double>(p.w);
    }

    double cell(glm::ivec3 c) const {
        if (c.y > top_) c.y = 2 * top_ + 1 - c.y; // no heat crosses the surface, so the field goes on as in a mirror
        c = glm::clamp(c, glm::ivec3(0), lattice_.cells() - 1);
        return values_[lattice_.index(c)];
    }

    /// Returns the polynomial through the six nearest cells along each axis: beside a fast source the rise changes by e
    /// from cell to cell.
    double at(glm::dvec3 place) const {
        const glm::dvec3 q = (place - glm::dvec3(lattice_.low)) / static_cast<double>(lattice_.spacing) - 0.5;
        const glm::ivec3 base(glm::floor(q));
        std::array<double, kNodes.size()> alongX{}, alongY{}, alongZ{};
        for (size_t i = 0; i < kNodes.size(); ++i) {
            for (size_t j = 0; j < kNodes.size(); ++j) {
                for (size_t k = 0; k < kNodes.size(); ++k)
                    alongZ[k] = cell(base + glm::ivec3(kNodes[i], kNodes[j], kNodes[k]));
                alongY[j] = interpolate(kNodes, alongZ, q.z - base.z);
            }
            alongX[i] = interpolate(kNodes, alongY, q.y - base.y);
        }
        return interpolate(kNodes, alongX, q.x - base.x);
    }

  private:
    static constexpr std::array<double, 6> kNodes{-2, -1, 0, 1, 2, 3};

    MetalLattice lattice_;
    int top_;
    std::vector<double> values_;
};

double exactAt(const MovingPlate& p, double xi, double across, double down) {
    return p.thickness > 0 ? exact::rosenthalThin(p.source, p.thickness, xi, across)
                           : exact::rosenthalThick(p.source, xi, across, down);
}

/// Compares root mean square and largest error, in per cent of the local rise, beside and behind the source, beyond
/// three cells, for a rise of at least a hundredth of the hottest compared.
void compareField(const ValidationCase& from, const MovingPlate& p, const MetalState& state, ValidationResult& result) {
    const double far = 3 * from.spacing;
    double squares = 0;
    double largest = 0;
    size_t count = 0;
    const double hottest = exactAt(p, -far, 0, 0) - p.source.ambient;
    for (const vec4& particle : state.position.read<vec4>(state.particles())) {
        const double xi = static_cast<double>(particle.x) - p.travel;
        const double down = -static_cast<double>(particle.y);
        const double across = static_cast<double>(particle.z);
        const double distance = p.thickness > 0 ? std::hypot(xi, across) : std::hypot(xi, across, down);
        if (xi > 0 || xi < -p.behind || distance < far) continue;
        const double rise = exactAt(p, xi, across, down) - p.source.ambient;
        if (rise < 0.01 * hottest) continue;
        const double error = (static_cast<double>(particle.w) - p.source.ambient - rise) / rise;
        squares += error * error;
        largest = std::max(largest, std::abs(error));
        ++count;
    }
    if (count == 0) return; // no place is left: the plate is small or the source leads all heat
    const double rms = 100 * std::sqrt(squares / static_cast<double>(count));
    const auto judge = [&](const std::string& name, double ours) {
        if (from.number(name) > 0)
            result.compareLimit(name, from.number(name), ours);
        else
            result.tell(name, ours);
    };
    judge("field_rms_percent", rms);
    judge("field_max_percent", 100 * largest);
}

} // namespace

void runRosenthal(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result) {
    const Material material = unmeltingMaterial(from.material, from.number("initial_temperature_k"));
    const MovingPlate p = plan(from, material);
    const auto h = static_cast<float>(from.spacing);
    const auto metres = [](double v) { return static_cast<float>(v); };
    // A row of cells has its middle on the path, so that the source has no width that the exact one has not.
    const float side = (std::ceil(metres(p.side) / h) + 0.5F) * h;
    const float depth = std::round(metres(p.depth) / h) * h;
    const glm::vec3 low(-0.5F * side, -depth, -side);
    const glm::vec3 high(metres(p.travel + p.ahead), 0, side);
    const MetalLattice lattice = MetalLattice::covering(low, high, h);
    const auto cells = static_cast<double>(lattice.cellCount());
    requireCapacity(from, {cells, cells, 0, 0});
    const auto seeds = latticeSeeds(lattice, low, high, metres(p.source.ambient));
    HeatSettings settings;
    settings.ambient = p.source.ambient;
    HeatRig bench(shaders, lattice, material, seeds, settings);
    requireSteps(from, p.time / bench.solver.longestStep(p.source.ambient + 1));
    // A thin plate is the best-fitting number of layers; each takes the power of a layer of its depth in the true
    // plate.
    const double power = p.source.power * (p.thickness > 0 ? static_cast<double>(depth) / p.thickness : 1);
    // The narrowest source on cells is as wide as a point source's heat after a time of dx²/(8 alpha), and the heat of
    // a step has not spread yet at the step's end: there the source is at the point source's place of that time before.
    // The half-axes give a second moment of dx²/4 along each direction.
    const double hottest = p.source.ambient + 1; // any temperature will do for a constant material
    const double halfStep = 0.5 * p.time / static_cast<double>(bench.stepsFor(p.time, hottest));
    const double lag = from.spacing * from.spacing / (8 * p.source.alpha) - halfStep;
    const auto source = [&](double time) {
        const glm::vec3 place(metres(p.source.speed * (time - lag)), 0, 0);
        const float deep = p.thickness > 0 ? 1e3F : 0.5F * h; // the whole thickness, or the top layer alone
        return std::vector{HeatSource::ellipsoid(place, {0, -1, 0}, {1, 0, 0}, 1.294F * h, deep, 1.22F * h, 1.22F * h,
                                                 1, metres(power))};
    };
    result.particles = bench.state.particles();
    result.steps = bench.run(0, p.time, hottest, source);

    const int top = static_cast<int>(std::lround(depth / h)) - 1;
    const Field field(lattice, bench.state, top);
    const auto& at = from.list("at_mm");
    const auto points = pointsOf(from);
    for (size_t i = 0; i < points.size(); ++i) {
        const glm::dvec3& point = points[i];
        const double reference = exactAt(p, point.x, point.y, point.z);
        const std::string name = temperatureName(at[3 * i], at[3 * i + 1], at[3 * i + 2]);
        result.compareExact(from, name, reference, field.at({p.travel + point.x, -point.z, point.y}),
                            reference - p.source.ambient);
    }
    compareField(from, p, bench.state, result);
    if (p.time > from.time) result.tell("settled_after_s", p.time);
}

} // namespace meltpool
