// The expert's ghost in the headset: torch and name are in both eyes' pictures, and nothing of it without a ghost.
#include "app/headset/stereo_view.hpp"
#include "core/render/picture_target.hpp"
#include "tests/app/small_lessons.hpp"
#include "tests/support/catch.hpp"

#include <cstdlib>

using namespace meltpool;

namespace {

constexpr int kGhostEye = 480; ///< pixels of a side of an eye's picture

/// Returns both eyes' picture of a person who bows over the workpiece.
Image bothEyes(LessonSession& session, const HeadsetParameters& parameters) {
    const HeadsetHands hands(parameters, test::scratchFolder("headset-ghost"));
    StereoView stereo(parameters);
    stereo.takeHands(hands, PanelPointer(parameters));
    const PictureTarget both(2 * kGhostEye, kGhostEye, 4);
    xr::BothEyes eyes;
    eyes.framebuffer = both.target().framebuffer;
    eyes.width = eyes.height = kGhostEye;
    eyes.nearZ = 0.05f;
    eyes.farZ = 20;
    for (const int eye : {0, 1})
        eyes.views[size_t(eye)] = {
            {glm::angleAxis(-0.85f, glm::vec3(1, 0, 0)), {eye == 0 ? -0.03f : 0.03f, 1.2f, 0.25f}},
            {-0.45f, 0.45f, 0.45f, -0.45f}};
    const WorkpiecePlace place(parameters.tableHeight, 1, session.picture().bottom());
    stereo.draw(session, session.picture().scene(nullptr), place, Workshop(), eyes, nullptr);
    return both.read();
}

Image eyeOf(const Image& both, int eye) {
    Image one{kGhostEye, kGhostEye, {}};
    for (int y = 0; y < kGhostEye; ++y) {
        const auto row = both.rgb.begin() + std::ptrdiff_t(3) * (std::ptrdiff_t(y) * 2 + eye) * kGhostEye;
        one.rgb.insert(one.rgb.end(), row, row + std::ptrdiff_t(3) * kGhostEye);
    }
    return one;
}

} // namespace

TEST_CASE("both eyes see the expert's torch and its name, and neither where no ghost is chosen", "[app]") {
    LessonSession session(test::shaders(), test::smallBead(), [] { return 0.0; });
    session.attempt().ghost().parameters.ghost = static_cast<int>(GhostChoice::expert);
    Controls controls;
    session.begin(controls);
    HeadsetParameters parameters;
    const auto pass = [&] {
        for (int frame = 0; frame < 10; ++frame)
            session.advance(controls, 1.0 / 45, nullptr, [](int, int) {
                TorchSample torch;
                torch.tip = {0, 5e-3f, 0};
                torch.orientation = glm::angleAxis(-1.2f, glm::vec3(1, 0, 0));
                return torch;
            });
    };
    pass();
    const Image with = bothEyes(session, parameters);
    if (const char* folder = std::getenv("MELTPOOL_PICTURES"))
        writePng(std::filesystem::path(folder) / "headset-ghost.png", with);
    REQUIRE(session.attempt().ghost().on());
    session.attempt().ghost().parameters.ghost = static_cast<int>(GhostChoice::none);
    pass();
    REQUIRE_FALSE(session.attempt().ghost().on());
    const Image without = bothEyes(session, parameters);
    for (const int eye : {0, 1})
        CHECK(compareImages(eyeOf(with, eye), eyeOf(without, eye), 24).farPixels > 0.004);
}
