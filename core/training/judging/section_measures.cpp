#include "core/training/judging/section_measures.hpp"

#include "core/base/words.hpp"
#include "core/weld/gauge/weld_figures.hpp"
#include "core/weld/gauge/weld_outline.hpp"
#include "core/weld/workpiece/simulated_size.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <optional>

namespace meltpool {

namespace {

constexpr double kMm = 1e-3;
constexpr double kDegree = std::numbers::pi / 180;
constexpr double kInside = 0.5; ///< weight of the map from which on there is metal

using Place = glm::dvec2; ///< m (z, y)

/// Finds in the map the places of measures.
class Anchors {
  public:
    Anchors(const SectionMap& map, double fusion) : map_(map), fusion_(fusion), outline_(weldOutline(map)) {}

    /// The place of fused metal under the faces that is farthest from them; `depth`: its distance, at most 0 outside.
    template <class Depth>
    std::optional<Place> deepestFused(Depth depth) const {
        std::optional<Place> deepest;
        double most = 0;
        for (int row = 0; row < map_.texels.y; ++row)
            for (int column = 0; column < map_.texels.x; ++column) {
                const Place place = placeOf({column, row});
                if (depth(place) <= most || !fusedAt({column, row})) continue;
                most = depth(place);
                deepest = place;
            }
        return deepest;
    }

    /// Centre across the seam of the fused metal at a height.
    std::optional<double> fusedMiddle(double height) const {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        const int row = rowOf(height);
        for (int column = 0; column < map_.texels.x; ++column) {
            if (row < 0 || row >= map_.texels.y || !fusedAt({column, row})) continue;
            low = std::min(low, placeOf({column, row}).x);
            high = std::max(high, placeOf({column, row}).x);
        }
        return low <= high ? std::optional(0.5 * (low + high)) : std::nullopt;
    }

    /// True if metal at a place has been molten.
    bool fused(Place place) const {
        const glm::dvec2 share = (place - Place(map_.low)) / Place(map_.size) * glm::dvec2(map_.texels);
        const glm::ivec2 texel(glm::floor(share));
        return texel.x >= 0 && texel.y >= 0 && texel.x < map_.texels.x && texel.y < map_.texels.y && fusedAt(texel);
    }

    /// The place of the outline with the greatest `measure`, among places that have a value for it.
    template <class Measure>
    std::optional<Place> onOutline(Measure measure) const {
        std::optional<Place> best;
        double most = -std::numeric_limits<double>::infinity();
        for (const Place place : outline_) {
            const std::optional<double> value = measure(place);
            if (!value || *value <= most) continue;
            most = *value;
            best = place;
        }
        return best;
    }

  private:
    bool fusedAt(glm::ivec2 texel) const {
        const glm::vec4& sum = map_.sums[static_cast<size_t>(texel.y * map_.texels.x + texel.x)];
        return static_cast<double>(sum.x) >= kInside && static_cast<double>(sum.y / sum.x) >= fusion_;
    }
    Place placeOf(glm::ivec2 texel) const {
        return Place(map_.low) + (glm::dvec2(texel) + 0.5) / glm::dvec2(map_.texels) * Place(map_.size);
    }
    int rowOf(double height) const {
        const double share = (height - static_cast<double>(map_.low.y)) / static_cast<double>(map_.size.y);
        return static_cast<int>(std::floor(share * map_.texels.y));
    }

    const SectionMap& map_;
    double fusion_;
    WeldOutline outline_;
};

using Member = WeldStation::Value WeldStation::*;

/// "leg 7.0" of 7 mm.
std::string lengthLabel(Member figure, double metres) {
    return phrase("drawing.measure.length",
                  {{"figure", stationFigure(figure).drawnWords()}, {"length", PhraseNumber(metres / kMm, 1)}});
}

/// "leg < 0.5" for a length that is not resolved.
std::string limitLabel(Member figure, double metres) {
    char limit[32];
    std::snprintf(limit, sizeof limit, "%.2g", metres / kMm);
    return phrase("drawing.measure.below",
                  {{"figure", stationFigure(figure).drawnWords()}, {"length", withDecimalMark(limit)}});
}

std::string angleLabel(Member figure, double radians) {
    return phrase("drawing.measure.angle",
                  {{"figure", stationFigure(figure).drawnWords()}, {"angle", PhraseNumber(radians / kDegree)}});
}

class Marks {
  public:
    Marks(const WeldStation& station, const SectionMap& map, double fusion)
        : station_(station),
          anchors_(map, fusion),
          spacing_(static_cast<double>(map.spacing)),
          resolution_(kResolvedSpacings * spacing_) {}

    std::vector<SectionMark> take() { return std::move(marks_); }

    void drawFillet() {
        const double leg1 = station_.leg1.value_or(0), leg2 = station_.leg2.value_or(0);
        drawUnfusedCorner(leg1, leg2);
        if (leg1 <= 0 || leg2 <= 0) return;
        const Place base(leg1, 0), upright(0, leg2), corner(0);
        length(&WeldStation::leg1, corner, base);
        length(&WeldStation::leg2, corner, upright);
        length(&WeldStation::toeWidth, base, upright);
        length(&WeldStation::throat, corner, station_.throat.value_or(0) * throatWay());
        drawConvexity(base, upright);
        drawCornerPenetration();
        length(&WeldStation::rootFusion, corner, Place(-station_.rootFusion.value_or(0), 0));
        angle(&WeldStation::edgeAngle1, base, {-1, 0}, {0, 1});
        angle(&WeldStation::edgeAngle2, upright, {0, -1}, {1, 0});
        fault(&WeldStation::overlap1, spacing_, base, base - Place(station_.overlap1.value_or(0), 0));
        fault(&WeldStation::overlap2, spacing_, upright, upright - Place(0, station_.overlap2.value_or(0)));
        const Place beside(spacing_, -station_.undercut1.value_or(0)), over(-station_.undercut2.value_or(0), spacing_);
        fault(&WeldStation::undercut1, resolution_, base + Place(spacing_, 0), base + beside);
        fault(&WeldStation::undercut2, resolution_, upright + Place(0, spacing_), upright + over);
    }

    void drawLevel(const SectionFaces& faces, bool butt) {
        const double upper = faces.upper, middle = station_.middle.value_or(0);
        const double half = 0.5 * station_.toeWidth.value_or(0);
        const Place low(middle - half, upper), high(middle + half, upper);
        length(&WeldStation::toeWidth, low, high);
        drawFusedWidth(upper);
        drawUpAndDown(upper, butt);
        if (half > 0) {
            angle(&WeldStation::edgeAngle1, low, {1, 0}, {0, 1});
            angle(&WeldStation::edgeAngle2, high, {-1, 0}, {0, 1});
            fault(&WeldStation::overlap1, spacing_, low, low + Place(station_.overlap1.value_or(0), 0));
            fault(&WeldStation::overlap2, spacing_, high, high - Place(station_.overlap2.value_or(0), 0));
        }
        const Place before = low - Place(spacing_, 0), after = high + Place(spacing_, 0);
        fault(&WeldStation::undercut1, resolution_, before, before - Place(0, station_.undercut1.value_or(0)));
        fault(&WeldStation::undercut2, resolution_, after, after - Place(0, station_.undercut2.value_or(0)));
        const Place top(middle, upper);
        fault(&WeldStation::underfill, resolution_, top, top - Place(0, station_.underfill.value_or(0)));
        if (butt) drawRoot(upper - faces.thickness);
    }

  private:
    void add(SectionMark mark, Place from, Place to) {
        mark.from = from;
        mark.to = to;
        marks_.push_back(std::move(mark));
    }

    /// Adds the station's length, if it has one.
    void length(Member figure, Place from, Place to) {
        const WeldStation::Value value = station_.*figure;
        if (!value || *value <= 0) return;
        if (*value >= resolution_) return add({.label = lengthLabel(figure, *value)}, from, to);
        add({SectionMark::Kind::note, SectionMark::Tint::unresolved, limitLabel(figure, resolution_)}, from, to);
    }

    void fault(Member figure, double least, Place from, Place to) { fault(figure, station_.*figure, least, from, to); }
    /// Adds a fault whose value is not the figure's alone.
    void fault(Member figure, WeldStation::Value value, double least, Place from, Place to) {
        if (value && *value > least)
            add({SectionMark::Kind::length, SectionMark::Tint::fault, lengthLabel(figure, *value)}, from, to);
    }

    /// Adds the angle between the plate's way into the weld and the weld's surface, which rises towards `side`.
    void angle(Member figure, Place toe, Place inwards, Place side) {
        const WeldStation::Value value = station_.*figure;
        if (!value) return;
        SectionMark mark{SectionMark::Kind::angle, SectionMark::Tint::measure, angleLabel(figure, *value)};
        mark.first = inwards;
        mark.second = std::cos(*value) * inwards + std::sin(*value) * side;
        add(std::move(mark), toe, toe);
    }

    /// Unit vector from the corner to the nearest place of the weld's surface.
    Place throatWay() const {
        const auto nearest = anchors_.onOutline(
            [](Place place) { return place.x > 0 && place.y > 0 ? std::optional(-glm::length(place)) : std::nullopt; });
        return nearest ? glm::normalize(*nearest) : Place(std::numbers::sqrt2 / 2);
    }

    void drawConvexity(Place base, Place upright) {
        const Place way = (upright - base) / glm::length(upright - base), out(way.y, -way.x);
        const double chord = glm::length(upright - base);
        const auto highest = anchors_.onOutline([&](Place place) -> std::optional<double> {
            const double share = glm::dot(place - base, way) / chord;
            if (share <= 0.1 || share >= 0.9 || place.x <= 0 || place.y <= 0) return std::nullopt;
            return glm::dot(place - base, out);
        });
        const Place foot = base + way * (highest ? glm::dot(*highest - base, way) : 0.5 * chord);
        length(&WeldStation::convexity, foot, foot + out * station_.convexity.value_or(0));
    }

    void drawCornerPenetration() {
        const auto depth = [](Place place) {
            const Place under = glm::max(-place, Place(0));
            return glm::length(under);
        };
        const auto deepest = anchors_.deepestFused(depth);
        if (!deepest) return;
        const Place face = glm::max(*deepest, Place(0)); // the nearest place of the faces
        const Place way = (*deepest - face) / depth(*deepest);
        length(&WeldStation::penetration, face, face + way * station_.penetration.value_or(0));
    }

    /// Draws the plate that is colder next to the corner; the station has the worse one's length.
    void drawUnfusedCorner(double leg1, double leg2) {
        const double unfused = station_.lackOfFusion.value_or(0), inside = 0.25 * spacing_;
        if (unfused <= 0) return;
        const double probe = 0.5 * unfused;
        const bool base = leg2 <= 0 || (leg1 > 0 && !anchors_.fused({probe, -inside}));
        fault(&WeldStation::lackOfFusion, unfused, resolution_, Place(0), base ? Place(unfused, 0) : Place(0, unfused));
    }

    void drawFusedWidth(double upper) {
        const double height = upper - 0.5 * spacing_; // height at which the gauge measures it
        const auto middle = anchors_.fusedMiddle(height);
        if (!middle) return;
        const double half = 0.5 * station_.fusedWidth.value_or(0);
        length(&WeldStation::fusedWidth, {*middle - half, height}, {*middle + half, height});
    }

    void drawUpAndDown(double upper, bool butt) {
        const auto crown = anchors_.onOutline([](Place place) { return std::optional(place.y); });
        const double at = crown ? crown->x : station_.middle.value_or(0);
        length(&WeldStation::height, {at, upper}, {at, upper + station_.height.value_or(0)});
        if (butt) return; // a bevel is a face too, so that the distance from the faces has more than one place
        const auto deepest = anchors_.deepestFused([upper](Place place) { return upper - place.y; });
        if (!deepest) return;
        length(&WeldStation::penetration, {deepest->x, upper}, {deepest->x, upper - station_.penetration.value_or(0)});
    }

    void drawRoot(double lower) {
        const auto lowest = anchors_.onOutline([](Place place) { return std::optional(-place.y); });
        const double at = lowest ? lowest->x : 0, half = 0.5 * station_.rootWidth.value_or(0);
        if (station_.rootWidth.value_or(0) > 0) length(&WeldStation::rootWidth, {at - half, lower}, {at + half, lower});
        length(&WeldStation::excessPenetration, {at, lower}, {at, lower - station_.excessPenetration.value_or(0)});
        const double unfused =
            std::max(station_.rootMissing.value_or(0), 0.0) + std::max(station_.lackOfFusion.value_or(0), 0.0);
        fault(&WeldStation::lackOfFusion, unfused, resolution_, {0, lower}, {0, lower + unfused});
        fault(&WeldStation::rootConcavity, resolution_, {at, lower}, {at, lower + station_.rootConcavity.value_or(0)});
        const double wide = 0.5 * station_.hole.value_or(0);
        fault(&WeldStation::hole, resolution_, {-wide, lower}, {wide, lower});
    }

    const WeldStation& station_;
    Anchors anchors_;
    double spacing_, resolution_;
    std::vector<SectionMark> marks_;
};

} // namespace

SectionFaces SectionFaces::of(const WorkpieceParameters& asked) {
    const WorkpieceParameters workpiece = simulatedWorkpiece(asked);
    SectionFaces faces;
    faces.thickness = static_cast<double>(workpiece.thicknessMm) * kMm;
    if (static_cast<WorkpieceKind>(workpiece.kind) == WorkpieceKind::Cube)
        faces.upper = 0.5 * static_cast<double>(workpiece.lengthMm) * kMm;
    return faces;
}

std::vector<SectionMark> sectionMarks(const WeldStation& station, WeldKind kind, const SectionMap& map, double fusion,
                                      const SectionFaces& faces) {
    if (map.sums.empty()) return {};
    Marks marks(station, map, fusion);
    if (kind == WeldKind::fillet)
        marks.drawFillet();
    else
        marks.drawLevel(faces, kind == WeldKind::butt);
    return marks.take();
}

} // namespace meltpool
