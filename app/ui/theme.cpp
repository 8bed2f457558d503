#include "app/ui/theme.hpp"

#include "app/ui/letters.hpp"
#include "core/base/resources.hpp"

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace meltpool::ui {

namespace fs = std::filesystem;

namespace {

struct FontFiles {
    const char* regular;
    const char* strong;
};

constexpr std::array<FontFiles, 6> kFontFiles{{
    {"/usr/share/fonts/truetype/open-sans/OpenSans-Regular.ttf",
     "/usr/share/fonts/truetype/open-sans/OpenSans-Semibold.ttf"},
    {"/usr/share/fonts/open-sans/OpenSans-Regular.ttf", "/usr/share/fonts/open-sans/OpenSans-Semibold.ttf"},
    {"/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf", "/usr/share/fonts/truetype/noto/NotoSans-Bold.ttf"},
    {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"},
    {"C:/Windows/Fonts/segoeui.ttf", "C:/Windows/Fonts/seguisb.ttf"},
    {"/System/Library/Fonts/Supplemental/Arial.ttf", "/System/Library/Fonts/Supplemental/Arial Bold.ttf"},
}};

/// Fonts with many signs, used for letters that the first font lacks.
constexpr std::array<FontFiles, 5> kFurtherFiles{{
    {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"},
    {"/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf", "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans-Bold.ttf"},
    {"/usr/share/fonts/TTF/DejaVuSans.ttf", "/usr/share/fonts/TTF/DejaVuSans-Bold.ttf"},
    {"C:/Windows/Fonts/seguisym.ttf", "C:/Windows/Fonts/seguisym.ttf"},
    {"/System/Library/Fonts/Apple Symbols.ttf", "/System/Library/Fonts/Apple Symbols.ttf"},
}};

/// Largest size, in pixels, at which twice the width makes letters smoother.
constexpr float kOversampledUpTo = 40;

/// `further`: font for letters that the first one lacks; null: none.
ImFont* load(const char* file, const char* further, float size, const ImWchar* letters) {
    ImFontConfig config;
    config.OversampleH = size <= kOversampledUpTo ? 2 : 1;
    config.OversampleV = 1;
    ImFontAtlas* atlas = ImGui::GetIO().Fonts;
    ImFont* font = nullptr;
    if (file != nullptr) {
        font = atlas->AddFontFromFileTTF(file, size, &config, letters);
    } else {
        config.SizePixels = size;
        font = atlas->AddFontDefault(&config);
    }
    if (further == nullptr) return font;
    config.MergeMode = true; // merges into the font above; its own letters stay
    atlas->AddFontFromFileTTF(further, size, &config, letters);
    return font;
}

/// Names of the regular and strong font; empty if there are none.
using FontNames = std::array<std::string, 2>;

/// Finds the fonts that came with the program, else the first that the system has.
FontNames installedFonts(const FontFiles& own, std::span<const FontFiles> systems) {
    std::error_code unreadable;
    const fs::path folder = resourceFolder() / "fonts";
    const fs::path regular = folder / own.regular, strong = folder / own.strong;
    if (fs::is_regular_file(regular, unreadable) && fs::is_regular_file(strong, unreadable))
        return {regular.string(), strong.string()};
    for (const FontFiles& files : systems)
        if (fs::is_regular_file(files.regular, unreadable) && fs::is_regular_file(files.strong, unreadable))
            return {files.regular, files.strong};
    return {};
}

const char* nameOrNull(const std::string& name) {
    return name.empty() ? nullptr : name.c_str();
}

ImVec4 vec(ImU32 packed) {
    return ImGui::ColorConvertU32ToFloat4(packed);
}

} // namespace

Fonts loadFonts(float scale, float pixelScale) {
    ImGui::GetIO().Fonts->Clear();
    const FontNames files = installedFonts({"OpenSans-Regular.ttf", "OpenSans-Semibold.ttf"}, kFontFiles);
    const FontNames others = installedFonts({"DejaVuSans.ttf", "DejaVuSans-Bold.ttf"}, kFurtherFiles);
    const char *regular = nameOrNull(files[0]), *strong = nameOrNull(files[1]);
    const char *further = nameOrNull(others[0]), *furtherStrong = nameOrNull(others[1]);
    const float unit = scale * pixelScale;
    Fonts fonts;
    fonts.body = load(regular, further, 18 * unit, textLetters());
    fonts.strong = load(strong, furtherStrong, 18 * unit, textLetters());
    fonts.small = load(regular, further, 15 * unit, textLetters());
    fonts.title = load(strong, nullptr, 42 * unit, titleLetters());
    ImGui::GetIO().FontGlobalScale = 1 / pixelScale;
    return fonts;
}

void applyTheme(float scale) {
    ImGuiStyle style;
    style.WindowPadding = {18, 16};
    style.WindowRounding = 10;
    style.WindowBorderSize = 1;
    style.PopupRounding = 8;
    style.PopupBorderSize = 1;
    style.FramePadding = {12, 6};
    style.FrameRounding = 7;
    style.ItemSpacing = {10, 8};
    style.ItemInnerSpacing = {8, 6};
    style.ScrollbarSize = 10;
    style.ScrollbarRounding = 5;
    style.GrabRounding = 7;
    style.IndentSpacing = 14;

    ImVec4* c = style.Colors;
    ImGui::StyleColorsDark(&style);
    c[ImGuiCol_Text] = vec(colour::kText);
    c[ImGuiCol_TextDisabled] = vec(colour::kQuiet);
    c[ImGuiCol_WindowBg] = vec(colour::kPanel);
    c[ImGuiCol_PopupBg] = vec(IM_COL32(30, 34, 42, 250));
    c[ImGuiCol_Border] = vec(colour::kPanelEdge);
    c[ImGuiCol_FrameBg] = vec(colour::kField);
    c[ImGuiCol_FrameBgHovered] = vec(colour::kFieldHot);
    c[ImGuiCol_FrameBgActive] = vec(colour::kFieldHot);
    c[ImGuiCol_Button] = vec(colour::kField);
    c[ImGuiCol_ButtonHovered] = vec(colour::kFieldHot);
    c[ImGuiCol_ButtonActive] = vec(colour::kTrack);
    c[ImGuiCol_Header] = vec(IM_COL32(0, 0, 0, 0));
    c[ImGuiCol_HeaderHovered] = vec(IM_COL32(255, 255, 255, 14));
    c[ImGuiCol_HeaderActive] = vec(IM_COL32(255, 255, 255, 22));
    c[ImGuiCol_CheckMark] = vec(colour::kAccent);
    c[ImGuiCol_Separator] = vec(colour::kPanelEdge);
    c[ImGuiCol_ScrollbarBg] = vec(IM_COL32(0, 0, 0, 0));
    c[ImGuiCol_ScrollbarGrab] = vec(IM_COL32(255, 255, 255, 38));
    c[ImGuiCol_ScrollbarGrabHovered] = vec(IM_COL32(255, 255, 255, 64));
    c[ImGuiCol_ScrollbarGrabActive] = vec(IM_COL32(255, 255, 255, 90));
    c[ImGuiCol_TextSelectedBg] = vec(IM_COL32(255, 138, 61, 90));
    c[ImGuiCol_NavHighlight] = vec(colour::kAccent);
    style.ScaleAllSizes(scale);
    style.WindowBorderSize = 1;
    style.PopupBorderSize = 1;
    ImGui::GetStyle() = style;
}

} // namespace meltpool::ui
