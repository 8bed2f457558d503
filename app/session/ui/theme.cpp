#include "app/session/ui/theme.hpp"

#include "core/base/resources.hpp"

#include <array>
#include <filesystem>
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

/// Latin with accents, and the few signs that units and messages use.
constexpr std::array<ImWchar, 7> kGlyphs{0x0020, 0x017F, 0x2010, 0x2044, 0x2070, 0x209F, 0};

ImFont* load(const char* file, float size) {
    ImFontConfig config;
    config.OversampleH = 2;
    config.OversampleV = 1;
    ImFontAtlas* atlas = ImGui::GetIO().Fonts;
    if (file != nullptr) return atlas->AddFontFromFileTTF(file, size, &config, kGlyphs.data());
    config.SizePixels = size;
    return atlas->AddFontDefault(&config);
}

/// The fonts that came with the program, else the first that the system has; empty names where there are none.
std::array<std::string, 2> installedFonts() {
    std::error_code unreadable;
    const fs::path own = resourceFolder() / "fonts";
    const fs::path regular = own / "OpenSans-Regular.ttf", strong = own / "OpenSans-Semibold.ttf";
    if (fs::is_regular_file(regular, unreadable) && fs::is_regular_file(strong, unreadable))
        return {regular.string(), strong.string()};
    for (const FontFiles& files : kFontFiles)
        if (fs::is_regular_file(files.regular, unreadable) && fs::is_regular_file(files.strong, unreadable))
            return {files.regular, files.strong};
    return {};
}

ImVec4 vec(ImU32 packed) {
    return ImGui::ColorConvertU32ToFloat4(packed);
}

} // namespace

Fonts loadFonts(float scale, float pixelScale) {
    ImGui::GetIO().Fonts->Clear();
    const std::array<std::string, 2> files = installedFonts();
    const char* regular = files[0].empty() ? nullptr : files[0].c_str();
    const char* strong = files[1].empty() ? nullptr : files[1].c_str();
    const float unit = scale * pixelScale;
    Fonts fonts;
    fonts.body = load(regular, 18 * unit);
    fonts.strong = load(strong, 18 * unit);
    fonts.small = load(regular, 15 * unit);
    fonts.title = load(strong, 42 * unit);
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
