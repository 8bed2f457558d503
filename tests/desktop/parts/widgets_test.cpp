// Words and tooltips of controls: no word is cut off, and a tooltip covers no neighbour of the control that keys chose.
#include "app/ui/widgets.hpp"

#include "app/ui/panels.hpp"
#include "tests/desktop/parts/drawn_interface.hpp"
#include "tests/support/catch.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <string>
#include <vector>

namespace meltpool::test {

namespace {

/// Left and right end of what a window of this kind has drawn in the last frame; both 0 without one.
struct Drawn {
    float left = 0, right = 0;
};

Drawn tooltipDrawn() {
    Drawn drawn{FLT_MAX, 0};
    const ImDrawData& data = *ImGui::GetDrawData();
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const ImDrawList& list = *data.CmdLists[i];
        if (list._OwnerName == nullptr || std::string(list._OwnerName).find("Tooltip") == std::string::npos) continue;
        for (const ImDrawVert& corner : list.VtxBuffer) {
            drawn.left = std::min(drawn.left, corner.pos.x);
            drawn.right = std::max(drawn.right, corner.pos.x);
        }
    }
    return drawn;
}

} // namespace

TEST_CASE("a text is broken at whole words, and what has no room is marked") {
    DrawnInterface interface;
    interface.draw([&](ui::Context& context) {
        ImFont& font = *context.fonts.small;
        const float size = ui::loadedSize(font);
        const std::string text = "Best so far: 97, accepted (with help)";
        const float whole = font.CalcTextSizeA(size, FLT_MAX, 0, text.c_str()).x;
        CHECK(ui::wholeWords(font, size, text, whole + 1, 1) == std::vector<std::string>{text});
        const auto one = ui::wholeWords(font, size, text, 0.85f * whole, 1);
        REQUIRE(one.size() == 1);
        CHECK(one[0] == "Best so far: 97, accepted .."); // not in the bracket
        const auto two = ui::wholeWords(font, size, text, 0.85f * whole, 2);
        REQUIRE(two.size() == 2);
        CHECK(two[0] + " " + two[1] == text);
        for (const std::string& line : two)
            CHECK(font.CalcTextSizeA(size, FLT_MAX, 0, line.c_str()).x <= 0.85f * whole);
    });
}

TEST_CASE("a wrapped text is broken between words, and no number at its dot") {
    DrawnInterface interface;
    interface.draw([&](ui::Context&) {
        const auto wide = [](const char* text) { return ImGui::CalcTextSize(text).x; };
        const auto lines = [](float room) {
            ui::wrappedText("it went from 0.1 to 0.82 mm", room);
            return std::lround(ImGui::GetItemRectSize().y / ImGui::GetTextLineHeight());
        };
        const float room = wide("it went from 0.1 to 0.8"); // Dear ImGui would put "0." into the first line
        CHECK(lines(room) == 2);
        CHECK(ImGui::GetItemRectSize().x == wide("it went from 0.1 to"));
        CHECK(lines(wide("it went from 0.1 to 0.82 mm") + 1) == 1);
    });
}

TEST_CASE("messages wait while the person welds in a low window, where they would cover the arc") {
    DrawnInterface interface;
    Messages messages;
    messages.warn("This computer is too slow.", 0, "slow");
    const auto drawn = [&](float height, bool welds) {
        ImGui::GetIO().DisplaySize.y = height;
        const auto content = [&](ui::Context& context) { ui::messageStack(context, messages, 0, 0, welds); };
        interface.draw(content); // a window of its content's size shows in the second frame
        return interface.draw(content);
    };
    CHECK(drawn(300, true) < drawn(300, false));
    CHECK(drawn(700, true) == drawn(700, false));
}

TEST_CASE("the wheel moves the list below a message, and a click on the message hides it") {
    DrawnInterface interface;
    interface.size = {1280, 400};
    Messages messages;
    messages.warn("A picture was saved.", 0);
    float scrolled = 0;
    const auto content = [&](ui::Context& context) {
        for (int row = 0; row < 100; ++row)
            ImGui::TextUnformatted("a row of a list that is longer than its window");
        scrolled = ImGui::GetScrollY();
        ui::messageStack(context, messages, 0, 0, false);
    };
    interface.draw(content);
    const ImVec2 onMessage{640, ui::barHeight(interface.context()) + interface.context().points(20)};
    interface.turnWheel(onMessage, content);
    CHECK(scrolled > 0);
    CHECK(messages.shown().size() == 1);
    ImGuiIO& io = ImGui::GetIO();
    for (const bool down : {false, true, false}) {
        io.MouseDown[0] = down;
        interface.draw(content);
    }
    CHECK(messages.shown().empty());
}

TEST_CASE("the tooltip of a control that keys have chosen lies beside the panel") {
    DrawnInterface interface;
    ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
#if IMGUI_VERSION_NUM < 18700
    for (int key = 0; key < ImGuiKey_COUNT; ++key)
        ImGui::GetIO().KeyMap[key] = key;
#endif
    const auto content = [](ui::Context& context) {
        ui::button(context, "first", "First", ui::ButtonKind::plain, 100, "What the first button does");
        ui::button(context, "second", "Second", ui::ButtonKind::plain, 100, "What the second button does");
    };
    interface.draw(content);
    interface.strike(ImGuiKey_DownArrow, content);
    for (int i = 0; i < 60 && tooltipDrawn().right == 0; ++i)
        interface.draw(content);
    CHECK_FALSE(interface.context().focus.empty());
    CHECK(tooltipDrawn().right > 0);
    CHECK(tooltipDrawn().left >= interface.size.x);
}

} // namespace meltpool::test
