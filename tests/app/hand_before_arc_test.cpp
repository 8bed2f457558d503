// A glove before the arc in the headset: neither eye has the arc's veil, whose place is inside the eye, nor is dazzled.
#include "app/headset/stereo_view.hpp"
#include "core/render/picture_target.hpp"
#include "tests/app/small_lessons.hpp"
#include "tests/support/catch.hpp"

#include <cstdlib>

using namespace meltpool;

namespace {

constexpr int kEyeSide = 200; ///< pixels of an eye's picture

/// A burning TIG arc on a small plate, which two eyes see through a light visor.
class BurningArc {
  public:
    explicit BurningArc(bool eyeAdapts) : session_(test::shaders(), lesson(), [] { return 0.0; }) {
        Controls controls;
        session_.begin(controls);
        TorchSample torch;
        torch.tip = {0, 3e-3f, 0};
        torch.orientation = glm::angleAxis(-1.5707963f, glm::vec3(1, 0, 0));
        torch.trigger = 1;
        while (session_.run().steps() < 20)
            session_.advance(controls, 1.0 / 200, nullptr, [&](int, int) { return torch; });
        REQUIRE(session_.run().arc().burns());
        parameters_.adaptation = eyeAdapts;
        parameters_.visorShade = 5; // light for an arc: its veil is seen far from it
    }

    /// Takes the picture of both eyes with the hand without a torch there, in the workshop.
    Image seenWithHand(const glm::vec3& at) {
        HeadsetHands hands(parameters_, test::scratchFolder("hand-before-arc"));
        xr::HandInput left, right;
        left.present = left.tracked = true;
        left.grip.position = left.aim.position = left.hold.position = at;
        hands.update({&left, &right}, {}, Workshop(), torchGeometry(session_.lesson().process), 1.0 / 60);
        StereoView stereo(parameters_);
        stereo.takeHands(hands, PanelPointer(parameters_));
        stereo.update(session_, hands.torch(), false, 1);
        const PictureTarget both(2 * kEyeSide, kEyeSide);
        xr::BothEyes eyes;
        eyes.framebuffer = both.target().framebuffer;
        eyes.width = eyes.height = kEyeSide;
        eyes.nearZ = 0.05f;
        eyes.farZ = 20;
        for (const int eye : {0, 1})
            eyes.views[size_t(eye)] = {
                {glm::angleAxis(-0.85f, glm::vec3(1, 0, 0)), {eye == 0 ? -0.03f : 0.03f, 1.2f, 0.25f}},
                {-0.6f, 0.6f, 0.5f, -0.5f}};
        const WorkpiecePlace place(parameters_.tableHeight, 1, session_.picture().bottom());
        stereo.draw(session_, session_.picture().scene(nullptr), place, Workshop(), eyes, nullptr);
        dazzled_ = !stereo.dazzled().empty();
        return both.read();
    }
    /// Returns true if a second of the last picture dazzled the eyes.
    bool dazzled() const { return dazzled_; }

  private:
    static Lesson lesson() {
        Lesson lesson = test::plainBead();
        lesson.process.choose<Gtaw>();
        return lesson;
    }

    LessonSession session_;
    HeadsetParameters parameters_;
    bool dazzled_ = false;
};

/// Returns the mean green of an eye's picture 10 to 20 degrees beside the arc, where no hand is.
double besideArc(const Image& both, int eye) {
    double sum = 0;
    constexpr int kWide = 30, kHigh = 25, kLeft = 45, kTop = 90;
    for (int y = 0; y < kHigh; ++y)
        for (int x = 0; x < kWide; ++x)
            sum += both.rgb[3 * (size_t(kTop + y) * 2 * kEyeSide + size_t(eye * kEyeSide + kLeft + x)) + 1];
    return sum / (kWide * kHigh);
}

void keepPicture(const Image& image, const std::string& name) {
    if (const char* folder = std::getenv("MELTPOOL_PICTURES")) writePng(std::filesystem::path(folder) / name, image);
}

} // namespace

TEST_CASE("a glove before the arc takes the veil from both eyes", "[app]") {
    BurningArc arc(false);
    const Image aside = arc.seenWithHand({-0.4f, 1.0f, 0.2f}), before = arc.seenWithHand({0, 1.0f, 0.06f});
    keepPicture(aside, "hand-aside.png");
    keepPicture(before, "hand-before.png");
    for (const int eye : {0, 1}) {
        INFO("eye " << eye);
        CHECK(besideArc(before, eye) < besideArc(aside, eye) - 10);
    }
}

TEST_CASE("a glove before the arc keeps it from dazzling, one aside does not", "[app]") {
    BurningArc arc(true);
    arc.seenWithHand({-0.4f, 1.0f, 0.2f});
    CHECK(arc.dazzled());
    arc.seenWithHand({0, 1.0f, 0.06f});
    CHECK_FALSE(arc.dazzled());
    arc.seenWithHand({-0.4f, 1.0f, 0.2f});
    CHECK(arc.dazzled());
}
