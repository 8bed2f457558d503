// Tests a real session on a real runtime: its states, and both eyes' pictures as composited.
#include "tests/support/catch.hpp"
#include "tests/xr/monado_run.hpp"

#include <cmath>

using namespace meltpool;
using namespace meltpool::test;

namespace {

/// Projects a point of the session's space into an eye's picture: pixels from its lower left corner.
glm::vec2 pixelOf(const glm::vec3& point, const xr::EyeView& view, const xr::BothEyes& eyes) {
    const glm::mat4 toClip = xr::projection(view.fov, eyes.nearZ, eyes.farZ) * view.pose.inverse().matrix();
    const glm::vec4 clip = toClip * glm::vec4(point, 1.0f);
    return (glm::vec2(clip) / clip.w * 0.5f + 0.5f) * glm::vec2(float(eyes.width), float(eyes.height));
}

/// Draws a plain ground for each eye (left reddish, right bluish) with a white square on the point.
void drawMarked(const xr::BothEyes& eyes, const glm::vec3& point) {
    glBindFramebuffer(GL_FRAMEBUFFER, eyes.framebuffer);
    glEnable(GL_SCISSOR_TEST);
    for (int eye = 0; eye < 2; ++eye) {
        glScissor(eye * eyes.width, 0, eyes.width, eyes.height);
        glClearColor(eye == 0 ? 0.6f : 0.1f, 0.2f, eye == 1 ? 0.6f : 0.1f, 1.0f);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        const glm::vec2 at = pixelOf(point, eyes.views[size_t(eye)], eyes);
        glScissor(eye * eyes.width + int(std::lround(at.x)) - 6, int(std::lround(at.y)) - 6, 12, 12);
        glClearColor(1, 1, 1, 1);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    glDisable(GL_SCISSOR_TEST);
}

/// Returns the middle of the white pixels, from the top left corner; their number in `count`.
glm::dvec2 whiteSpot(const Image& image, int& count) {
    glm::dvec2 sum(0);
    count = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const std::uint8_t* rgb = &image.rgb[(size_t(y) * size_t(image.width) + size_t(x)) * 3];
            if (rgb[0] < 200 || rgb[1] < 200 || rgb[2] < 200) continue;
            sum += glm::dvec2(x + 0.5, y + 0.5);
            ++count;
        }
    return sum / double(std::max(count, 1));
}

/// Returns false if the runtime does not answer in time: a busy machine.
bool answers(const std::function<void()>& call) {
    try {
        call();
        return true;
    } catch (const xr::Stalled&) {
        return false;
    }
}

} // namespace

TEST_CASE("both eyes reach the compositor with the right parallax", "[runtime]") {
    hiddenWindow();
    RemoteDriver driver(driverPort());
    driver.send({});
    xr::Headset headset(std::make_unique<xr::Instance>(), {.resolutionScale = 0.5f, .samples = 4});
    REQUIRE(waitUntilOpen(headset));
    CHECK(headset.instance().info().runtime.find("Monado") == 0);
    CHECK(std::string(headset.bindingKind()) == "GLX");
    CHECK(headset.session().originOnFloor());
    CHECK(headset.hasDepthLayer());
    CHECK(headset.eyes().samples() == 4);
    REQUIRE(reach(headset, xr::SessionMode::focused));

    const glm::vec3 point(0.1f, 1.5f, -0.6f);
    // The compositor shows the session's pictures some frames late, and at its own pace.
    Image screen;
    REQUIRE(waitUntil([&] {
        stepFrames(headset, 20, [&](const xr::BothEyes& eyes) { drawMarked(eyes, point); });
        screen = screenshot();
        int left = 0, right = 0;
        whiteSpot(shownEye(screen, 0), left);
        whiteSpot(shownEye(screen, 1), right);
        return left > 100 && right > 100;
    }));
    keepPicture(screen, "both_eyes.png");

    std::array<glm::dvec2, 2> spot;
    for (int eye = 0; eye < 2; ++eye) {
        const Image shown = shownEye(screen, eye);
        int white = 0;
        spot[size_t(eye)] = whiteSpot(shown, white);
        // The ground's code is unchanged: the picture is encoded once, neither twice nor back.
        const std::uint8_t* corner = &shown.rgb[size_t(shown.width) * 20 * 3 + 60];
        CHECK(int(corner[eye == 0 ? 0 : 2]) == Approx(153).margin(3));
        CHECK(int(corner[eye == 0 ? 2 : 0]) == Approx(26).margin(3));
        // Pinhole projection by hand: the eye is at (±31.5 mm, 1.6 m), 0.6 m from the point.
        const xr::EyeView& view = headset.views()[size_t(eye)];
        const double x = double(point.x - view.pose.position.x) / 0.6, y = double(point.y - view.pose.position.y) / 0.6;
        const double left = std::tan(double(view.fov.left)), right = std::tan(double(view.fov.right));
        const double up = std::tan(double(view.fov.up)), down = std::tan(double(view.fov.down));
        CHECK(spot[size_t(eye)].x == Approx((x - left) / (right - left) * shown.width).margin(1.0));
        CHECK(spot[size_t(eye)].y == Approx((up - y) / (up - down) * shown.height).margin(1.0));
    }
    CHECK(spot[0].y == Approx(spot[1].y).margin(0.1));
    const double tangents =
        std::tan(double(headset.views()[0].fov.right)) - std::tan(double(headset.views()[0].fov.left));
    CHECK(spot[0].x - spot[1].x == Approx(0.063 / 0.6 / tangents * 480).margin(1.0));
    CHECK(xr::ContextGuard::repairs().errors == 0);
    CHECK(misuses() == "");
}

TEST_CASE("the eyes follow the head", "[runtime]") {
    hiddenWindow();
    RemoteDriver driver(driverPort());
    RemoteState state;
    state.head.position = {0.3f, 1.2f, 0.5f};
    state.head.orientation = glm::angleAxis(0.6f, glm::vec3(0, 1, 0));
    driver.send(state);
    xr::Headset headset(std::make_unique<xr::Instance>(), {.resolutionScale = 0.3f, .samples = 1});
    REQUIRE(reach(headset, xr::SessionMode::focused));
    const auto nothing = [](const xr::BothEyes& eyes) { drawMarked(eyes, {0, 1, -1}); };
    const auto middle = [&] { return (headset.views()[0].pose.position + headset.views()[1].pose.position) * 0.5f; };
    REQUIRE(stepUntil(
        headset, [&] { return glm::distance(middle(), state.head.position) < 0.002f; }, nothing));
    const glm::vec3 forward = headset.views()[0].pose.forward();
    CHECK(glm::distance(forward, state.head.orientation * glm::vec3(0, 0, -1)) < 0.002f);
    CHECK(glm::distance(headset.views()[0].pose.position, headset.views()[1].pose.position) ==
          Approx(0.063).margin(0.001));
    CHECK(misuses() == "");
}

TEST_CASE("a session ends in order from every state", "[runtime]") {
    hiddenWindow();
    RemoteDriver driver(driverPort());
    driver.send({});
    SECTION("before it is open") {
        xr::Headset headset(std::make_unique<xr::Instance>(), {.resolutionScale = 0.3f, .samples = 1});
    }
    SECTION("before it has begun") {
        xr::Headset headset(std::make_unique<xr::Instance>(), {.resolutionScale = 0.3f, .samples = 1});
        REQUIRE(waitUntilOpen(headset));
    }
    SECTION("in the middle of a frame") {
        xr::Headset headset(std::make_unique<xr::Instance>(), {.resolutionScale = 0.3f, .samples = 1});
        REQUIRE(reach(headset, xr::SessionMode::focused));
        REQUIRE(waitUntil([&] {
            return answers([&] {
                headset.poll();
                headset.waitFrame();
                headset.beginFrame();
            });
        }));
    }
    SECTION("by the person's wish") {
        xr::Headset headset(std::make_unique<xr::Instance>(), {.resolutionScale = 0.3f, .samples = 1});
        REQUIRE(reach(headset, xr::SessionMode::focused));
        REQUIRE(waitUntil([&] {
            stepFrame(headset, {});
            return !headset.running() || answers([&] { headset.requestExit(); });
        }));
        CHECK(reach(headset, xr::SessionMode::ended));
        CHECK_FALSE(headset.running());
    }
    CHECK(misuses() == "");
}
