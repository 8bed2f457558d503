// Bend test and fillet break: openings from stations, the lengths of AWS D1.1, and unresolved places.
#include "core/training/judging/bend_test.hpp"

#include "tests/support/catch.hpp"

#include <functional>

using namespace meltpool;

namespace {

constexpr double kMm = 1e-3;

/// Returns a butt of stations 2 mm apart, particles of 1 mm: `worse` gives the unfused height of the worse edge at a
/// station, mm.
WeldMeasures butt(size_t stations, const std::function<double(size_t)>& worse) {
    std::vector<WeldStation> list(stations);
    for (size_t i = 0; i < stations; ++i) {
        list[i].place = (1 + 2 * double(i)) * kMm;
        list[i].rootMissing = -2 * kMm; // the other edge is fused and metal hangs under it
        list[i].lackOfFusion = worse(i) * kMm;
        list[i].hole = 0;
    }
    return summarise(std::move(list), WeldKind::butt, 2 * kMm, 1 * kMm);
}

WeldMeasures fillet(size_t stations, const std::function<double(size_t)>& lack) {
    std::vector<WeldStation> list(stations);
    for (size_t i = 0; i < stations; ++i) {
        list[i].place = (1 + 2 * double(i)) * kMm;
        list[i].throat = 4 * kMm;
        list[i].lackOfFusion = lack(i) * kMm;
    }
    return summarise(std::move(list), WeldKind::fillet, 2 * kMm, 1 * kMm);
}

const BentStrap& strapOf(const BendTest& test, BendKind kind) {
    for (const BentStrap& strap : test.straps)
        if (strap.kind == kind) return strap;
    FAIL("there is no such strap");
    return test.straps.front();
}

} // namespace

TEST_CASE("a fused butt bends over root and face without an opening", "[bend]") {
    const auto test = bendTest(butt(20, [](size_t) { return -1.5; }), 6 * kMm);
    REQUIRE(test);
    REQUIRE(test->straps.size() == 2); // 40 mm of seam are one strap of at least 38 mm, bent both ways
    CHECK(test->thickness == Approx(6 * kMm));
    CHECK(test->former == Approx(24 * kMm));
    CHECK(test->state == VerdictState::pass);
    for (const BentStrap& strap : test->straps) {
        CHECK(strap.openings.empty());
        CHECK(strap.state == VerdictState::pass);
        CHECK(strap.from == Approx(0).margin(1e-12));
        CHECK(strap.to == Approx(40 * kMm));
    }
}

TEST_CASE("an unfused root opens the root bend as long as it is, and nothing of the face bend", "[bend]") {
    // The opening covers stations 4 and 5 of 20: 4 mm long, 2 mm high.
    const auto test = bendTest(butt(20, [](size_t i) { return i == 4 || i == 5 ? 2.0 : -1.5; }), 6 * kMm);
    REQUIRE(test);
    const BentStrap& root = strapOf(*test, BendKind::root);
    REQUIRE(root.openings.size() == 1);
    CHECK(root.openings[0].from == Approx(8 * kMm));
    CHECK(root.openings[0].length() == Approx(4 * kMm));
    CHECK(root.openings[0].depth == Approx(2 * kMm));
    CHECK_FALSE(root.openings[0].atCorner);
    CHECK(root.longest == Approx(4 * kMm));
    CHECK(root.state == VerdictState::fail); // longer than 3 mm
    CHECK(strapOf(*test, BendKind::face).state == VerdictState::pass);
    CHECK(test->state == VerdictState::fail);
}

TEST_CASE("openings of up to 3 mm are allowed until they are 10 mm together", "[bend]") {
    const auto everyThird = [](size_t many) {
        return bendTest(butt(19, [many](size_t i) { return i % 3 == 1 && i / 3 < many ? 2.0 : -1.5; }), 6 * kMm);
    };
    const auto five = everyThird(5), six = everyThird(6);
    REQUIRE(five);
    REQUIRE(six);
    CHECK(strapOf(*five, BendKind::root).openings.size() == 5);
    CHECK(strapOf(*five, BendKind::root).together == Approx(10 * kMm));
    CHECK(five->state == VerdictState::pass);
    CHECK(strapOf(*six, BendKind::root).together == Approx(12 * kMm));
    CHECK(six->state == VerdictState::fail);

    BendRule counted;
    counted.counted = 2e-3; // with this rule none of them counts
    CHECK(bendTest(butt(19, [](size_t i) { return i % 3 == 1 ? 2.0 : -1.5; }), 6 * kMm, counted)->state ==
          VerdictState::pass);
}

TEST_CASE("a crack at the strap's corner has its own limit", "[bend]") {
    const WeldMeasures weld = butt(20, [](size_t i) { return i == 0 ? 2.0 : -1.5; });
    const auto test = bendTest(weld, 6 * kMm);
    CHECK(strapOf(*test, BendKind::root).openings.at(0).atCorner);
    CHECK(test->state == VerdictState::pass); // 2 mm
    BendRule strict;
    strict.corner = 1.5e-3;
    CHECK(bendTest(weld, 6 * kMm, strict)->state == VerdictState::fail);
}

TEST_CASE("an edge that is unfused up to the upper face, and a hole, open the face bend too", "[bend]") {
    const auto unfused = bendTest(butt(20, [](size_t i) { return i > 5 && i < 9 ? 6.0 : -1.5; }), 6 * kMm);
    CHECK(strapOf(*unfused, BendKind::face).openings.at(0).length() == Approx(6 * kMm));
    WeldMeasures burned = butt(20, [](size_t) { return -1.5; });
    burned.stations[7].hole = 3 * kMm;
    burned.stations[8].hole = 3 * kMm;
    const auto holed = bendTest(burned, 6 * kMm);
    for (const BentStrap& strap : holed->straps) {
        REQUIRE(strap.openings.size() == 1);
        CHECK(strap.openings[0].length() == Approx(4 * kMm));
        CHECK(strap.state == VerdictState::fail);
    }
}

TEST_CASE("what the particles do not resolve neither passes nor fails a strap", "[bend]") {
    // 0.3 mm are unfused with particles of 1 mm, so the opening is unresolved. 4 mm of it decide, 2 mm do not.
    const auto few = bendTest(butt(20, [](size_t i) { return i == 4 ? 0.3 : -1.5; }), 6 * kMm);
    CHECK_FALSE(strapOf(*few, BendKind::root).openings.at(0).resolved);
    CHECK(few->state == VerdictState::pass);
    const auto more = bendTest(butt(20, [](size_t i) { return i == 4 || i == 5 ? 0.3 : -1.5; }), 6 * kMm);
    CHECK(more->state == VerdictState::notResolved);
    CHECK(strapOf(*more, BendKind::root).longest == 0);
    // Next to an opening of 2 mm, 2 mm more would make it too long.
    const auto beside = bendTest(butt(20, [](size_t i) { return i == 4 ? 2.0 : i == 5 ? 0.3 : -1.5; }), 6 * kMm);
    CHECK(beside->state == VerdictState::notResolved);
    CHECK(strapOf(*beside, BendKind::root).openings.size() == 2);
}

TEST_CASE("long seams give several straps, each at least 38 mm wide", "[bend]") {
    const auto test = bendTest(butt(45, [](size_t i) { return i > 40 ? 2.0 : -1.5; }), 6 * kMm); // seam of 90 mm
    REQUIRE(test->straps.size() == 4);
    CHECK(test->straps[0].state == VerdictState::pass);
    CHECK(test->straps[1].state == VerdictState::fail);
    CHECK(test->straps[0].length() + test->straps[1].length() == Approx(90 * kMm));
    CHECK(std::min(test->straps[0].length(), test->straps[1].length()) > 38 * kMm);
}

TEST_CASE("plates over 10 mm are bent sideways, where the unfused height is what opens", "[bend]") {
    const auto test = bendTest(butt(20, [](size_t i) { return i == 7 ? 4.0 : -1.5; }), 12 * kMm);
    REQUIRE(test->straps.size() == 4); // seam of 40 mm, each strap 10 mm
    CHECK(test->thickness == Approx(10 * kMm));
    CHECK(test->former == Approx(40 * kMm));
    CHECK(test->straps[1].kind == BendKind::side);
    REQUIRE(test->straps[1].openings.size() == 1);
    CHECK(test->straps[1].openings[0].length() == Approx(4 * kMm));
    CHECK(test->straps[1].state == VerdictState::fail);
    CHECK(test->straps[0].state == VerdictState::pass);
}

TEST_CASE("a fillet is broken: it passes fused to the root all along", "[bend]") {
    const auto whole = bendTest(fillet(10, [](size_t) { return -1.0; }), 6 * kMm);
    REQUIRE(whole->straps.size() == 1);
    CHECK(whole->straps[0].kind == BendKind::filletBreak);
    CHECK(whole->former == 0);
    CHECK(whole->state == VerdictState::pass);
    const auto lacking = bendTest(fillet(10, [](size_t i) { return i == 3 ? 1.5 : -1.0; }), 6 * kMm);
    CHECK(lacking->state == VerdictState::fail);
    CHECK(lacking->straps[0].openings.at(0).length() == Approx(2 * kMm));
    CHECK(bendTest(fillet(10, [](size_t i) { return i == 3 ? 0.2 : -1.0; }), 6 * kMm)->state ==
          VerdictState::notResolved);
    WeldMeasures interrupted = fillet(10, [](size_t) { return -1.0; });
    interrupted.stations[4].throat = 0;
    CHECK(bendTest(interrupted, 6 * kMm)->state == VerdictState::fail);
}

TEST_CASE("a bead on a plate, no weld and no plate have no bend test", "[bend]") {
    WeldMeasures bead = butt(10, [](size_t) { return -1.0; });
    bead.kind = WeldKind::bead;
    CHECK_FALSE(bendTest(bead, 6 * kMm));
    CHECK_FALSE(bendTest(butt(0, [](size_t) { return 0.0; }), 6 * kMm));
    CHECK_FALSE(bendTest(butt(10, [](size_t) { return -1.0; }), 0));
}
