// Tests the news and the optional parts of a runtime on the stub runtime: presence, moved space, other controller,
// floor, display rate, depth test of the panel.
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/xr/stub/stub_runtime.hpp"
#include "xr/headset.hpp"

#include <chrono>
#include <cmath>
#include <functional>
#include <thread>

using namespace meltpool;
using test::stubRuntime;
using xr::Hand;

namespace {

using Clock = std::chrono::steady_clock;

/// Time limit far beyond any run, sanitizer and busy machine included.
constexpr std::chrono::seconds kPatience{300};

constexpr xr::HeadsetSettings kSmall{.resolutionScale = 1.0f, .samples = 1};

XrTime now() {
    return Clock::now().time_since_epoch().count();
}

/// A headset on the stub runtime that counts the news of its frames.
class CountedHeadset {
  public:
    explicit CountedHeadset(const test::StubDevice& device = {}) {
        test::context();
        stubRuntime().setDevice(device);
        headset_ = std::make_unique<xr::Headset>(std::make_unique<xr::Instance>(), kSmall);
        headset_->waitUntilOpened();
    }
    ~CountedHeadset() {
        headset_.reset();
        for (const auto end = Clock::now() + kPatience; stubRuntime().instances() > 0 && Clock::now() < end;)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        stubRuntime().setDevice({});
    }
    CountedHeadset(const CountedHeadset&) = delete;
    CountedHeadset& operator=(const CountedHeadset&) = delete;

    xr::Headset& operator*() { return *headset_; }
    xr::Headset* operator->() { return headset_.get(); }

    /// Does one turn of a front end's loop.
    void turn() {
        try {
            headset_->poll();
            if (!headset_->running()) {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
                return;
            }
            displayTime = headset_->waitFrame().displayTime;
            count(headset_->news());
            headset_->beginFrame();
            if (drawsEyes)
                headset_->drawEyes([this](const xr::BothEyes& eyes) {
                    hidden = eyes.hidden;
                    glBindFramebuffer(GL_FRAMEBUFFER, eyes.framebuffer);
                    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
                });
            headset_->showPanel({});
            headset_->showNotice({}, 0.36f, true);
            headset_->endFrame();
            ++ended_;
        } catch (const xr::Stalled&) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }

    bool turnUntil(const std::function<bool()>& done) {
        for (const auto end = Clock::now() + kPatience; Clock::now() < end;) {
            turn();
            if (done()) return true;
        }
        return false;
    }

    /// Reaches the ends of so many further frames.
    bool frames(int further) {
        const int end = ended_ + further;
        return turnUntil([&] { return ended_ >= end; });
    }

    int moves = 0, profiles = 0, putOn = 0, takenOff = 0; ///< frames with these news
    XrTime displayTime = 0;                               ///< of the last frame
    XrTime movedAt = 0;                                   ///< displayTime of the last frame with a moved space
    bool drawsEyes = true;
    xr::HiddenTriangles hidden; ///< of the last frame

  private:
    void count(const xr::SessionNews& news) {
        if (news.spaceMoved) movedAt = displayTime;
        moves += news.spaceMoved ? 1 : 0;
        profiles += news.profileChanged ? 1 : 0;
        putOn += news.worn == true ? 1 : 0;
        takenOff += news.worn == false ? 1 : 0;
    }

    std::unique_ptr<xr::Headset> headset_;
    int ended_ = 0;
};

} // namespace

TEST_CASE("putting on and taking off is reported in one frame each, at the session's begin too") {
    CountedHeadset headset;
    CHECK(headset->hasUserPresence());
    REQUIRE(headset.frames(5));
    CHECK(headset.putOn == 1);
    CHECK(headset.takenOff == 0);
    stubRuntime().wear(false);
    REQUIRE(headset.frames(5));
    CHECK(headset.takenOff == 1);
    stubRuntime().wear(true);
    REQUIRE(headset.frames(5));
    CHECK(headset.putOn == 2);
    CHECK(headset.moves + headset.profiles == 0);
}

TEST_CASE("presence needs the extension and the headset's sensor") {
    CHECK_FALSE(CountedHeadset({.withheld = {"XR_EXT_user_presence"}})->hasUserPresence());
    CHECK_FALSE(CountedHeadset({.presence = false})->hasUserPresence());
}

TEST_CASE("a moved space is reported in the frame that the change has reached, and another space is not") {
    CountedHeadset headset;
    REQUIRE(headset.frames(3));
    const XrTime at = now() + 100'000'000;
    stubRuntime().moveSpace(XR_REFERENCE_SPACE_TYPE_STAGE, at);
    REQUIRE(headset.turnUntil([&] { return headset.displayTime > at + 20'000'000; }));
    CHECK(headset.moves == 1);
    CHECK(headset.movedAt >= at);
    stubRuntime().moveSpace(XR_REFERENCE_SPACE_TYPE_VIEW, 0);
    REQUIRE(headset.frames(5));
    CHECK(headset.moves == 1);
    stubRuntime().moveSpace(XR_REFERENCE_SPACE_TYPE_LOCAL, 0); // the runtime's own button
    REQUIRE(headset.frames(5));
    CHECK(headset.moves == 2);
    stubRuntime().moveSpace(XR_REFERENCE_SPACE_TYPE_STAGE, now() + 3'600'000'000'000); // no time to believe
    REQUIRE(headset.frames(5));
    CHECK(headset.moves == 3);
}

TEST_CASE("news of a session that does not run are in its next first frame") {
    CountedHeadset headset;
    REQUIRE(headset.frames(3));
    stubRuntime().changeState(XR_SESSION_STATE_STOPPING);
    REQUIRE(headset.turnUntil([&] { return !headset->running(); }));
    stubRuntime().moveSpace(XR_REFERENCE_SPACE_TYPE_STAGE, 0);
    for (int i = 0; i < 20; ++i)
        headset.turn();
    CHECK(headset.moves == 0);
    stubRuntime().changeState(XR_SESSION_STATE_READY);
    REQUIRE(headset.frames(5));
    CHECK(headset.moves == 1);
    CHECK(headset.putOn == 2);
}

TEST_CASE("each happening is in one frame, also of a runtime that hangs in any call") {
    CountedHeadset headset;
    REQUIRE(headset.frames(3));
    for (int round = 0; round < 6; ++round) {
        std::thread runtime([round] {
            std::this_thread::sleep_for(std::chrono::microseconds(500 * round)); // hits another call each time
            stubRuntime().moveSpace(XR_REFERENCE_SPACE_TYPE_STAGE, 0);
            stubRuntime().hang();
            stubRuntime().wear(false);
        });
        const bool stalls = headset.turnUntil([&] { return headset->stalled(); });
        runtime.join();
        REQUIRE(stalls);
        for (int i = 0; i < 5; ++i)
            headset.turn();
        CHECK_FALSE(headset->news().spaceMoved);
        stubRuntime().goOn();
        REQUIRE(headset.frames(8));
        CHECK(headset.moves == round + 1);
        CHECK(headset.takenOff == round + 1);
    }
}

TEST_CASE("a held tool follows the aim of a controller that leans, from the report of the new controller on") {
    CountedHeadset headset;
    REQUIRE(headset.frames(3));
    CHECK(headset->input().holdsByAim(Hand::right) == false);
    const auto leans = [&] {
        const glm::vec3 held = headset->input().hand(Hand::right).hold.forward();
        return glm::degrees(std::asin(held.y));
    };
    CHECK(std::abs(leans()) < 0.1f);
    stubRuntime().changeController(glm::radians(50.0f));
    REQUIRE(headset.frames(5));
    CHECK(headset.profiles == 1);
    CHECK(headset->input().holdsByAim(Hand::right) == true);
    CHECK(leans() == Approx(50).margin(0.1));
    test::StubDevice device = stubRuntime().device();
    device.lean = 0; // a pose that changes by itself is no new controller
    stubRuntime().setDevice(device);
    REQUIRE(headset.frames(5));
    CHECK(leans() == Approx(50).margin(0.1));
    stubRuntime().changeController(glm::radians(20.0f));
    REQUIRE(headset.frames(5));
    CHECK(headset.profiles == 2);
    CHECK(std::abs(leans()) < 0.1f);
}

TEST_CASE("the floor is known from STAGE, else from LOCAL_FLOOR, else not") {
    CHECK(CountedHeadset()->session().spaceType() == XR_REFERENCE_SPACE_TYPE_STAGE);
    {
        CountedHeadset headset({.stage = false});
        CHECK(headset->session().spaceType() == XR_REFERENCE_SPACE_TYPE_LOCAL_FLOOR_EXT);
        CHECK(headset->session().originOnFloor());
        REQUIRE(headset.frames(2));
        stubRuntime().moveSpace(XR_REFERENCE_SPACE_TYPE_LOCAL_FLOOR_EXT, 0);
        stubRuntime().moveSpace(XR_REFERENCE_SPACE_TYPE_LOCAL, 0);
        REQUIRE(headset.frames(5));
        CHECK(headset.moves >= 1);
    }
    CountedHeadset headset({.withheld = {"XR_EXT_local_floor"}, .stage = false});
    CHECK(headset->session().spaceType() == XR_REFERENCE_SPACE_TYPE_LOCAL);
    CHECK_FALSE(headset->session().originOnFloor());
}

TEST_CASE("the display is asked for 90 Hz and both processors for a steady speed, where the runtime offers it") {
    {
        CountedHeadset headset;
        CHECK(stubRuntime().requestedRate() == 90.0f);
        CHECK(stubRuntime().sustainedProcessors() == 2);
    }
    CountedHeadset headset({.withheld = {"XR_FB_display_refresh_rate", "XR_EXT_performance_settings"}});
    REQUIRE(headset.frames(3));
    CHECK(stubRuntime().requestedRate() == 0.0f);
    CHECK(stubRuntime().sustainedProcessors() == 0);
}

TEST_CASE("panel and notice are tested against the eyes' depths, where the runtime can and the eyes have some") {
    {
        CountedHeadset headset;
        CHECK(headset->hasLayerDepthTest());
        REQUIRE(headset.frames(3));
        const std::vector<test::StubLayer> layers = stubRuntime().layers();
        REQUIRE(layers.size() == 3);
        CHECK(layers[0].type == XR_TYPE_COMPOSITION_LAYER_PROJECTION);
        CHECK((layers[0].tested && layers[0].writesDepth));
        CHECK(layers[0].compare == XR_COMPARE_OP_ALWAYS_FB);
        for (const size_t quad : {1, 2}) {
            CHECK(layers[quad].type == XR_TYPE_COMPOSITION_LAYER_QUAD);
            CHECK((layers[quad].tested && !layers[quad].writesDepth));
            CHECK(layers[quad].compare == XR_COMPARE_OP_LESS_OR_EQUAL_FB);
        }
        headset.drawsEyes = false;
        REQUIRE(headset.frames(3));
        for (const test::StubLayer& layer : stubRuntime().layers())
            CHECK_FALSE(layer.tested);
    }
    for (const char* missing : {"XR_FB_composition_layer_depth_test", "XR_KHR_composition_layer_depth"}) {
        CountedHeadset headset({.withheld = {missing}});
        CHECK_FALSE(headset->hasLayerDepthTest());
        REQUIRE(headset.frames(3));
        REQUIRE(stubRuntime().layers().size() == 3);
        for (const test::StubLayer& layer : stubRuntime().layers())
            CHECK_FALSE(layer.tested);
    }
}

TEST_CASE("the hidden parts of the eyes are read at the start and after each change") {
    CountedHeadset headset({.hidden = 0.25f});
    REQUIRE(headset.frames(3));
    const std::uint64_t first = headset.hidden.version;
    CHECK(first != 0);
    for (const std::span<const glm::vec2> corners : headset.hidden.corners) {
        REQUIRE(corners.size() == 6);
        CHECK(corners[1].x == Approx(-0.75));
    }
    REQUIRE(headset.frames(3));
    CHECK(headset.hidden.version == first);
    stubRuntime().changeMask(0.5f);
    REQUIRE(headset.frames(3));
    CHECK(headset.hidden.version > first);
    CHECK(headset.hidden.corners[1][1].x == Approx(-0.5));
    stubRuntime().changeMask(0.0f);
    REQUIRE(headset.frames(3));
    CHECK(headset.hidden.version == 0);
}

TEST_CASE("a mask is written out triangle by triangle, without triangles of unknown corners") {
    const std::vector<XrVector2f> vertices{{0, 0}, {1, 0}, {0, 1}};
    const std::vector<uint32_t> indices{0, 1, 2, 2, 1, 3, 1, 0, 2, 0};
    const std::vector<glm::vec2> expected{{0, 0}, {1, 0}, {0, 1}, {1, 0}, {0, 0}, {0, 1}};
    CHECK(xr::writeOut(vertices, indices) == expected);
}
