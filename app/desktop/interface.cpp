#include "app/desktop/interface.hpp"

#include "app/ui/panels.hpp"
#include "core/base/work_meter.hpp"

#include <algorithm>

namespace meltpool::ui {

Interface::Interface(Window& window) : window_(window) {
    context_.scale = 0;
    context_.keys = &window.keyNames();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr; // the program has its own settings file
    io.LogFilename = nullptr;
    ImGui_ImplGlfw_InitForOpenGL(window.handle(), true);
    ImGui_ImplOpenGL3_Init("#version 450 core");
}

Interface::~Interface() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void Interface::rebuildFonts(float scale, float pixelScale) {
    context_.scale = scale;
    pixelScale_ = pixelScale;
    context_.fonts = loadFonts(scale, pixelScale);
    applyTheme(scale);
#if IMGUI_VERSION_NUM < 19200
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
#endif
}

void Interface::takeGamepad(InputFrame& input, GamepadUse use, double seconds) {
    gamepadKeys_.translate(input, use, seconds);
    context_.gamepad = input.gamepad.connected;
    context_.byGamepad = gamepadKeys_.lastUsed();
}

void Interface::begin(float size, bool captured, bool byKeyboard, const InputFrame& input) {
    constexpr float kLargest = 6; // three times an ordinary density, with text of twice the size
    const float scale = std::clamp(window_.interfaceScale() * size, 0.5f, kLargest);
    // The sizes stay fixed while a slider is dragged, or it would move away from the mouse.
    const bool settled = context_.scale <= 0 || !ImGui::IsMouseDown(0);
    const bool other = settled && (scale != context_.scale || window_.pixelScale() != pixelScale_);
    if (other) rebuildFonts(scale, window_.pixelScale());
    ImGuiIO& io = ImGui::GetIO();
    const auto flag = [&io](ImGuiConfigFlags_ which, bool on) {
        io.ConfigFlags = on ? io.ConfigFlags | which : io.ConfigFlags & ~which;
    };
    flag(ImGuiConfigFlags_NoMouse, captured);
    flag(ImGuiConfigFlags_NavEnableKeyboard, byKeyboard);
    ImGui_ImplOpenGL3_NewFrame();
#if IMGUI_VERSION_NUM < 19200
    if (other) io.Fonts->ClearTexData(); // the driver has its own copy
#endif
    // ImGui_ImplGlfw_NewFrame() asks the display for mouse and focus, which takes longer than drawing all menus.
    if (window_.stirred()) ImGui_ImplGlfw_NewFrame();
    const Clock::time_point now = Clock::now();
    io.DeltaTime = std::max(std::chrono::duration<float>(now - lastBegin_).count(), 1e-4f);
    lastBegin_ = now;
    steering_.press(byKeyboard, input);
    letWheelThroughMessages(input.scroll != 0);
    ImGui::NewFrame();
    context_.beginFrame();
}

void Interface::takeInput(InputFrame& input, bool captured) const {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantTextInput) { // pictures and full screen have no other key
        const auto typed = [](Key key) { return key < Key::f10; };
        std::erase_if(input.pressed, typed);
        std::erase_if(input.struck, typed);
        input.held.reset();
    }
    if (!captured && io.WantCaptureMouse) {
        input.mouseMove = {0, 0};
        input.dragMove = {0, 0};
        input.scroll = 0;
        input.leftHeld = false;
        input.rightHeld = false;
    }
}

void Interface::end() {
    ImGui::Render();
    const glm::ivec2 pixels = window_.pixels();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, pixels.x, pixels.y);
    const InWork driver(WorkPlace::driver); // OpenGL calls of Dear ImGui itself
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Interface::drop() {
    ImGui::EndFrame();
}

} // namespace meltpool::ui
