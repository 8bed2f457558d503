// Tests the interface's rounded rectangles in every size, drawn by the installed Dear ImGui without a window.
#include "app/ui/panels.hpp"
#include "core/base/text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/places.hpp"

#include <cmath>
#include <limits>

namespace meltpool {

namespace {

/// Runs Dear ImGui with only a screen and a font.
class BareInterface {
  public:
    BareInterface() {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {1280, 800};
        context_.fonts.body = io.Fonts->AddFontDefault();
        context_.fonts.strong = context_.fonts.small = context_.fonts.title = context_.fonts.body;
        unsigned char* pixels = nullptr;
        int width = 0;
        int height = 0;
        io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
        ui::applyTheme(1);
    }
    ~BareInterface() { ImGui::DestroyContext(); }
    BareInterface(const BareInterface&) = delete;
    BareInterface& operator=(const BareInterface&) = delete;

    /// Runs `draw(context)` within a frame; returns the number of corners of its triangles.
    template <class Draw>
    int frame(const Draw& draw) {
        ImGui::NewFrame();
        context_.beginFrame();
        draw(context_);
        ImGui::Render();
        return ImGui::GetDrawData()->TotalVtxCount;
    }

  private:
    ui::Context context_;
};

/// Fills a profiler with one pass that the GPU has run and timed.
void timeOnePass(gl::Profiler& profiler) {
    test::context();
    for (int i = 0; i < 3; ++i) {
        profiler.beginFrame();
        {
            const gl::Scope scope(&profiler, "pass");
            glClear(GL_COLOR_BUFFER_BIT);
        }
        profiler.endFrame();
    }
    profiler.finish();
    REQUIRE(profiler.passes().size() == 1);
    REQUIRE(profiler.passes()[0].lastMs > 0);
}

} // namespace

TEST_CASE("rectangles of every size and radius are drawn, whole or in part") {
    BareInterface interface;
    const auto drawAt = [&](float origin, float side, ImDrawFlags corners) {
        interface.frame([&](ui::Context&) {
            ImDrawList& draw = *ImGui::GetForegroundDrawList();
            // Sides next to it are tried as well: a narrow range of them divides by zero.
            for (const float step : {-4e-6f, -1e-6f, -2.4e-7f, 0.0f, 2.4e-7f, 1e-6f, 4e-6f})
                for (const float radius : {3.0f, 10.0f}) {
                    ui::fillRounded(draw, {origin, 7}, {origin + side + step, 21}, ~0u, radius, corners);
                    ui::fillRounded(draw, {7, origin}, {30, origin + side + step}, ~0u, radius, corners);
                    ui::outlineRounded(draw, {origin, 7}, {origin + side + step, 21}, ~0u, radius);
                }
        });
    };
    for (const float origin : {0.0f, 28.0f, 346.25f})
        for (const ImDrawFlags corners : {ImDrawFlags_RoundCornersAll, ImDrawFlags_RoundCornersLeft})
            for (float side = 0; side <= 20; side += 1.0f / 128)
                drawAt(origin, side, corners);
    const int drawn = interface.frame([](ui::Context&) {
        constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
        ImDrawList& draw = *ImGui::GetForegroundDrawList();
        ui::fillRounded(draw, {0, 0}, {kNone, 20}, ~0u, 3);
        ui::fillRounded(draw, {0, 0}, {20, 20}, ~0u, kNone);
        ui::fillRounded(draw, {0, 0}, {20, 20}, ~0u, 1e-7f);
    });
    CHECK(drawn == 3 * 4); // sharp corners
    // Enough room makes the corners round.
    CHECK(interface.frame([](ui::Context&) {
        ui::fillRounded(*ImGui::GetForegroundDrawList(), {0, 0}, {20, 20}, ~0u, 3);
    }) > 8);
}

TEST_CASE("the timings panel draws bars of all widths from 0 to 20 pixels") {
    gl::Profiler profiler;
    timeOnePass(profiler);
    BareInterface interface;
    const double ms = profiler.passes()[0].lastMs;
    double room = 0; // room for a bar, pixels
    const auto show = [&](double pixels) {
        return interface.frame([&](ui::Context& context) {
            constexpr float kGap = 10; // next to the panel, included in panelReach()
            room = static_cast<double>(ui::panelReach(context) - kGap - 2 * ImGui::GetStyle().WindowPadding.x);
            ui::timingsPanel(context, profiler, {}, ms * room / pixels, "driver", false);
        });
    };
    show(5);
    CHECK(show(5) > 100);
    for (double pixels = 1e-3; pixels <= 20; pixels += 1e-3)
        show(pixels);
    // A single number in a step of 2e-6 divides by zero at a place of some tens of pixels.
    for (const double whole : {1.0, 2.0, 3.0, 4.0})
        for (double off = -2e-5; off <= 2e-5; off += 5e-7)
            show(whole + off);
}

TEST_CASE("every rectangle of the interface is drawn by the function that knows small ones") {
    size_t sources = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(test::sourceFolder() / "app")) {
        if (entry.path().extension() != ".cpp" || entry.path().filename() == "widgets.cpp") continue;
        ++sources;
        const std::string text = readTextFile(entry.path());
        INFO(entry.path().string());
        for (const char* call : {"AddRectFilled(", "AddRect(", "PathRect("})
            CHECK(text.find(call) == std::string::npos);
    }
    CHECK(sources > 50);
}

} // namespace meltpool
