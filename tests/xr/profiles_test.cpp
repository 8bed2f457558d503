// Tests the table of controllers, the panel's ray, the formats and the context guard: all without a runtime.
#include "core/gl/context.hpp"
#include "tests/support/catch.hpp"
#include "tests/xr/remote_driver.hpp"
#include "xr/graphics_binding.hpp"
#include "xr/panel.hpp"
#include "xr/profiles.hpp"
#include "xr/swapchain.hpp"

#include <algorithm>
#include <cstring>
#include <set>

using namespace meltpool;

TEST_CASE("every controller can hold, heat and be felt in either hand, once each") {
    for (const xr::InteractionProfile& profile : xr::interactionProfiles()) {
        INFO(profile.path);
        const std::vector<xr::HandBinding> bindings = xr::handBindings(profile);
        for (const xr::Action action :
             {xr::Action::grip, xr::Action::trigger, xr::Action::haptic, xr::Action::aim, xr::Action::menu})
            for (const int hand : {0, 1})
                CHECK(std::count_if(bindings.begin(), bindings.end(), [&](const xr::HandBinding& binding) {
                          return binding.action == action && binding.hand == hand;
                      }) == 1);
        std::set<std::string> paths;
        for (const xr::HandBinding& binding : bindings)
            CHECK(paths.insert(binding.path).second);
    }
}

namespace {

/// Components of a controller that its extension lists and we may use.
struct Components {
    const char* profile;
    const char* extension;
    std::set<std::string> both;
    std::set<std::string> left;
    std::set<std::string> right;
};

const std::set<std::string> kPressedSqueeze{"input/grip/pose",       "input/aim/pose",      "output/haptic",
                                            "input/trigger/value",   "input/squeeze/click", "input/thumbstick",
                                            "input/thumbstick/click"};
const std::set<std::string> kFeltSqueeze{"input/grip/pose",       "input/aim/pose",      "output/haptic",
                                         "input/trigger/value",   "input/squeeze/value", "input/thumbstick",
                                         "input/thumbstick/click"};
const std::set<std::string> kLeftButtons{"input/x/click", "input/y/click", "input/menu/click"};
const std::set<std::string> kRightButtons{"input/a/click", "input/b/click"};

const std::vector<Components> kComponents{
    {"htc/vive_focus3_controller", "XR_HTC_vive_focus3_controller_interaction", kPressedSqueeze, kLeftButtons,
     kRightButtons},
    {"htc/vive_cosmos_controller", "XR_HTC_vive_cosmos_controller_interaction", kPressedSqueeze, kLeftButtons,
     kRightButtons},
    {"facebook/touch_controller_pro", "XR_FB_touch_controller_pro", kFeltSqueeze, kLeftButtons, kRightButtons},
    {"meta/touch_controller_plus", "XR_META_touch_controller_plus", kFeltSqueeze, kLeftButtons, kRightButtons},
    {"bytedance/pico_neo3_controller", "XR_BD_controller_interaction", kFeltSqueeze, kLeftButtons, kRightButtons},
    {"bytedance/pico4_controller", "XR_BD_controller_interaction", kFeltSqueeze, kLeftButtons, kRightButtons},
    {"bytedance/pico_ultra_controller_bd", "XR_BD_ultra_controller_interaction", kFeltSqueeze, kLeftButtons,
     kRightButtons},
    {"valve/frame_controller_valve",
     "XR_VALVE_frame_controller_interaction",
     kFeltSqueeze,
     {"input/view/click", "input/dpad_up/click"},
     {"input/menu/click", "input/a/click", "input/b/click", "input/x/click", "input/y/click"}},
};

} // namespace

TEST_CASE("controllers of extensions are suggested by their components, since one wrong path loses the controller") {
    const std::span<const xr::InteractionProfile> profiles = xr::interactionProfiles();
    for (const Components& known : kComponents) {
        INFO(known.profile);
        const auto profile = std::find_if(profiles.begin(), profiles.end(), [&](const xr::InteractionProfile& one) {
            return one.path == std::string("/interaction_profiles/") + known.profile;
        });
        REQUIRE(profile != profiles.end());
        CHECK(profile->extension == std::string(known.extension));
        for (const xr::SuggestedBinding& binding : profile->bindings) {
            INFO(binding.component);
            const bool inLeft = known.both.contains(binding.component) || known.left.contains(binding.component);
            const bool inRight = known.both.contains(binding.component) || known.right.contains(binding.component);
            CHECK((binding.sides == xr::Sides::right || inLeft));
            CHECK((binding.sides == xr::Sides::left || inRight));
        }
    }
}

TEST_CASE("a ray meets the panel where it points and nowhere from behind") {
    const xr::PanelShape shape{600, 300, 0.6f};
    const xr::Pose panel{glm::angleAxis(0.5f, glm::vec3(0, 1, 0)), {0.2f, 1.4f, -1.0f}};
    const xr::Pose front = panel * xr::Pose{{1, 0, 0, 0}, {0.1f, 0.05f, 0.8f}};
    const std::optional<glm::vec2> hit = xr::pointOnPanel(front, panel, shape);
    REQUIRE(hit);
    CHECK(hit->x == Approx(400).margin(0.1));
    CHECK(hit->y == Approx(100).margin(0.1));
    const xr::Pose behind = panel * xr::Pose{glm::angleAxis(3.14159f, glm::vec3(0, 1, 0)), {0, 0, -0.8f}};
    CHECK_FALSE(xr::pointOnPanel(behind, panel, shape));
    const xr::Pose beside = panel * xr::Pose{{1, 0, 0, 0}, {0.31f, 0, 0.8f}};
    CHECK_FALSE(xr::pointOnPanel(beside, panel, shape));
}

TEST_CASE("formats: sRGB before plain, any depth, and none is told") {
    const std::vector<std::int64_t> monado{
        GL_RGBA16, GL_RGBA16F, GL_SRGB8_ALPHA8, GL_RGBA8, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT16};
    CHECK(xr::chooseColourFormat(monado) == GLenum(GL_SRGB8_ALPHA8));
    CHECK(xr::chooseDepthFormat(monado) == GLenum(GL_DEPTH_COMPONENT32F));
    const std::vector<std::int64_t> plain{GL_RGBA8};
    CHECK(xr::chooseColourFormat(plain) == GLenum(GL_RGBA8));
    CHECK_FALSE(xr::chooseDepthFormat(plain));
    CHECK_FALSE(xr::chooseColourFormat(std::vector<std::int64_t>{GL_RGBA32F}));
}

TEST_CASE("a session without a usable format is refused with what was offered; without depth it goes on") {
    const std::vector<std::int64_t> monado{GL_RGBA16, GL_RGBA16F, GL_SRGB8_ALPHA8, GL_RGBA8, GL_DEPTH_COMPONENT32F};
    const xr::PictureFormats best = xr::choosePictureFormats(monado, true);
    CHECK(best.colour == GLenum(GL_SRGB8_ALPHA8));
    CHECK(best.depth == GLenum(GL_DEPTH_COMPONENT32F));
    CHECK(xr::choosePictureFormats(monado, false).depth == GLenum(GL_NONE));
    CHECK(xr::choosePictureFormats(std::vector<std::int64_t>{GL_RGBA8}, true).depth == GLenum(GL_NONE));
    CHECK_THROWS_WITH(xr::choosePictureFormats(std::vector<std::int64_t>{GL_RGBA16F, GL_DEPTH_COMPONENT16}, true),
                      test::containsText("SRGB8_ALPHA8") && test::containsText("34842"));
    CHECK_THROWS_WITH(xr::choosePictureFormats({}, true), test::containsText("none"));
}

TEST_CASE("a context that the runtime changed is put back and its errors are drained") {
    const gl::HeadlessContext other(false);
    const gl::HeadlessContext ours(false);
    const xr::ContextGuard::Repairs before = xr::ContextGuard::repairs();
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    {
        const xr::ContextGuard guard;
        glEnable(0x1234); // leaves an error behind
        other.makeCurrent();
        CHECK(glIsTexture(texture) == GL_FALSE);
    }
    CHECK(glIsTexture(texture) == GL_TRUE);
    CHECK(glGetError() == GLenum(GL_NO_ERROR));
    CHECK(xr::ContextGuard::repairs().contexts == before.contexts + 1);
    CHECK(xr::ContextGuard::repairs().errors > before.errors);
    CHECK(std::string(xr::GraphicsBinding::ofCurrentContext().kind()) == "EGL");
    glDeleteTextures(1, &texture);
}

TEST_CASE("a projection from the runtime's field of view maps its edges to the picture's edges") {
    const xr::FieldOfView fov{-0.9f, 0.6f, 0.7f, -0.8f};
    const glm::mat4 m = xr::projection(fov, 0.1f, 10.0f);
    const auto project = [&](float x, float y, float z) {
        const glm::vec4 clip = m * glm::vec4(x, y, z, 1);
        return glm::vec3(clip) / clip.w;
    };
    const glm::vec3 corner = project(2 * std::tan(fov.left), 2 * std::tan(fov.up), -2.0f);
    CHECK(corner.x == Approx(-1).margin(1e-5));
    CHECK(corner.y == Approx(1).margin(1e-5));
    CHECK(project(0, 0, -0.1f).z == Approx(-1).margin(1e-5));
    CHECK(project(0, 0, -10.0f).z == Approx(1).margin(1e-4));
}

TEST_CASE("the remote driver's packet has its bytes where they belong") {
    test::RemoteState state;
    state.head.position = {1, 2, 3};
    state.hands[0].trigger = 0.25f;
    state.hands[1].pose.position = {4, 5, 6};
    state.hands[1].active = false;
    const std::vector<std::uint8_t> bytes = test::encode(state);
    REQUIRE(bytes.size() == test::kRemotePacket);
    const auto number = [&](size_t at) {
        float value = 0;
        std::memcpy(&value, &bytes[at], sizeof value);
        return value;
    };
    CHECK(std::memcmp(bytes.data(), "mndrmt3", 8) == 0);
    CHECK(number(8 + 96 + 16) == 1.0f);        // head x
    CHECK(number(8 + 128 + 72) == 0.25f);      // left trigger
    CHECK(number(8 + 128 + 120 + 16) == 4.0f); // right x
    CHECK(bytes[8 + 128 + 105] == 1);          // left active
    CHECK(bytes[8 + 128 + 120 + 105] == 0);    // right active
}
