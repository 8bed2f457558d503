// Tests the level of the window's picture on machines of different speed, with the steps of the metal that they make.
#include "app/activities/step_clock.hpp"
#include "app/desktop/picture_quality.hpp"
#include "app/desktop/scaled_picture.hpp"
#include "core/render/picture_target.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <algorithm>

namespace meltpool {

namespace {

constexpr double kStep = 1.0 / 90; // s of the metal

/// Costs of a machine, s.
struct Machine {
    double step = 0;     ///< step of the metal
    double rest = 0;     ///< rest of a frame, without steps and pixels
    double pixels = 0;   ///< all pixels of the window
    double shortest = 0; ///< shortest frame: the display waits
    bool beside = false; ///< steps run while the picture is drawn
};

/// Results of the last ten of sixty seconds.
struct Outcome {
    PictureLevel level = PictureLevel::full;
    double speed = 0;     ///< ratio of simulated to real time
    double perSecond = 0; ///< pictures a second
    int changes = 0;      ///< changes of the level, in all sixty seconds after the first five
};

class DrawnWeld {
  public:
    explicit DrawnWeld(const Machine& machine) : machine_(machine) {}

    Outcome run(double seconds) {
        Outcome outcome;
        double simulated = 0, real = 0, frames = 0;
        for (double now = 0; now < seconds; now += elapsed_) {
            const PictureLevel before = budget.level();
            budget.add(cost_);
            if (now > 5 && budget.level() != before) ++outcome.changes;
            const int due = clock_.due(elapsed_, kStep);
            clock_.took(due * machine_.step, due);
            const double share = static_cast<double>(kPictureShares[static_cast<size_t>(budget.level())]);
            drawn(due * machine_.step, machine_.pixels * share * share);
            if (now < seconds - 10) continue;
            simulated += due * kStep;
            real += elapsed_;
            ++frames;
        }
        outcome.level = budget.level();
        outcome.speed = simulated / real;
        outcome.perSecond = frames / real;
        return outcome;
    }

    PictureBudget budget;

  private:
    void drawn(double steps, double picture) {
        const double work = machine_.beside ? std::max(steps, picture) : steps + picture;
        elapsed_ = std::max(machine_.shortest, machine_.rest + work);
        if (machine_.beside)
            cost_ = {elapsed_, std::max(steps - picture, 0.0), 0, machine_.rest + steps};
        else
            cost_ = {elapsed_, steps, steps > 0 ? machine_.step / kStep : 0, 0};
    }

    Machine machine_;
    StepClock clock_;
    double elapsed_ = 0.02;
    FrameCost cost_{elapsed_, 0, 0, 0};
};

Outcome outcomeOn(const Machine& machine) {
    return DrawnWeld(machine).run(60);
}

} // namespace

TEST_CASE("a machine with time left draws with all pixels, whatever it waits for") {
    for (const double display : {1.0 / 144, 1.0 / 60, 1.0 / 30}) {
        const Outcome outcome = outcomeOn({0.0005, 0.001, 0.002, display});
        INFO("display " << display);
        CHECK(outcome.level == PictureLevel::full);
        CHECK(outcome.changes == 0);
        CHECK(outcome.speed == Approx(1).margin(0.02));
    }
}

TEST_CASE("where pixels keep the metal from the clock, there are fewer of them") {
    const Outcome outcome = outcomeOn({0.006, 0.006, 0.025, 0});
    CHECK(outcome.level != PictureLevel::full);
    CHECK(outcome.speed == Approx(1).margin(0.03));
    CHECK(outcome.perSecond >= 20);
    CHECK(outcome.changes <= 6);
}

TEST_CASE("a picture is no coarser than the metal needs") {
    CHECK(outcomeOn({0.004, 0.004, 0.02, 0}).level == PictureLevel::full);
    const Outcome outcome = outcomeOn({0.004, 0.006, 0.04, 0}); // may take 32 ms apart from steps
    CHECK(outcome.level == PictureLevel::fine);
    CHECK(outcome.speed == Approx(1).margin(0.03));
}

TEST_CASE("on a machine that is too slow for the metal the picture takes a quarter of the frame") {
    // The picture takes 14 ms of 94. The coarsest would take 11 of 91, and the metal would gain next to nothing.
    const Outcome outcome = outcomeOn({0.02, 0.008, 0.024, 0});
    CHECK(outcome.level == PictureLevel::medium);
    CHECK(outcome.speed > 0.45); // steps alone would reach 0.56
    CHECK(outcome.changes <= 6);
    const Outcome slow = outcomeOn({0.02, 0.008, 0.2, 0});
    CHECK(slow.level == PictureLevel::coarse);
    CHECK(slow.changes <= 6);
}

TEST_CASE("metal comes to stand once, half a second after its last step") {
    StillPicture picture;
    const auto stops = [&](int frames, bool moves) {
        int times = 0;
        for (int i = 0; i < frames; ++i)
            times += picture.count(0.1, moves) ? 1 : 0;
        return times;
    };
    CHECK(stops(3, true) == 0);
    CHECK(stops(4, false) == 0);
    CHECK(stops(1, true) == 0);
    CHECK(stops(4, false) == 0);
    CHECK(stops(2, false) == 1);
    CHECK(stops(30, false) == 0);
    CHECK(stops(1, true) == 0);
    CHECK(stops(30, false) == 1);
}

TEST_CASE("a picture stands when neither metal nor camera has moved for half a second") {
    StillPicture picture;
    View view;
    const auto frame = [&](bool moves) {
        picture.count(0.1, moves);
        return picture.stands(view);
    };
    for (int i = 0; i < 4; ++i)
        CHECK_FALSE(frame(false));
    CHECK_FALSE(frame(true));
    for (int i = 0; i < 4; ++i)
        frame(false);
    CHECK(frame(false));
    CHECK(frame(false));
    view.worldToEye[3].x = 0.001F;
    CHECK_FALSE(frame(false));
    for (int i = 0; i < 4; ++i)
        frame(false);
    CHECK(frame(false));
    view.eyeToClip[0].x = 2;
    CHECK_FALSE(frame(false));
}

TEST_CASE("beside steps a picture has all the time that they take") {
    const Outcome slow = outcomeOn({0.02, 0.012, 0.05, 0, true}); // 80 ms of steps
    CHECK(slow.level == PictureLevel::full);
    CHECK(slow.speed > 0.46); // steps alone would reach 0.56
    CHECK(slow.changes == 0);
    const Outcome quick = outcomeOn({0.008, 0.012, 0.03, 0, true});
    CHECK(quick.level == PictureLevel::full);
    CHECK(quick.speed == Approx(1).margin(0.03));
    CHECK(quick.perSecond >= 20);
    // The picture alone would take 0.2 s: the metal waits for it no longer than it must.
    const Outcome large = outcomeOn({0.008, 0.006, 0.2, 0, true});
    CHECK(large.level != PictureLevel::full);
    CHECK(large.speed == Approx(1).margin(0.03));
    CHECK(large.perSecond >= 10);
}

TEST_CASE("a long frame at the start makes the picture coarse for some seconds only") {
    DrawnWeld weld({0.002, 0.002, 0.01, 0});
    for (int i = 0; i < 8; ++i)
        weld.budget.add({3.0, 0.0, 0.0, 0.0}); // time of compiling shaders
    CHECK(weld.budget.level() != PictureLevel::full);
    CHECK(weld.run(30).level == PictureLevel::full);
}

TEST_CASE("a picture with fewer pixels fills the window") {
    test::context();
    const PictureTarget window(64, 48, 1);
    ScaledPicture scaled(test::shaders());
    const RenderTarget whole = scaled.begin({64, 48}, 1);
    CHECK(whole.framebuffer == 0);
    CHECK(whole.viewport.width == 64);
    const RenderTarget target = scaled.begin({64, 48}, 0.375f);
    CHECK(target.framebuffer != 0);
    CHECK(target.viewport.width == 24);
    CHECK(target.viewport.height == 18);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glClearColor(0, 1, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    scaled.end(window.target().framebuffer);
    const Image image = window.read();
    for (const auto& [x, y] : {std::pair(0, 0), std::pair(63, 0), std::pair(63, 47), std::pair(31, 20)}) {
        INFO(x << ", " << y);
        const size_t first = 3 * (static_cast<size_t>(y) * 64 + static_cast<size_t>(x));
        CHECK(image.rgb[first] == 0);
        CHECK(image.rgb[first + 1] == 255);
    }
}

} // namespace meltpool
