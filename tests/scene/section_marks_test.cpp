// Measures as strokes: lines at their places, words next to them, and pixels that agree with the strokes.
#include "core/render/camera.hpp"
#include "core/render/picture_target.hpp"
#include "core/render/renderer.hpp"
#include "core/scene/section_marks.hpp"
#include "core/scene/stroke_text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>

namespace meltpool {

namespace {

constexpr int kEdge = 128;
constexpr float kAt = 0.004f;

SectionMark mark(const std::string& label, glm::vec2 from, glm::vec2 to) {
    SectionMark made;
    made.label = label;
    made.from = from;
    made.to = to;
    return made;
}

/// True for the colour of measures, false for their dark edges.
bool isBright(glm::vec4 colour) {
    return colour.g > 0.8f && colour.a == 1;
}

/// Returns a view along -x at the plane, 20 mm high.
View square() {
    return FreeCamera({kAt + 0.02f, 0, 0}, {kAt, 0, 0}).view({.fieldOfView = 0.9273f, .nearest = 0.002f}, 1);
}

Image pictureOf(const std::vector<SectionStroke>& strokes) {
    SceneView scene;
    scene.section.shown = true;
    scene.section.at = kAt;
    scene.section.strokes = strokes;
    LookParameters look;
    look.showBox = false;
    look.showSky = false;
    look.exposure = 1;
    static Renderer renderer(test::shaders());
    const PictureTarget target(kEdge, kEdge, 1);
    const View view = square();
    renderer.draw(scene, look, {&view, 1}, target.target(), nullptr);
    return target.read();
}

std::array<int, 3> colourAt(const Image& picture, glm::vec2 place) {
    const View view = square();
    const glm::vec4 clip = view.eyeToClip * view.worldToEye * glm::vec4(kAt, place.y, place.x, 1.0f);
    const glm::vec2 unit = glm::vec2(clip) / clip.w * 0.5f + 0.5f;
    const auto x = static_cast<size_t>(unit.x * kEdge), y = static_cast<size_t>((1 - unit.y) * kEdge);
    const size_t first = 3 * (y * kEdge + x);
    return {picture.rgb[first], picture.rgb[first + 1], picture.rgb[first + 2]};
}

} // namespace

TEST_CASE("text of strokes is as long as it says, scales with its height, and leaves out what it does not know") {
    std::vector<SectionStroke> strokes;
    StrokeTextStyle style;
    style.height = 2;
    appendStrokeText(strokes, "throat 4.2", {10, 5}, style);
    REQUIRE_FALSE(strokes.empty());
    glm::vec2 low(1e9f), high(-1e9f);
    for (const SectionStroke& stroke : strokes)
        for (const glm::vec2 end : {stroke.from, stroke.to}) {
            low = glm::min(low, end);
            high = glm::max(high, end);
        }
    CHECK(low.x == Approx(10).margin(0.35));
    CHECK(high.x - 10 == Approx(strokeTextLength("throat 4.2", 2)).margin(1e-4));
    CHECK(low.y == Approx(5));
    CHECK(high.y == Approx(7));
    CHECK(strokeTextLength("legs", 4) == Approx(2 * strokeTextLength("legs", 2)));
    strokes.clear();
    appendStrokeText(strokes, "\t@ ", {0, 0}, style);
    CHECK(strokes.empty());
    appendStrokeText(strokes, "A", {0, 0}, style);
    std::vector<SectionStroke> small;
    appendStrokeText(small, "a", {0, 0}, style);
    CHECK(strokes.size() == small.size());
    strokes.clear();
    appendStrokeText(strokes, "\xC2\xB0", {0, 0}, style); // the degree sign
    CHECK(strokes.size() == 4);
}

TEST_CASE("letters of German and the decimal comma have strokes") {
    const auto strokesOf = [](std::string_view text) {
        std::vector<SectionStroke> strokes;
        appendStrokeText(strokes, text, {0, 0}, {});
        return strokes.size();
    };
    CHECK(strokesOf(",") == 1);
    CHECK(strokesOf("\xC3\xA4") == strokesOf("a") + 2); // two dots above
    CHECK(strokesOf("\xC3\xB6") == strokesOf("o") + 2);
    CHECK(strokesOf("\xC3\xBC") == strokesOf("u") + 2);
    CHECK(strokesOf("\xC3\x84\xC3\x96\xC3\x9C") == strokesOf("\xC3\xA4\xC3\xB6\xC3\xBC"));
    CHECK(strokesOf("\xC3\x9F") > 0);
    CHECK(strokeTextLength("\xC3\xA4", 2) == Approx(strokeTextLength("a", 2)));
    CHECK(strokeTextLength("4,2", 2) == Approx(strokeTextLength("4.2", 2)));
}

TEST_CASE("a measure's line ends where it is asked to, and words lie beside all measures") {
    const std::vector<SectionMark> marks{mark("leg 6.0", {0, 0}, {0.006f, 0}), mark("leg 5.0", {0, 0}, {0, 0.005f}),
                                         mark("throat 4.0", {0, 0}, {0.003f, 0.003f})};
    std::vector<SectionStroke> strokes;
    const MarkLayout layout{{-1, 0}, {0, 1}, 1e-3f};
    layOutMarks(marks, layout, strokes);
    for (const SectionMark& each : marks) {
        INFO(each.label);
        CHECK(std::any_of(strokes.begin(), strokes.end(), [&](const SectionStroke& s) {
            return isBright(s.colour) && glm::distance(s.from, each.from) < 1e-7f &&
                   glm::distance(s.to, each.to) < 1e-7f;
        }));
    }
    // The words' backgrounds cover no measure.
    for (const SectionStroke& stroke : strokes) {
        if (stroke.width < 1.5f * layout.text) continue;
        const float low = std::min(stroke.from.x, stroke.to.x), high = std::max(stroke.from.x, stroke.to.x);
        CHECK((high < 0 || low > 0.006f));
        for (const SectionStroke& other : strokes) {
            if (&other == &stroke || other.width < 1.5f * layout.text) continue;
            const bool column = (other.from.x < 0) == (stroke.from.x < 0);
            CHECK((!column || std::abs(other.from.y - stroke.from.y) > 1.2f * stroke.width)); // with room between them
        }
    }
    layOutMarks({}, layout, strokes);
}

TEST_CASE("strokes are drawn in the plane of the section, in their place and colour") {
    test::context();
    const glm::vec4 yellow(1, 0.8f, 0, 1), red(1, 0, 0, 1);
    const Image picture = pictureOf({{{-0.006f, 0.004f}, {0.006f, 0.004f}, yellow, 0.001f, 0, {}},
                                     {{0.005f, -0.006f}, {0.005f, -0.006f}, red, 0.002f, 0, {}}});
    for (const float z : {-0.0055f, 0.0f, 0.0055f}) {
        CHECK(colourAt(picture, {z, 0.004f})[0] > 230);
        CHECK(colourAt(picture, {z, 0.004f})[2] < 60);
        CHECK(colourAt(picture, {z, 0.0052f})[0] < 80);
    }
    CHECK(colourAt(picture, {0.0075f, 0.004f})[0] < 80);
    CHECK(colourAt(picture, {0.005f, -0.006f})[0] > 230); // a stroke without length is a dot
    CHECK(colourAt(picture, {0.005f, -0.006f})[1] < 60);
    CHECK(colourAt(picture, {0.005f, -0.0045f})[0] < 80);
    CHECK(colourAt(pictureOf({}), {0, 0.004f})[0] < 80);
}

} // namespace meltpool
