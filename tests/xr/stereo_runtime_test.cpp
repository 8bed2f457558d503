// Tests the real renderer in both eyes of a real runtime: metal on the table, torch in the hand, each eye against the
// one-view picture.
#include "app/headset/workshop_scene.hpp"
#include "core/metal/classic/classic_metal.hpp"
#include "core/render/picture_target.hpp"
#include "core/render/renderer.hpp"
#include "core/surface/surface.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/places.hpp"
#include "tests/xr/monado_run.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include <array>

using namespace meltpool;
using namespace meltpool::test;

namespace {

/// Draws a half-melted cube and the workshop around it.
struct DrawnLesson {
    gl::ShaderLibrary shaders{test::sourceFolder() / "shaders"};
    HeadsetParameters parameters;
    WorkpiecePlace place{parameters.tableHeight, parameters.zoom, -0.04f};
    Renderer renderer{shaders};
    ClassicMetal metal{shaders, ClassicSetup{}};
    Surface surface{shaders, {}, glm::vec3(-1), glm::vec3(1)};
    WorkshopScene workshop;
    LookParameters look;

    DrawnLesson() {
        for (int i = 0; i < 40; ++i)
            metal.step({glm::vec3(0.5f, 0.0f, 0.5f), 1.0f, false}, nullptr);
        surface.update(metal.particles(), nullptr);
        look.showBox = false;
    }

    SceneView scene() {
        SceneView scene;
        scene.mesh = surface.mesh();
        scene.modelToWorld = place.modelToWorkshop(0.04f);
        HandsView hands;
        hands.torch = true;
        hands.tip = {glm::angleAxis(-0.7f, glm::vec3(1, 0, 0)), place.toWorkshop({0.03f, 0.03f, 0.03f})};
        hands.holder.hold = hands.tip * xr::Pose{{1, 0, 0, 0}, {0, 0.03f, 0.15f}};
        hands.heat = 1.0f;
        scene.solids = workshop.build(parameters, hands);
        return scene;
    }

    static View view(const xr::EyeView& eye, const xr::BothEyes& eyes) {
        return {eye.pose.inverse().matrix(), xr::projection(eye.fov, eyes.nearZ, eyes.farZ), eye.pose.position};
    }
};

Image column(const Image& both, int eye) {
    Image cut{both.width / 2, both.height, {}};
    for (int y = 0; y < both.height; ++y) {
        const auto row = both.rgb.begin() + (std::ptrdiff_t(y) * both.width + std::ptrdiff_t(eye) * cut.width) * 3;
        cut.rgb.insert(cut.rgb.end(), row, row + cut.width * 3);
    }
    return cut;
}

} // namespace

TEST_CASE("each eye shows what one view from its place shows, whichever way the eyes are submitted", "[runtime]") {
    hiddenWindow();
    RemoteDriver driver(driverPort());
    RemoteState state;
    state.head.position = {0.0f, 1.55f, 0.42f};
    state.head.orientation = glm::angleAxis(-0.85f, glm::vec3(1, 0, 0));
    driver.send(state);
    DrawnLesson lesson;
    xr::Headset headset(std::make_unique<xr::Instance>(), {.resolutionScale = 0.6f, .samples = 4});
    REQUIRE(reach(headset, xr::SessionMode::focused));

    xr::BothEyes last;
    const auto draw = [&](const xr::BothEyes& eyes) {
        last = eyes;
        const std::array<View, 2> views{DrawnLesson::view(eyes.views[0], eyes), DrawnLesson::view(eyes.views[1], eyes)};
        lesson.renderer.draw(lesson.scene(), lesson.look, views,
                             {eyes.framebuffer, {0, 0, 2 * eyes.width, eyes.height}, eyes.encodesSrgb}, nullptr);
    };
    for (const ViewSubmission submission : kViewSubmissions) {
        const std::string name(submissionName(submission));
        // The renderer shows the next plainer way if this machine's driver lacks the wanted one.
        const SubmissionChoice chosen = lesson.renderer.submitBy(submission);
        REQUIRE(stepFrames(headset, 4, draw));
        const Image both = gl::readPixels(headset.eyes().resolved(), 2 * last.width, last.height);
        // A few more frames pass, so that the compositor has shown this very picture.
        REQUIRE(stepFrames(headset, 4, draw));
        keepPicture(screenshot(), "workshop_composited_" + name + ".png");
        keepPicture(both, "workshop_eyes_" + name + ".png");

        const PictureTarget alone(last.width, last.height, headset.eyes().samples());
        for (int eye = 0; eye < 2; ++eye) {
            const std::array<View, 1> one{DrawnLesson::view(last.views[size_t(eye)], last)};
            lesson.renderer.draw(lesson.scene(), lesson.look, one, alone.target(), nullptr);
            const ImageDifference difference = compareImages(alone.read(), column(both, eye), 24);
            INFO(name << " (" << chosen.sentence << "), eye " << eye << ": mean " << difference.mean << ", far "
                      << difference.farPixels);
            CHECK(difference.mean < 0.5);
            CHECK(difference.farPixels < 0.002);
        }
        // The eyes differ from each other, or the test would pass on two equal pictures.
        CHECK(compareImages(column(both, 0), column(both, 1), 24).farPixels > 0.01);
    }
    CHECK(misuses() == "");
}
