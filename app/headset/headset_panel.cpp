#include "app/headset/headset_panel.hpp"

#include "core/base/work_meter.hpp"
#include "core/gl/gl.hpp"

#include <algorithm>
#include <cfloat>

namespace meltpool {

namespace {

/// Makes a context current during its lifetime.
class Current {
  public:
    explicit Current(ImGuiContext* context) : before_(ImGui::GetCurrentContext()) { ImGui::SetCurrentContext(context); }
    ~Current() { ImGui::SetCurrentContext(before_); }
    Current(const Current&) = delete;
    Current& operator=(const Current&) = delete;

  private:
    ImGuiContext* before_;
};

} // namespace

HeadsetPanel::HeadsetPanel(int width, int height, Ground ground, float scale)
    : width_(width), height_(height), ground_(ground), imgui_(ImGui::CreateContext()) {
    const Current current(imgui_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.DisplaySize = {float(width), float(height)};
    context_.scale = scale;
    context_.tooltipsAtEdge = true;
    context_.typing = false;
    context_.fonts = ui::loadFonts(scale, 1.0f);
    ui::applyTheme(scale);
    ImGui_ImplOpenGL3_Init("#version 450 core");
}

HeadsetPanel::~HeadsetPanel() {
    {
        const Current current(imgui_);
        ImGui_ImplOpenGL3_Shutdown();
    }
    ImGui::DestroyContext(imgui_);
}

void HeadsetPanel::draw(GLuint framebuffer, const PointerOnPanel& pointer, double elapsed,
                        FunctionRef<void(ui::Context&)> content) {
    const Current current(imgui_);
    ImGuiIO& io = ImGui::GetIO();
    io.DeltaTime = std::max(static_cast<float>(elapsed), 1e-4f);
    io.MousePos = pointer.place ? ImVec2(pointer.place->x, pointer.place->y) : ImVec2(-FLT_MAX, -FLT_MAX);
    io.MouseDown[0] = pointer.place.has_value() && pointer.pressed;
    io.MouseWheel = pointer.scroll;
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
    context_.beginFrame();
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize(io.DisplaySize);
    ImGui::Begin("headset panel", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings |
                     (ground_ == Ground::clear ? ImGuiWindowFlags_NoBackground : ImGuiWindowFlags_None));
    content(context_);
    ImGui::End();
    if (pointer.place) {
        ImDrawList* top = ImGui::GetForegroundDrawList();
        top->AddCircleFilled(io.MousePos, 9, IM_COL32(0, 0, 0, 140), 24);
        top->AddCircleFilled(io.MousePos, 6, io.MouseDown[0] ? ui::colour::kAccent : ui::colour::kText, 24);
    }
    ImGui::Render();
    glDisable(GL_FRAMEBUFFER_SRGB); // Dear ImGui's colours are already sRGB-encoded
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, width_, height_);
    if (ground_ == Ground::clear)
        glClearColor(0, 0, 0, 0);
    else
        glClearColor(0.086f, 0.098f, 0.122f, 0.96f);
    glClear(GL_COLOR_BUFFER_BIT);
    const InWork driver(WorkPlace::driver);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

} // namespace meltpool
