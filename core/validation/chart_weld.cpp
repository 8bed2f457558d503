// A weld at the values of a maker's chart, on the joint that the chart is for: a tee, a lap or a square butt.
#include "core/validation/case_size.hpp"
#include "core/validation/case_weld.hpp"
#include "core/validation/chart_case.hpp"
#include "core/validation/chart_torch.hpp"
#include "core/weld/workpiece/position.hpp"
#include "core/weld/workpiece/simulated_size.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace meltpool {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kFreezing = 2; // s after the arc
constexpr double kBeyond = 5;   // mm of plate beyond the weld at each end
constexpr float kAcross = 15;   // mm of plate on each side of the seam

/// The case in SI. x along the seam with the joint's middle at 0.
struct ChartWeld {
    ProcessSettings process;
    WorkpieceParameters joint;
    ChartHand hand;
    FaceStretch counted; ///< the stretch that is judged
    double ambient;

    explicit ChartWeld(const ValidationCase& from) : process(caseProcess(from)), ambient(from.number("ambient_k")) {
        counted = {-from.number("seam_mm") / 2e3, from.number("seam_mm") / 2e3};
        const double half = counted.high + from.number("run_in_mm") * 1e-3;
        joint.kind = chartJoint(*from.kind);
        const bool butt = joint.kind == static_cast<int>(WorkpieceKind::Butt);
        if (const auto position = findPosition(from.word("position"))) joint.position = static_cast<int>(*position);
        joint.spacingMm = static_cast<float>(from.spacing * 1e3);
        joint.lengthMm = wholeSpacings(2e3 * half + 2 * kBeyond, joint.spacingMm);
        joint.thicknessMm = static_cast<float>(from.number("thickness_mm"));
        joint.gapMm = static_cast<float>(from.number("gap_mm"));
        joint.widthMm = 2 * kAcross + (butt ? joint.gapMm : 0);
        joint.heightMm = wholeSpacings(static_cast<double>(kAcross), joint.spacingMm);
        if (butt && joint.gapMm >= joint.spacingMm) { // a smaller gap has no room for tacks
            joint.tackCount = 2;
            joint.tackLengthMm = static_cast<float>(kBeyond + 2);
        }
        joint.temperatureC = static_cast<float>(ambient - 273.15);
        const double speed = from.number("speed_mm_s") * from.number("speed_factor") * 1e-3;
        hand.from = -half;
        hand.to = half;
        hand.travel = 2 * half / speed;
        hand.aim = from.number("aim_mm") * 1e-3;
        hand.held = {caseTorchHeight(from, process), (butt ? 90 : 45) * kDegree,
                     from.number("travel_angle_deg") * kDegree};
        hand.weave.width = from.number("weave_mm") * 1e-3;
        hand.weave.frequency = from.number("weave_hz");
        hand.follow = caseBurnOff(from, process);
        if (holdsRod(process) && from.number("rod_diameter_mm") > 0) hand.rod = rodHold(from);
    }

    /// Holds the rod as the lessons do.
    static RodHold rodHold(const ValidationCase& from) {
        RodHold rod;
        rod.below = from.number("arc_length_mm") * 1e-3;
        rod.ahead = from.number("rod_ahead_mm") * 1e-3;
        rod.frequency = from.number("rod_dips_hz");
        rod.feed = from.number("rod_feed_mm_s") * 1e-3;
        return rod;
    }

    double seconds() const { return strikingSeconds(process) + hand.travel; }

    TorchPath path() const { return chartPath(hand, process); }

    NominalWeld nominal(const ValidationCase& from) const {
        NominalWeld nominal;
        nominal.thickness = static_cast<double>(simulatedWorkpiece(joint).thicknessMm) * 1e-3;
        if (from.number("leg_mm") > 0) nominal.leg = from.number("leg_mm") * 1e-3;
        if (nominal.leg && joint.kind == static_cast<int>(WorkpieceKind::Lap)) // its edge has no room for a longer one
            nominal.leg = std::min(*nominal.leg, nominal.thickness);
        return nominal;
    }

    void require(const ValidationCase& from) const {
        const auto thickness = static_cast<double>(joint.thicknessMm) * 1e-3;
        requireSpacings(from, "thickness_mm", thickness, 2);
        const double across = static_cast<double>(joint.widthMm + joint.heightMm) * 1e-3 * thickness;
        // The box around a joint is mostly empty, and its cells take room too.
        requireWeldRoom(from, process, 2 * across * static_cast<double>(joint.lengthMm) * 1e-3, seconds());
    }
};

/// Compares the means over the stations: a fillet's or a butt's.
void compareMeans(const ValidationCase& from, const WeldMeasures& weld, ValidationResult& result) {
    const WeldStation& mean = weld.mean;
    const auto compare = [&](const char* name, const WeldStation::Value& value, double unit) {
        if (value) result.compareMeasured(from, name, *value / unit);
    };
    const auto outside = [](const WeldStation::Value& inside) {
        return inside ? WeldStation::Value(std::numbers::pi - *inside) : std::nullopt;
    };
    compare("leg_lying_mm", mean.leg1, 1e-3);
    compare("leg_standing_mm", mean.leg2, 1e-3);
    compare("throat_mm", mean.throat, 1e-3);
    compare("height_mm", mean.height, 1e-3);
    compare("toe_angle_lying_deg", outside(mean.edgeAngle1), kDegree);
    compare("toe_angle_standing_deg", outside(mean.edgeAngle2), kDegree);
    compare("overlap_lying_mm", mean.overlap1, 1e-3);
    compare("overlap_standing_mm", mean.overlap2, 1e-3);
    compare("undercut_lying_mm", mean.undercut1, 1e-3);
    compare("undercut_standing_mm", mean.undercut2, 1e-3);
    compare("root_fused_percent", mean.rootFused, 1e-2);
    compare("root_fusion_mm", mean.rootFusion, 1e-3);
    compare("root_missing_mm", mean.rootMissing, 1e-3);
    compare("excess_penetration_mm", mean.excessPenetration, 1e-3);
    compare("hole_mm", mean.hole, 1e-3);
    compare("penetration_mm", mean.penetration, 1e-3);
    compare("toe_width_mm", mean.toeWidth, 1e-3);
    compare("fused_width_mm", mean.fusedWidth, 1e-3);
    compare("root_width_mm", mean.rootWidth, 1e-3);
}

/// Means over the middle of the weld: where the arc's heat lands and how warm the plates are before the liquid's edge.
class HeatWatch {
  public:
    HeatWatch(const ChartWeld& chart, const CaseWeld& weld, double solidus)
        : chart_(chart), weld_(weld), solidus_(solidus) {}

    /// Looks ten times a second, while the torch passes the middle half of the weld.
    void look(double time) {
        constexpr double kPause = 0.1, kFrom = 0.3, kTo = 0.8;
        const double way = 1 - (chart_.seconds() - time) / chart_.hand.travel;
        if (way < kFrom || way > kTo || time < next_) return;
        next_ = time + kPause;
        const auto sources = weld_.weld().process().sources();
        const ArcState& arc = weld_.weld().arc();
        if (sources.empty() || !(arc.power > 0)) return;
        const ParticleValues metal = weld_.particles();
        const MetalLattice& lattice = weld_.weld().metal().state().lattice();
        const bool butt = chart_.joint.kind == static_cast<int>(WorkpieceKind::Butt);
        const ArcLanding landing = arcLanding(lattice, metal, sources[0], solidus_, butt);
        const double place = std::lerp(chart_.hand.from, chart_.hand.to, way);
        const LineWarmth line = lineWarmth(lattice, metal, place - kLayers, place, kBeforeLine);
        const std::array<std::optional<double>, kCount> found{
            100 * (1 - static_cast<double>(sources[0].power) / arc.power),
            100 * landing.caught,
            100 * landing.solid,
            100 * landing.ahead,
            100 * landing.lying,
            100 * landing.standing,
            butt ? std::nullopt : line.lying,
            butt ? std::nullopt : line.standing};
        for (size_t i = 0; i < kCount; ++i)
            if (found[i]) {
                sums_[i] += *found[i];
                ++counts_[i];
            }
    }

    void tell(ValidationResult& result) const {
        constexpr std::array<const char*, kCount> kNames{"heat_by_drops_percent",      "arc_caught_percent",
                                                         "arc_on_solid_percent",       "arc_on_solid_ahead_percent",
                                                         "arc_on_solid_lying_percent", "arc_on_solid_standing_percent",
                                                         "line_warmth_lying_k",        "line_warmth_standing_k"};
        for (size_t i = 0; i < kCount; ++i)
            if (counts_[i] > 0) result.tell(kNames[i], sums_[i] / static_cast<double>(counts_[i]));
    }

  private:
    static constexpr size_t kCount = 8;
    static constexpr double kLayers = 4e-3;       ///< m along the seam from the torch back
    static constexpr double kBeforeLine = 0.4e-3; ///< m

    const ChartWeld& chart_;
    const CaseWeld& weld_;
    double solidus_, next_ = 0;
    std::array<double, kCount> sums_{};
    std::array<int, kCount> counts_{};
};

} // namespace

void runChartWeld(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result) {
    const ChartWeld chart(from);
    chart.require(from);
    CaseWeld weld(from, shaders, chart.process, makeWorkpiece(chart.joint), chart.ambient, chart.seconds());
    HeatWatch watch(chart, weld, from.material.solidus);
    const double end = chart.seconds() + kFreezing;
    weld.run(
        chart.path(),
        [&](double time) {
            watch.look(time);
            return time < end;
        },
        result);
    weld.tellArc(from, result);
    watch.tell(result);
    StationSettings stations;
    stations.seam = chart.counted;
    stations.ends = 0;
    result.weld = JudgedWeld{weld.measure(weldKindOf(chart.joint), stations), chart.nominal(from), chart.process,
                             weld.meanCurrent(), weld.meanVoltage()};
    compareMeans(from, result.weld->measures, result);
    weld.requireArc(from);
}

} // namespace meltpool
