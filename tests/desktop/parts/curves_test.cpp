// Tests the curves of the result panel, drawn by the installed Dear ImGui without a window.
#include "app/ui/curves.hpp"
#include "app/ui/panels.hpp"
#include "tests/desktop/parts/drawn_interface.hpp"
#include "tests/support/catch.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace meltpool {

namespace {

class CurveInterface : public test::DrawnInterface {
  public:
    /// Draws one frame with the curves in a window, folded or open; returns the number of corners of its triangles.
    int frame(const Judgement& judgement, const TechniqueBands* bands, bool open = true) {
        return draw([&](ui::Context& context) {
            ImGui::GetStateStorage()->SetBool(ImGui::GetID("Along the seam"), open);
            ui::curvesPart(context, judgement, bands);
        });
    }
};

/// Makes a judgement of 40 mm of seam at 5 mm/s, without arc from 20 to 25 mm.
Judgement judged() {
    Judgement judgement;
    for (int i = 0; i < 40; ++i) {
        if (i >= 20 && i < 25) continue;
        SeamMillimetre mm;
        mm.place = (i + 0.5) * 1e-3;
        mm.values[TechniqueQuantity::travelSpeed] = 5e-3 + 1e-4 * i;
        mm.current = 200;
        mm.voltage = 25;
        judgement.seam.push_back(mm);
    }
    judgement.arc.charge = 1600;
    return judgement;
}

TechniqueBands asked() {
    TechniqueBands bands;
    bands.bands = {{TechniqueQuantity::travelSpeed, 6, 0.5, 2, 1}, {TechniqueQuantity::aim, 0, 1, 3, 1}};
    return bands;
}

} // namespace

TEST_CASE("the result's curves show what is known along the seam, with the arc's") {
    CurveInterface interface;
    const Judgement judgement = judged();
    const TechniqueBands bands = asked();
    const int folded = interface.frame(judgement, &bands, false);
    CHECK_FALSE(interface.shows("result.curve.speed_mm_s"));
    interface.frame(judgement, &bands);
    const int open = interface.frame(judgement, &bands);
    CHECK(open > folded + 200);
    CHECK(interface.shows("result.curve.speed_mm_s"));
    CHECK(interface.shows("result.curve.current_a"));
    CHECK(interface.shows("result.curve.voltage_v"));
    CHECK_FALSE(interface.shows("result.curve.aim_mm")); // unknown everywhere
    const int pale = interface.frame(judgement, nullptr);
    CHECK(pale < open); // curves without the band
    CHECK(interface.shows("result.curve.speed_mm_s"));
    CHECK(interface.frame({}, &bands) < folded); // no arc burned: there is no heading either
}

TEST_CASE("two curves share a chart, and one that is given its places is there before any value") {
    CurveInterface interface;
    const auto place = [](size_t i) { return static_cast<double>(i); };
    const auto rising = [](size_t i) { return static_cast<double>(i); };
    const auto falling = [](size_t i) { return 20 - static_cast<double>(i); };
    const auto unknown = [](size_t) { return std::numeric_limits<double>::quiet_NaN(); };
    const ui::CurveSeries one{10, place, rising, 1.5}, two{12, place, falling, 1.5, ui::kFirstTint},
        none{10, place, unknown, 1.5};
    const std::array<ui::CurveSeries, 1> alone{one}, empty{none};
    const std::array<ui::CurveSeries, 2> both{one, two};
    ui::CurveAnswer answer;
    const auto draw = [&](const ui::CurveChart& chart, std::span<const ui::CurveSeries> series) {
        return interface.draw([&](ui::Context& context) { answer = ui::curveChart(context, chart, series); });
    };
    ui::CurveChart chart{"a.chart", "speed", "mm/s", "s", {}};
    const int single = draw(chart, alone);
    CHECK(answer.drawn);
    chart.cursor = 4;
    CHECK(draw(chart, alone) > single); // the value at the cursor, in words
    chart.cursor = 30;
    CHECK(draw(chart, alone) == single); // no value there
    chart.cursor.reset();
    chart.placeUnit = "";
    CHECK(draw(chart, alone) < single); // the unit of the places
    chart.placeUnit = "s";
    CHECK(draw(chart, both) > single);
    CHECK((answer.sheet.places.from == 0 && answer.sheet.places.to == 11));
    CHECK((answer.sheet.values.from == 0 && answer.sheet.values.to == 20));
    draw(chart, empty);
    CHECK_FALSE(answer.drawn);
    chart.places = {0, 40};
    draw(chart, empty);
    CHECK(answer.drawn);
    chart.band = CurveBand{5, 1, 2};
    draw(chart, empty);
    CHECK((answer.sheet.values.from < 3 && answer.sheet.values.to > 7));
    CHECK(answer.sheet.places.to == 40);
    ImGui::GetIO().MousePos = {static_cast<float>(answer.sheet.left + answer.sheet.right) / 2,
                               static_cast<float>(answer.sheet.top + answer.sheet.bottom) / 2};
    draw(chart, alone);
    draw(chart, alone);
    CHECK(answer.hovered);
    CHECK(answer.under == Approx(20).margin(0.1));
}

TEST_CASE("the value under the pointer is shown, and a frame asks for no memory") {
    CurveInterface interface;
    const Judgement judgement = judged();
    const TechniqueBands bands = asked();
    for (int i = 0; i < 3; ++i)
        interface.frame(judgement, &bands);
    const int without = interface.frame(judgement, &bands);
    const ui::Place& place = interface.place("result.curve.speed_mm_s");
    const size_t before = interface.requests();
    interface.frame(judgement, &bands);
    CHECK(interface.requests() == before);
    ImGui::GetIO().MousePos = {place.x + place.width / 2, place.y + place.height / 2};
    interface.frame(judgement, &bands);
    CHECK(interface.frame(judgement, &bands) > without);
}

} // namespace meltpool
