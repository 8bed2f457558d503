#include "core/training/judging/bend_test.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr double kRounding = 1e-9; ///< m: rounding of sums of pitches

/// Opening of a stretched face at a station.
struct Gape {
    bool open = false, resolved = true;
    double depth = 0; ///< m
};

/// `unfused`: m without fusion under the face; negative: fused so far beyond.
Gape gapeOf(double unfused, double resolution) {
    if (unfused > resolution) return {true, true, unfused};
    if (unfused <= -resolution) return {};
    return {true, false, std::max(unfused, 0.0)};
}

/// Unfused height of a butt's worse edge, from the lower face upwards; negative as in WeldStation.
double worseEdge(const WeldStation& station) {
    const double both = station.rootMissing.value_or(0), more = station.lackOfFusion.value_or(0);
    if (both > 0 || more > 0) return std::max(both, 0.0) + std::max(more, 0.0);
    return std::max(both, more);
}

Gape rootGape(const WeldStation& station, double thickness, double resolution) {
    if (station.hole.value_or(0) > 0) return {true, true, thickness};
    return gapeOf(worseEdge(station), resolution);
}

/// The upper face gapes if an edge is unfused up to it, and is closed if the edge is fused that far below it.
Gape faceGape(const WeldStation& station, double thickness, double resolution) {
    if (station.hole.value_or(0) > 0) return {true, true, thickness};
    const double left = thickness - worseEdge(station); // fused height
    if (left < resolution) return {true, true, thickness};
    if (left < 2 * resolution) return {true, false, thickness};
    return {};
}

/// True if the station has a value that this test needs.
bool tells(const WeldStation& station) {
    return station.lackOfFusion.has_value();
}

Gape gapeOf(const WeldStation& station, BendKind kind, double thickness, double resolution) {
    if (!tells(station)) return {true, false, 0};
    if (kind == BendKind::face) return faceGape(station, thickness, resolution);
    if (kind == BendKind::root) return rootGape(station, thickness, resolution);
    if (station.throat.value_or(0) <= 0) return {true, true, thickness}; // without a fillet
    return gapeOf(*station.lackOfFusion, resolution);
}

class Bender {
  public:
    Bender(const WeldMeasures& weld, double thickness, const BendRule& rule)
        : weld_(weld), thickness_(thickness), rule_(rule), resolution_(kResolvedSpacings * weld.spacing) {}

    BendTest bend() const {
        BendTest test;
        test.plate = thickness_;
        const bool fillet = weld_.kind == WeldKind::fillet, sideways = thickness_ > rule_.sideThickness + kRounding;
        test.thickness = !fillet && sideways ? rule_.sideThickness : thickness_;
        test.former = fillet ? 0 : rule_.diameter * test.thickness;
        if (fillet) {
            test.straps.push_back(alongSeam(BendKind::filletBreak, 0, weld_.stations.size()));
        } else if (sideways) {
            cut(rule_.sideThickness, [&](size_t first, size_t end) { test.straps.push_back(across(first, end)); });
        } else {
            for (const BendKind kind : {BendKind::root, BendKind::face})
                cut(rule_.strapWidth,
                    [&](size_t first, size_t end) { test.straps.push_back(alongSeam(kind, first, end)); });
        }
        test.state = stateOf(test.straps);
        return test;
    }

  private:
    double begin(size_t station) const { return weld_.stations[station].place - 0.5 * weld_.pitch; }
    double end(size_t station) const { return weld_.stations[station].place + 0.5 * weld_.pitch; }

    /// Divides the stations into equal straps, each at least `width` wide if the weld is long enough.
    template <class Take>
    void cut(double width, const Take& take) const {
        const size_t count = weld_.stations.size();
        const auto whole = static_cast<size_t>((weld_.length() + kRounding) / width);
        const size_t straps = std::clamp<size_t>(whole, 1, count);
        for (size_t i = 0; i < straps; ++i)
            take(i * count / straps, (i + 1) * count / straps);
    }

    BentStrap strap(BendKind kind, size_t first, size_t last) const {
        BentStrap strap;
        strap.kind = kind;
        strap.from = begin(first);
        strap.to = end(last - 1);
        return strap;
    }

    BentStrap alongSeam(BendKind kind, size_t first, size_t last) const {
        BentStrap bent = strap(kind, first, last);
        bool joined = false; // the station before gaped in this way too
        for (size_t i = first; i < last; ++i) {
            const Gape gape = gapeOf(weld_.stations[i], kind, thickness_, resolution_);
            if (joined && gape.open && bent.openings.back().resolved == gape.resolved) {
                bent.openings.back().to = end(i);
                bent.openings.back().depth = std::max(bent.openings.back().depth, gape.depth);
            } else if (gape.open) {
                bent.openings.push_back({begin(i), end(i), gape.depth, gape.resolved, i == first});
            }
            joined = gape.open;
            if (joined && i + 1 == last) bent.openings.back().atCorner = true;
        }
        judge(bent);
        return bent;
    }

    /// A strap bent sideways: its station with most unfused height.
    BentStrap across(size_t first, size_t last) const {
        BentStrap bent = strap(BendKind::side, first, last);
        Gape worst;
        for (size_t i = first; i < last; ++i) {
            const WeldStation& station = weld_.stations[i];
            const Gape gape = tells(station) ? rootGape(station, thickness_, resolution_) : Gape{true, false, 0};
            const bool worse = gape.open && (!worst.open || gape.resolved > worst.resolved ||
                                             (gape.resolved == worst.resolved && gape.depth > worst.depth));
            if (worse) worst = gape;
        }
        if (worst.open) {
            const double height = worst.resolved ? worst.depth : std::max(worst.depth, resolution_);
            bent.openings.push_back({0, std::min(height, thickness_), 0, worst.resolved, true});
        }
        judge(bent);
        return bent;
    }

    bool breaks(const BentStrap& bent, bool withUnresolved) const {
        std::vector<BendOpening> joined; // touching openings are one
        for (const BendOpening& opening : bent.openings) {
            if (!opening.resolved && !withUnresolved) continue;
            if (joined.empty() || opening.from > joined.back().to + kRounding) {
                joined.push_back(opening);
                continue;
            }
            joined.back().to = opening.to;
            joined.back().atCorner |= opening.atCorner;
        }
        if (bent.kind == BendKind::filletBreak) return !joined.empty();
        double together = 0;
        for (const BendOpening& opening : joined) {
            const double most = opening.atCorner ? std::min(rule_.corner, rule_.single) : rule_.single;
            if (opening.length() > most + kRounding) return true;
            if (opening.length() > rule_.counted + kRounding) together += opening.length();
        }
        return together > rule_.together + kRounding;
    }

    void judge(BentStrap& bent) const {
        for (const BendOpening& opening : bent.openings) {
            if (!opening.resolved) continue;
            bent.longest = std::max(bent.longest, opening.length());
            if (opening.length() > rule_.counted + kRounding) bent.together += opening.length();
        }
        bent.state = breaks(bent, false)  ? VerdictState::fail
                     : breaks(bent, true) ? VerdictState::notResolved
                                          : VerdictState::pass;
    }

    static VerdictState stateOf(const std::vector<BentStrap>& straps) {
        const auto any = [&](VerdictState state) {
            return std::any_of(straps.begin(), straps.end(), [&](const BentStrap& s) { return s.state == state; });
        };
        if (any(VerdictState::fail)) return VerdictState::fail;
        return any(VerdictState::notResolved) ? VerdictState::notResolved : VerdictState::pass;
    }

    const WeldMeasures& weld_;
    double thickness_;
    BendRule rule_;
    double resolution_;
};

} // namespace

std::optional<BendTest> bendTest(const WeldMeasures& weld, double thickness, const BendRule& rule) {
    if (weld.kind == WeldKind::bead || weld.stations.empty() || !(thickness > 0)) return std::nullopt;
    return Bender(weld, thickness, rule).bend();
}

} // namespace meltpool
