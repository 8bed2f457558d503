// The drawings of an attempt's page: curves, strip of the seam and section, with their coordinates.
#include "app/report/curve_drawing.hpp"
#include "app/report/seam_strip.hpp"
#include "app/report/section_drawing.hpp"
#include "tests/app/markup.hpp"
#include "tests/support/catch.hpp"

#include <cmath>

using namespace meltpool;
using meltpool::test::containsText;
using meltpool::test::firstUnclosed;

namespace {

size_t countOf(const std::string& text, const std::string& part) {
    size_t count = 0;
    for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

Curve speeds() {
    return {"speed <x>", "mm/s", {0, 1, 2, 3, 4}, {5, 6, std::nan(""), 5, 900}, CurveBand{5.5, 0.5, 2}};
}

} // namespace

TEST_CASE("ticks are round numbers within the range", "[app]") {
    const CurveTicks ticks = curveTicks({0, 10}, 5);
    CHECK(ticks.first == 0);
    CHECK(ticks.step == 2);
    CHECK(ticks.count == 6);
    const CurveTicks odd = curveTicks({-0.3, 1.7}, 4);
    REQUIRE(odd.count == 4);
    CHECK(odd.at(0) == Approx(0));
    CHECK(odd.at(1) == Approx(0.5));
    CHECK(curveTicks({1, 1}, 4).count == 0);
    CHECK(curveTicks({}, 4).count == 0);
}

TEST_CASE("a sheet shows the whole band, and of what wanders far off three outer widths", "[app]") {
    const CurveBand band{10, 1, 4};
    CurveRange values;
    CHECK(shownRange(values, band).empty());
    values.take(9);
    values.take(std::nan(""));
    values.take(11);
    CHECK(shownRange(values, {}).from == 9);
    CHECK(shownRange(values, band).from == Approx(5.6));
    CHECK(shownRange(values, band).to == Approx(14.4));
    values.take(-100);
    CHECK(shownRange(values, band).from == Approx(-2));
}

TEST_CASE("a curve's points lie where its values are, broken where nothing is known", "[app]") {
    const Curve curve = speeds();
    const std::string svg = curveDrawing(curve);
    CHECK(firstUnclosed(svg) == "");
    CHECK_THAT(svg, containsText("speed &lt;x&gt;") && containsText("class=\"ideal\""));
    // 320 x 92 units: places 0 to 4 from 36 to 314, values 3.3 (5.5 less 1.1 outer) to 11.5 (and 3 outer) from 74
    // to 17.
    const double up = 57 / 8.2;
    const CurveSheet sheet = sheetOf(curve);
    CHECK(sheet.x(1) == Approx(105.5));
    CHECK(sheet.y(6) == Approx(74 - 2.7 * up));
    CHECK_THAT(svg, containsText("<polyline class=\"curve\" points=\"36.0,62.2 105.5,55.2\"/>"));
    CHECK_THAT(svg, containsText("<polyline class=\"curve\" points=\"244.5,62.2 314.0,17.0\"/>"));
    CHECK(countOf(svg, "<polyline") == 2);
    // The band reaches from 5 to 6.
    CHECK_THAT(svg, containsText("<rect class=\"inner\" x=\"36.0\" y=\"55.2\" width=\"278.0\" height=\"7.0\"/>"));
}

TEST_CASE("a curve tells its values in mm and in inches", "[app]") {
    const std::string svg = curveDrawing(speeds());
    CHECK_THAT(svg, containsText("class=\"title mm\"") && containsText("(mm/s) over mm of seam"));
    CHECK_THAT(svg, containsText("class=\"title in\"") && containsText("(in/min) over inches of seam"));
    // 10 in/min = 254 / 60 mm/s
    const double y = sheetOf(speeds()).y(25.4 * 10 / 60);
    CHECK_THAT(svg, containsText("<text class=\"in\" x=\"32.0\" y=\"" + SvgText::coordinate(y + 3) +
                                 "\" text-anchor=\"end\">10</text>"));
}

TEST_CASE("a place without arc is not bridged, a single point is seen, and nothing is nothing", "[app]") {
    Curve curve{"aim", "mm", {0, 1, 5, 6, 9}, {1, 1, 2, 2, 1}, {}};
    CHECK(countOf(curveDrawing(curve), "<polyline") == 3); // 0 to 1, 5 to 6, and the single point 9
    curve.values.assign(5, std::nan(""));
    CHECK(curveDrawing(curve).empty());
    curve.values.clear();
    CHECK(curveDrawing(curve).empty());
}

TEST_CASE("imperfections stand at their places on the strip, with letters and hatching", "[app]") {
    CHECK(markLetter(0) == "A");
    CHECK(markLetter(25) == "Z");
    CHECK(markLetter(26) == "AA");
    CHECK(stripX(15, 0, 60) == Approx(170));
    CHECK(stripX(-5, 0, 60) == Approx(20)); // a place before the seam is drawn at its end
    CHECK(seamStrip(3, 3, {}).empty());
    const std::string svg = seamStrip(0, 60, {{"A", true, 15, {{10, 20}}}, {"B", false, 15.5, {}}});
    CHECK(firstUnclosed(svg) == "");
    CHECK_THAT(svg, containsText("<rect class=\"fault\" x=\"120.0\" y=\"34.0\" width=\"100.0\" height=\"12.0\"/>"));
    CHECK(countOf(svg, "class=\"hatch\"") == 20);
    CHECK_THAT(svg, containsText("class=\"mark-fail\" x1=\"170.0\"") && containsText("class=\"mark-other\""));
    CHECK_THAT(svg, containsText("y=\"29.0\" text-anchor=\"middle\">A</text>"));
    CHECK_THAT(svg, containsText("y=\"19.0\" text-anchor=\"middle\">B</text>")); // too close for one row
    CHECK_THAT(svg, containsText(">20 mm</text>") && containsText(">0.5 in</text>"));
}

TEST_CASE("a section is drawn to scale from what is measured", "[app]") {
    SectionSizes bead;
    CHECK(sectionDrawing(bead).empty());
    bead.toeWidth = 10;
    bead.height = 2;
    bead.thickness = 6;
    bead.fusedWidth = 8;
    bead.penetration = 1;
    CHECK(sectionScale(bead) == Approx(10)); // 160 units for 16 mm
    const std::string svg = sectionDrawing(bead);
    CHECK(firstUnclosed(svg) == "");
    // The middle of the face is at 8 + 8 mm, 8 + 2 mm.
    CHECK_THAT(svg, containsText("class=\"weld\" d=\"M38.0,28.0 Q88.0,-12.0 138.0,28.0 Z\""));
    CHECK_THAT(svg, containsText("class=\"fused\" d=\"M48.0,28.0 A40.0 10.0 0 0 0 128.0,28.0 Z\""));
    CHECK_THAT(svg, containsText("width 10.0 mm") && containsText("width 0.394 in") && containsText("plate 6.0 mm"));
    SectionSizes fillet;
    fillet.legBase = 6;
    fillet.legUpright = 6;
    fillet.throat = 6 / std::sqrt(2.0);
    CHECK_THAT(sectionDrawing(fillet), containsText("throat 4.2 mm") && containsText("leg, upright plate 6.0 mm"));
    CHECK(sectionDrawing(fillet).find("class=\"fused\" d") == std::string::npos); // fusion is unknown
}
