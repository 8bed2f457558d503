// Tests the headset's threads (drawing, calls of the runtime, search) on a runtime of the test's own, for the thread
// sanitizer: frames, a runtime that hangs and comes back, one that is lost, and headsets that are abandoned.
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/xr/stub/stub_runtime.hpp"
#include "xr/headset_connection.hpp"

#include <chrono>
#include <thread>

using namespace meltpool;
using test::stubRuntime;
using xr::ConnectionState;
using xr::Hand;

namespace {

using Clock = std::chrono::steady_clock;

/// Time limit far beyond any run, sanitizer and busy machine included.
constexpr std::chrono::seconds kPatience{300};

constexpr xr::HeadsetSettings kSmall{.resolutionScale = 1.0f, .samples = 1};

/// Does one frame of a front end: reads the runtime's news, draws both eyes and the panel, plays a pulse.
void frame(xr::Headset& headset) {
    const xr::FrameTiming timing = headset.waitFrame();
    const xr::HandInput& hand = headset.input().hand(Hand::right);
    headset.beginFrame();
    headset.play(Hand::right, {hand.trigger, 170.0f, 0.05f});
    if (timing.shouldRender)
        headset.drawEyes([](const xr::BothEyes& eyes) {
            glBindFramebuffer(GL_FRAMEBUFFER, eyes.framebuffer);
            glClearColor(eyes.views[0].pose.position.x, 0.5f, 0.5f, 1.0f);
            glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        });
    headset.showPanel(hand.grip);
    headset.endFrame();
}

/// Does one turn of a front end's loop.
void turn(xr::HeadsetConnection& link) {
    if (link.update() != ConnectionState::running) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        return;
    }
    try {
        frame(*link.headset());
    } catch (const xr::XrFault& fault) {
        link.onFault(fault);
    } catch (const xr::Stalled&) {
        link.onStall();
    }
}

template <class Done>
bool turnUntil(xr::HeadsetConnection& link, const Done& done) {
    for (const auto end = Clock::now() + kPatience; Clock::now() < end;) {
        turn(link);
        if (done()) return true;
    }
    return false;
}

bool framesPass(xr::HeadsetConnection& link, int count) {
    const int from = stubRuntime().frames();
    return turnUntil(link, [&] { return stubRuntime().frames() >= from + count; });
}

bool reaches(xr::HeadsetConnection& link, ConnectionState state) {
    return turnUntil(link, [&] { return link.state() == state; });
}

/// Returns true if no instance is left, abandoned ones included.
bool allGone() {
    for (const auto end = Clock::now() + kPatience; Clock::now() < end;) {
        if (stubRuntime().instances() == 0) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
}

} // namespace

TEST_CASE("frames are drawn and submitted on two threads") {
    test::context();
    {
        xr::HeadsetConnection link(kSmall);
        REQUIRE(framesPass(link, 100));
        CHECK(link.openings() == 1);
        CHECK(link.headset()->mode() == xr::SessionMode::focused);
        CHECK(link.headset()->hapticCalls().applied > 0);
        CHECK(std::string(link.headset()->bindingKind()) == "EGL");
        link.close();
        CHECK(link.state() == ConnectionState::ended);
    }
    CHECK(allGone());
}

TEST_CASE("a runtime that hangs in any call of a frame is given up and used again when it goes on") {
    test::context();
    xr::HeadsetConnection link(kSmall);
    REQUIRE(framesPass(link, 3));
    for (int i = 0; i < 4; ++i) {
        std::thread runtime([i] {
            std::this_thread::sleep_for(std::chrono::microseconds(700 * i)); // hits another call each time
            stubRuntime().hang();
        });
        const bool stalls = reaches(link, ConnectionState::stalled);
        runtime.join();
        REQUIRE(stalls);
        CHECK(stubRuntime().hanging() == 1);
        for (int further = 0; further < 5; ++further)
            turn(link); // the loop continues
        CHECK(link.state() == ConnectionState::stalled);
        stubRuntime().goOn();
        REQUIRE(framesPass(link, 5));
    }
    CHECK(link.openings() == 1);
}

TEST_CASE("a runtime that only paces its frames slowly gets their pictures, by which it learns that they are fast") {
    test::context();
    xr::HeadsetConnection link(kSmall);
    REQUIRE(framesPass(link, 3));
    stubRuntime().paceSlowly(3);
    REQUIRE(reaches(link, ConnectionState::stalled)); // reported while it lasts
    const int from = stubRuntime().frames();
    REQUIRE(turnUntil(link, [&] { return stubRuntime().slowFrames() == 0 || stubRuntime().frames() > from + 20; }));
    CHECK(stubRuntime().slowFrames() == 0);
    stubRuntime().paceSlowly(0);
    REQUIRE(reaches(link, ConnectionState::running));
    CHECK(link.openings() == 1);
}

TEST_CASE("a runtime that is lost is searched for and used again, and one that hangs is left behind") {
    test::context();
    {
        xr::HeadsetConnection link(kSmall);
        REQUIRE(framesPass(link, 3));
        stubRuntime().loseInstance();
        REQUIRE(reaches(link, ConnectionState::searching));
        REQUIRE(framesPass(link, 3));
        CHECK(link.openings() == 2);
        stubRuntime().hang();
        REQUIRE(reaches(link, ConnectionState::stalled));
    }
    // The link has ended and its call still hangs.
    CHECK(stubRuntime().instances() == 1);
    stubRuntime().goOn();
    CHECK(allGone());
}

TEST_CASE("headsets are opened and ended in quick succession") {
    test::context();
    for (int i = 0; i < 10; ++i) {
        xr::Headset headset(std::make_unique<xr::Instance>(), kSmall);
        if (i % 3 == 0) continue; // ends while it opens
        try {
            headset.waitUntilOpened();
            for (int turns = 0; turns < i; ++turns) {
                headset.poll();
                if (headset.running()) frame(headset);
            }
        } catch (const xr::Stalled&) {
            // The machine is busy; the headset ends in the middle of a call.
        }
    }
    CHECK(allGone());
}
