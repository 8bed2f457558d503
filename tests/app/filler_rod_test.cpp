// A filler rod in the other hand: drawn with the processes that melt it, absent from other pictures.
#include "app/headset/stereo_view.hpp"
#include "core/render/picture_target.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <array>

using namespace meltpool;

namespace {

constexpr int kWidth = 160, kHeight = 120; // pixels per eye

/// The processes of the test; the lesson of the last one excludes a rod.
enum class Kind { gmaw, gtaw, gtawWithoutRod };

/// The GMAW lesson on a plate of 24x20 mm, or a GTAW torch on that plate.
Lesson smallWeld(Kind kind) {
    Lesson lesson = findLesson("gmaw-bead", test::testFolder().parent_path() / "app" / "data" / "lessons");
    lesson.workpiece.lengthMm = 24;
    lesson.workpiece.widthMm = 20;
    lesson.surface.cells = 32;
    if (kind != Kind::gmaw) lesson.process.choose<Gtaw>();
    if (kind == Kind::gtawWithoutRod) lesson.process.of<Gtaw>().rodDiameterMm = 0;
    return lesson;
}

/// A welding torch 3 mm over the plate; `rod` adds a filler rod in full view, with its end some mm from the arc.
TorchSample torchWith(bool rod) {
    TorchSample torch;
    torch.tip = {0, 0.003F, 0};
    torch.orientation = glm::angleAxis(-1.5707963F, glm::vec3(1, 0, 0));
    torch.trigger = 1;
    if (rod) torch.rod = RodSample{{0.004F, 0.004F, 0.004F}, glm::angleAxis(0.5F, glm::vec3(0, 1, 0))};
    return torch;
}

/// The window's and the headset's picture after some welding.
struct Shown {
    Image window, eyes;
    size_t solids = 0; ///< number in the window's draw list
};

Shown weldWith(Kind kind, const TorchSample& torch) {
    LessonSession session(test::shaders(), smallWeld(kind));
    Controls controls;
    session.begin(controls);
    while (session.run().steps() < 20) // at most one step a call, however fast this machine is
        session.advance(controls, 1.0 / 200, nullptr, [&](int, int) { return torch; });
    REQUIRE(session.run().steps() == 20);
    REQUIRE(session.run().arc().burns());
    // A rod that the lesson excludes reaches neither session nor record.
    CHECK(session.run().torch().rod.has_value() == (torch.rod.has_value() && kind == Kind::gtaw));

    Shown shown;
    const PictureTarget window(kWidth, kHeight);
    const SceneView scene = session.picture().scene(nullptr);
    shown.solids = scene.solids.size();
    const std::array<View, 1> view{controls.view(static_cast<float>(kWidth) / kHeight)};
    session.picture().renderer().draw(scene, session.lesson().look, view, window.target(), nullptr);
    shown.window = window.read();

    HeadsetParameters parameters;
    StereoView stereo(parameters);
    const HeadsetHands hands(parameters, test::scratchFolder("filler-rod"));
    stereo.takeHands(hands, PanelPointer(parameters));
    const PictureTarget both(2 * kWidth, kHeight);
    xr::BothEyes eyes;
    eyes.framebuffer = both.target().framebuffer;
    eyes.width = kWidth;
    eyes.height = kHeight;
    eyes.nearZ = 0.05F;
    eyes.farZ = 20;
    for (const int eye : {0, 1})
        eyes.views[size_t(eye)] = {
            {glm::angleAxis(-0.85F, glm::vec3(1, 0, 0)), {eye == 0 ? -0.03F : 0.03F, 1.2F, 0.25F}},
            {-0.6F, 0.6F, 0.5F, -0.5F}};
    const WorkpiecePlace place(parameters.tableHeight, 4, session.picture().bottom());
    stereo.draw(session, session.picture().scene(nullptr), place, Workshop(), eyes, nullptr);
    shown.eyes = both.read();
    return shown;
}

} // namespace

TEST_CASE("a filler rod in the hand is drawn where its process melts it, in the window and in both eyes", "[app]") {
    for (const Kind kind : {Kind::gmaw, Kind::gtaw, Kind::gtawWithoutRod}) {
        INFO(static_cast<int>(kind));
        const bool shown = kind == Kind::gtaw;
        const Shown without = weldWith(kind, torchWith(false)), with = weldWith(kind, torchWith(true));
        CHECK(without.solids > 2); // the torch's solids
        CHECK(with.solids == without.solids + (shown ? 1 : 0));
        if (shown) {
            CHECK(compareImages(with.window, without.window, 24).farPixels > 0.002);
            CHECK(compareImages(with.eyes, without.eyes, 24).farPixels > 0.002);
        } else {
            CHECK(compareImages(with.window, without.window, 0).largest == 0);
            CHECK(compareImages(with.eyes, without.eyes, 0).largest == 0);
        }
        // A moved torch changes the picture.
        TorchSample moved = torchWith(false);
        moved.tip.x = 0.004F;
        const Shown other = weldWith(kind, moved);
        CHECK(compareImages(other.window, without.window, 24).farPixels > 0.002);
        CHECK(compareImages(other.eyes, without.eyes, 24).farPixels > 0.002);
    }
}
