// The drawing of a bent strap: openings to scale at their places, and a sentence with equal content.
#include "app/session/bend_drawing.hpp"

#include "tests/support/catch.hpp"

#include <algorithm>

using namespace meltpool;

namespace {

constexpr double kMm = 1e-3;

WeldMeasures butt(WeldKind kind) {
    std::vector<WeldStation> list(20);
    for (size_t i = 0; i < list.size(); ++i) {
        list[i].place = (1 + 2 * double(i)) * kMm;
        list[i].rootMissing = -2 * kMm;
        list[i].throat = 4 * kMm;
        list[i].lackOfFusion = (i == 4 || i == 5 ? 2.0 : i == 10 ? 0.2 : -1.5) * kMm;
    }
    return summarise(std::move(list), kind, 2 * kMm, 1 * kMm);
}

/// Returns the left and the right end (mm) of the last shape of one kind.
glm::vec2 reachOf(const BendDrawing& drawing, BendPart part) {
    glm::vec2 reach(0);
    for (const BendShape& shape : drawing.shapes) {
        if (shape.part != part) continue;
        reach = {1e9f, -1e9f};
        for (const glm::vec2 point : shape.points)
            reach = {std::min(reach.x, point.x), std::max(reach.y, point.x)};
    }
    return reach;
}

} // namespace

TEST_CASE("an opening is drawn as long as it is, where it lies on the strap's face", "[bend]") {
    const auto test = bendTest(butt(WeldKind::butt), 6 * kMm);
    REQUIRE(test);
    const BendDrawing drawing = drawBend(test->straps.at(0), *test);
    const glm::vec2 face = reachOf(drawing, BendPart::weld), opening = reachOf(drawing, BendPart::opening);
    CHECK(face.y - face.x == Approx(40));
    CHECK(opening.x - face.x == Approx(8));
    CHECK(opening.y - opening.x == Approx(4));
    const glm::vec2 unresolved = reachOf(drawing, BendPart::unresolved);
    CHECK(unresolved.x - face.x == Approx(20));
    CHECK(unresolved.y - unresolved.x == Approx(2));
    for (const BendShape& shape : drawing.shapes)
        for (const glm::vec2 point : shape.points) {
            CHECK(point.x >= 0);
            CHECK(point.y >= 0);
            CHECK(point.x <= drawing.size.x);
            CHECK(point.y <= drawing.size.y);
        }
    CHECK_THAT(bendSentence(test->straps[0]),
               test::containsText("Root bend, 0 to 40 mm: fails. Longest opening 4 mm") &&
                   test::containsText("too fine to see"));
    CHECK_THAT(bendSentence(test->straps[1]),
               test::containsText("Face bend, 0 to 40 mm: passes.") && test::containsText("Nothing opens."));
}

TEST_CASE("polygons are convex and clockwise, as the interface fills them", "[bend]") {
    for (const WeldKind kind : {WeldKind::butt, WeldKind::fillet})
        for (const double plate : {3.0, 6.0, 16.0}) {
            const auto test = bendTest(butt(kind), plate * kMm);
            REQUIRE(test);
            for (const BentStrap& strap : test->straps)
                for (const BendShape& shape : drawBend(strap, *test).shapes) {
                    const size_t count = shape.points.size();
                    REQUIRE(count >= 3);
                    for (size_t i = 0; i < count; ++i) {
                        const glm::vec2 a = shape.points[i], b = shape.points[(i + 1) % count],
                                        c = shape.points[(i + 2) % count];
                        CHECK((b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x) > -1e-3f);
                    }
                }
        }
}

TEST_CASE("a broken fillet shows what was not fused at the root's edge of the broken face", "[bend]") {
    const auto test = bendTest(butt(WeldKind::fillet), 6 * kMm);
    REQUIRE(test);
    const BendDrawing drawing = drawBend(test->straps.at(0), *test);
    const auto isOpening = [](const BendShape& shape) { return shape.part == BendPart::opening; };
    CHECK(std::count_if(drawing.shapes.begin(), drawing.shapes.end(), isOpening) == 2); // one at the root, one on face
    const glm::vec2 opening = reachOf(drawing, BendPart::opening);
    CHECK(opening.y - opening.x == Approx(4));
    CHECK_THAT(bendSentence(test->straps[0]), test::containsText("Fillet break, 0 to 40 mm: fails."));
}
