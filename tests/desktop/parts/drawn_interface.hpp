// Draws panels by the installed Dear ImGui without a window: finds the shown controls, their places, and the effect of
// clicks.
#pragma once

#include "app/ui/panels.hpp"
#include "app/ui/widgets.hpp"
#include "core/base/function_ref.hpp"

#include <cstddef>
#include <cstdlib>
#include <string>
#include <string_view>

namespace meltpool::test {

class DrawnInterface {
  public:
    using Content = FunctionRef<void(ui::Context&)>;

    DrawnInterface() {
        ImGui::GetAllocatorFunctions(&take_, &give_, &data_);
        ImGui::SetAllocatorFunctions(
            [](size_t bytes, void* self) {
                ++static_cast<DrawnInterface*>(self)->requests_;
                return std::malloc(bytes);
            },
            [](void* memory, void*) { std::free(memory); }, this);
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {1280, 2000};
        context_.fonts.body = io.Fonts->AddFontDefault();
        context_.fonts.strong = context_.fonts.small = context_.fonts.title = context_.fonts.body;
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
        ui::applyTheme(1);
        draw([](ui::Context&) {}); // newer Dear ImGui draws a window's corner only from its second frame on
    }
    ~DrawnInterface() {
        ImGui::DestroyContext();
        ImGui::SetAllocatorFunctions(take_, give_, data_);
    }
    DrawnInterface(const DrawnInterface&) = delete;
    DrawnInterface& operator=(const DrawnInterface&) = delete;

    ImVec2 size{430, 1900}; ///< of the window

    /// Draws one frame with the content in a window; returns the number of corners of its triangles.
    int draw(Content content) {
        ImGui::NewFrame();
        context_.beginFrame();
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize(size);
        ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoSavedSettings);
        content(context_);
        ImGui::End();
        ImGui::Render();
        return ImGui::GetDrawData()->TotalVtxCount;
    }

    /// Presses and releases the mouse in the middle of the item drawn under this name.
    void click(const std::string& name, Content content) {
        const ui::Place at = place(name);
        ImGuiIO& io = ImGui::GetIO();
        io.MousePos = {at.x + at.width / 2, at.y + at.height / 2};
        for (const bool down : {false, true, false}) {
            io.MouseDown[0] = down;
            draw(content);
        }
    }

    /// Clicks twice at once.
    void doubleClick(const std::string& name, Content content) {
        click(name, content);
        click(name, content);
    }

    /// Types the text, a letter a frame.
    void type(std::string_view text, Content content) {
        for (const char letter : text) {
            ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(letter));
            draw(content);
        }
    }

    /// Presses and releases a key.
    void strike(ImGuiKey key, Content content) {
        for (const bool down : {true, false}) {
            setKey(key, down);
            draw(content);
        }
    }

    /// Turns the wheel by a notch towards the person, with the mouse at a place, and draws until it has had its effect.
    void turnWheel(ImVec2 at, Content content) {
        ImGuiIO& io = ImGui::GetIO();
        io.MousePos = at;
        draw(content);
        io.MouseWheel = -1;
        ui::letWheelThroughMessages(true);
        for (int i = 0; i < 2; ++i)
            draw(content);
    }

    ui::Context& context() { return context_; }

    bool shows(const std::string& name) const {
        const auto found = context_.places.find(name);
        return found != context_.places.end() && context_.shown(found->second);
    }
    const ui::Place& place(const std::string& name) const { return context_.places.at(name); }

    /// Number of Dear ImGui's requests to the heap.
    size_t requests() const { return requests_; }

  private:
    static void setKey(ImGuiKey key, bool down) {
#if IMGUI_VERSION_NUM >= 18700
        ImGui::GetIO().AddKeyEvent(key, down);
#else
        ImGuiIO& io = ImGui::GetIO();
        io.KeyMap[key] = key;
        io.KeysDown[key] = down;
#endif
    }

    ui::Context context_;
    size_t requests_ = 0;
    ImGuiMemAllocFunc take_ = nullptr;
    ImGuiMemFreeFunc give_ = nullptr;
    void* data_ = nullptr;
};

} // namespace meltpool::test
