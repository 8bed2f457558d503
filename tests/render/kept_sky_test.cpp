// The sky behind a still camera: it is copied from a stored picture without a visible difference.
#include "core/render/camera.hpp"
#include "core/render/picture_target.hpp"
#include "core/render/renderer.hpp"
#include "tests/render/synthetic_scene.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <array>
#include <cstdlib>

namespace meltpool {

namespace {

constexpr int kWidth = 161, kHeight = 90;

View viewFrom(float turn) {
    return OrbitCamera(turn, 0.45f, 2.2f).view({}, static_cast<float>(kWidth) / kHeight);
}

/// A target with encoded values, such as a window's.
class PlainTarget {
  public:
    PlainTarget() {
        framebuffer_.attach(GL_COLOR_ATTACHMENT0, colour_);
        framebuffer_.attach(GL_DEPTH_ATTACHMENT, depth_);
        framebuffer_.requireComplete();
    }

    RenderTarget target() const { return {framebuffer_.name(), {0, 0, kWidth, kHeight}, false}; }
    Image read() const { return gl::readPixels(framebuffer_.name(), kWidth, kHeight); }

  private:
    gl::Texture colour_{"colour", {.format = GL_RGBA8, .width = kWidth, .height = kHeight}};
    gl::Texture depth_{"depth", {.format = GL_DEPTH_COMPONENT24, .width = kWidth, .height = kHeight}};
    gl::Framebuffer framebuffer_{"plain"};
};

/// A renderer that reports if its last picture shaded a sky behind the metal.
struct Painter {
    template <typename Target>
    Image draw(const View& view, const LookParameters& look, const Target& target) {
        profiler.reset();
        profiler.beginFrame();
        renderer.draw(scene.view(), look, {&view, 1}, target.target(), &profiler);
        profiler.endFrame();
        profiler.finish();
        return target.read();
    }
    bool shadedSky() const {
        const gl::PassTime* sky = profiler.find("draw sky");
        return sky != nullptr && sky->frames > 0;
    }

    test::SyntheticScene scene;
    Renderer renderer{test::shaders()};
    gl::Profiler profiler;
};

/// True if both pictures look equal to a person. A driver may shade a sky behind metal, whose depth it tests, and a sky
/// alone with different programs; Mesa 25 then rounds a few of ten thousand values to the next of 255 steps, Mesa 22
/// none.
bool looksTheSame(const Image& a, const Image& b) {
    if (a.width != b.width || a.height != b.height) return false;
    size_t differ = 0;
    for (size_t i = 0; i < a.rgb.size(); ++i) {
        const int difference = std::abs(static_cast<int>(a.rgb[i]) - static_cast<int>(b.rgb[i]));
        if (difference > 1) return false;
        differ += difference > 0 ? 1 : 0;
    }
    return differ * 1000 <= a.rgb.size();
}

/// Compares outside CHECK, which would print every value.
bool sameBits(const Image& a, const Image& b) {
    return a.rgb == b.rgb;
}

template <typename Target>
void checkCopies(const Target& target) {
    Painter still, moved;
    const LookParameters look;
    const Image first = still.draw(viewFrom(0.7f), look, target);
    CHECK(still.shadedSky());
    const Image second = still.draw(viewFrom(0.7f), look, target);
    CHECK_FALSE(still.shadedSky());
    CHECK(looksTheSame(second, first));
    for (int i = 0; i < 2; ++i) {
        CHECK(sameBits(still.draw(viewFrom(0.7f), look, target), second));
        CHECK_FALSE(still.shadedSky());
    }
    CHECK(sameBits(still.draw(viewFrom(0.9f), look, target), moved.draw(viewFrom(0.9f), look, target)));
    CHECK(still.shadedSky());
}

} // namespace

TEST_CASE("a camera that stands still keeps the sky of its first picture", "[render]") {
    test::context();
    SECTION("a target that encodes") {
        checkCopies(PictureTarget(kWidth, kHeight));
    }
    SECTION("a target as a window") {
        checkCopies(PlainTarget());
    }
}

TEST_CASE("a kept sky follows exposure, visor and the size of the picture", "[render]") {
    test::context();
    Painter painter;
    const PictureTarget target(kWidth, kHeight), smaller(kWidth - 20, kHeight);
    const View view = viewFrom(0.7f);
    std::array<LookParameters, 3> looks;
    looks[1].exposure = 0.5f;
    looks[2].visorShade = 10;
    for (const LookParameters& look : looks) {
        Painter fresh;
        for (int i = 0; i < 2; ++i)
            painter.draw(view, look, target);
        CHECK_FALSE(painter.shadedSky());
        CHECK(looksTheSame(painter.draw(view, look, target), fresh.draw(view, look, target)));
    }
    Painter fresh;
    CHECK(sameBits(painter.draw(view, looks[2], smaller), fresh.draw(view, looks[2], smaller)));
}

TEST_CASE("a multisampled picture shades its sky each time", "[render]") {
    test::context();
    Painter painter;
    const PictureTarget target(kWidth, kHeight, 4);
    REQUIRE(target.samples() > 1);
    const Image first = painter.draw(viewFrom(0.7f), {}, target);
    CHECK(sameBits(painter.draw(viewFrom(0.7f), {}, target), first));
    CHECK(painter.shadedSky());
}

} // namespace meltpool
