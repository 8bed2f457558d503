#include "app/session/bend_drawing.hpp"

#include "core/base/units.hpp"
#include "core/base/words.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace meltpool {

namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kMargin = 2;       ///< mm of margin on all sides
constexpr float kBetween = 10;     ///< mm from the side view to the face
constexpr float kFaceHeight = 16;  ///< mm of strap, across the seam, that the face shows
constexpr float kGape = 0.2f;      ///< width of a drawn opening, as a share of its length
constexpr float kLeastGape = 0.6f; ///< mm, width of the narrowest opening that is drawn
constexpr int kPieces = 24;        ///< pieces of the bend
constexpr int kLensPieces = 8;     ///< pieces of an opening's side

float mm(double metres) {
    return static_cast<float>(metres * 1e3);
}

glm::vec2 onCircle(glm::vec2 middle, float radius, float angle) {
    return middle + radius * glm::vec2(std::sin(angle), -std::cos(angle)); // angle 0 is up
}

/// Outline of an opening seen from outside: pointed at both ends.
std::vector<glm::vec2> lens(glm::vec2 from, glm::vec2 to, float gape) {
    std::vector<glm::vec2> points;
    const glm::vec2 way = to - from;
    const float length = std::max(glm::length(way), 1e-3f);
    const glm::vec2 side = glm::vec2(-way.y, way.x) / length * (0.5f * gape);
    for (int i = 0; i < 2 * kLensPieces; ++i) {
        const float turn = kPi * static_cast<float>(i) / kLensPieces;
        points.push_back(from + way * (0.5f - 0.5f * std::cos(turn)) + side * std::sin(turn));
    }
    return points;
}

class Sheet {
  public:
    Sheet(const BentStrap& strap, const BendTest& test) : strap_(strap), test_(test) {}

    BendDrawing draw() {
        const bool broken = strap_.kind == BendKind::filletBreak;
        const glm::vec2 side = broken ? drawFolded() : drawBent();
        const glm::vec2 face = drawFace({side.x + kBetween, kMargin});
        drawing_.size = {face.x + kMargin, std::max(side.y, face.y) + kMargin};
        return std::move(drawing_);
    }

  private:
    /// Adds a shape with its corners in clockwise order on the page.
    void add(BendPart part, std::vector<glm::vec2> points) {
        float area = 0;
        for (size_t i = 0; i < points.size(); ++i) {
            const glm::vec2 a = points[i], b = points[(i + 1) % points.size()];
            area += a.x * b.y - b.x * a.y;
        }
        if (area < 0) std::reverse(points.begin(), points.end());
        drawing_.shapes.push_back({part, std::move(points)});
    }
    void box(BendPart part, glm::vec2 low, glm::vec2 high) { add(part, {low, {high.x, low.y}, high, {low.x, high.y}}); }

    /// Depth of the deepest resolved opening, mm.
    float deepest() const {
        double depth = 0;
        for (const BendOpening& opening : strap_.openings)
            if (opening.resolved) depth = std::max(depth, opening.depth);
        return std::min(mm(depth), mm(test_.thickness));
    }

    /// Draws the strap around its former, the stretched face outside; returns its lower right corner.
    glm::vec2 drawBent() {
        const float inner = 0.5f * mm(test_.former), thick = mm(test_.thickness), outer = inner + thick;
        const float leg = 0.6f * outer, weld = 0.8f * thick / outer; // rad, half of the weld's breadth
        const glm::vec2 middle(kMargin + outer, kMargin + outer);
        for (int i = 0; i < kPieces; ++i) {
            const float from = kPi * (static_cast<float>(i) / kPieces - 0.5f), to = from + kPi / kPieces;
            const bool inWeld = std::abs(0.5f * (from + to)) < weld;
            add(inWeld ? BendPart::weld : BendPart::steel,
                {onCircle(middle, inner, from), onCircle(middle, outer, from), onCircle(middle, outer, to),
                 onCircle(middle, inner, to)});
        }
        for (const float side : {-1.0f, 1.0f})
            box(BendPart::steel, middle + glm::vec2(side > 0 ? inner : -outer, 0),
                middle + glm::vec2(side > 0 ? outer : -inner, leg));
        if (const float depth = deepest(); depth > 0) {
            const float half = 0.5f * std::max(kGape * depth, kLeastGape) / outer;
            add(BendPart::opening,
                {onCircle(middle, outer, -half), onCircle(middle, outer, half), onCircle(middle, outer - depth, 0)});
        }
        return middle + glm::vec2(outer, leg);
    }

    /// Draws a tee whose upright plate was pushed over onto the weld's face: the root gapes.
    glm::vec2 drawFolded() {
        constexpr float kOver = 0.9f; // rad from the upright
        const float thick = mm(test_.thickness), reach = 3.5f * thick;
        const glm::vec2 root(kMargin + 1.2f * thick, kMargin + reach);
        box(BendPart::steel, {kMargin, root.y}, {root.x + reach, root.y + thick});
        const glm::vec2 way(std::sin(kOver), -std::cos(kOver)), back(-way.y, way.x);
        const glm::vec2 foot = root + glm::vec2(0.25f * thick, 0);
        add(BendPart::steel, {foot, foot + reach * way, foot + reach * way - thick * back, foot - thick * back});
        add(BendPart::weld, {foot, foot + glm::vec2(thick, 0), foot + 0.8f * thick * way});
        if (deepest() > 0 || !strap_.openings.empty())
            add(BendPart::opening, {root - glm::vec2(0.5f * thick, 0), foot, foot - 0.7f * thick * back});
        return {root.x + reach, root.y + thick};
    }

    /// Draws the stretched face, or the broken one, from outside; returns its lower right corner.
    glm::vec2 drawFace(glm::vec2 corner) {
        const bool broken = strap_.kind == BendKind::filletBreak, side = strap_.kind == BendKind::side;
        const float length = mm(side ? test_.plate : strap_.length());
        const float height = broken ? std::max(mm(test_.thickness), 1.0f) : kFaceHeight;
        const float middle = corner.y + 0.5f * height;
        box(broken ? BendPart::weld : BendPart::steel, corner, corner + glm::vec2(length, height));
        if (!broken) {
            const float half = 0.3f * height;
            box(BendPart::weld, {corner.x, middle - half}, {corner.x + length, middle + half});
        }
        const double begin = side ? 0 : strap_.from;
        for (const BendOpening& opening : strap_.openings) {
            const float from = corner.x + mm(opening.from - begin), to = corner.x + mm(opening.to - begin);
            const BendPart part = opening.resolved ? BendPart::opening : BendPart::unresolved;
            if (broken) { // the root is the lower edge
                const float up = std::min(std::max(mm(opening.depth), 1.0f), height);
                box(part, {from, corner.y + height - up}, {to, corner.y + height});
            } else {
                add(part, lens({from, middle}, {to, middle}, std::max(kGape * (to - from), kLeastGape)));
            }
        }
        addScale(corner + glm::vec2(0, height + 1), length);
        return corner + glm::vec2(length, height + 6);
    }

    /// Adds the words under the face: where it begins and ends, mm.
    void addScale(glm::vec2 low, float length) {
        const bool side = strap_.kind == BendKind::side;
        const auto label = [&](float x, double value, const std::string& unit) {
            drawing_.labels.push_back({{x, low.y}, std::string(inShownUnit(PhraseNumber(value), "mm")) + unit});
        };
        label(low.x, side ? 0 : strap_.from * 1e3, "");
        label(low.x + length, side ? test_.plate * 1e3 : strap_.to * 1e3, " " + std::string(shownUnit("mm").name));
    }

    const BentStrap& strap_;
    const BendTest& test_;
    BendDrawing drawing_;
};

/// Key of the sentence for a strap as a whole.
std::string keyOf(const BentStrap& strap) {
    static constexpr std::array<std::string_view, 4> kKinds{"face", "root", "side", "fillet_break"};
    const bool resolved = strap.state == VerdictState::pass || strap.state == VerdictState::fail;
    const std::string_view state = nameOf(resolved ? strap.state : VerdictState::notResolved);
    return "bend_drawing." + std::string(kKinds[static_cast<size_t>(strap.kind)]) + "." + std::string(state);
}

} // namespace

BendDrawing drawBend(const BentStrap& strap, const BendTest& test) {
    return Sheet(strap, test).draw();
}

std::string bendSentence(const BentStrap& strap) {
    const auto number = [](double metres) { return PhraseNumber(metres * 1e3); };
    std::string sentences = phrase(keyOf(strap), {{"from", number(strap.from)}, {"to", number(strap.to)}});
    if (strap.longest > 0)
        sentences += " " + phrase("bend_drawing.longest",
                                  {{"longest", number(strap.longest)}, {"together", number(strap.together)}});
    const auto unresolved = std::count_if(strap.openings.begin(), strap.openings.end(),
                                          [](const BendOpening& opening) { return !opening.resolved; });
    if (unresolved > 0) sentences += " " + phrase("bend_drawing.outlined");
    if (strap.openings.empty()) sentences += " " + phrase("bend_drawing.nothing_opens");
    return sentences;
}

} // namespace meltpool
