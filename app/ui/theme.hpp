// Sets the interface's colours, fonts and measures.
#pragma once

#include "app/ui/imgui_headers.hpp"

namespace meltpool::ui {

/// Names colours by meaning.
namespace colour {
constexpr ImU32 kPanel = IM_COL32(22, 25, 31, 240);
constexpr ImU32 kPanelEdge = IM_COL32(255, 255, 255, 22);
constexpr ImU32 kText = IM_COL32(236, 239, 244, 255);
constexpr ImU32 kQuiet = IM_COL32(156, 165, 180, 255);
constexpr ImU32 kTrack = IM_COL32(58, 65, 78, 255);
constexpr ImU32 kField = IM_COL32(40, 45, 55, 255);
constexpr ImU32 kFieldHot = IM_COL32(54, 61, 74, 255);
constexpr ImU32 kAccent = IM_COL32(255, 138, 61, 255);
constexpr ImU32 kAccentDeep = IM_COL32(201, 91, 24, 255);
constexpr ImU32 kOnAccent = IM_COL32(28, 16, 8, 255);
constexpr ImU32 kCold = IM_COL32(108, 178, 255, 255);
constexpr ImU32 kWarning = IM_COL32(255, 203, 87, 255);
} // namespace colour

struct Fonts {
    ImFont* body = nullptr;
    ImFont* strong = nullptr;
    ImFont* small = nullptr;
    ImFont* title = nullptr;
};

/// Loads fonts for `scale` (interface size) drawn at `pixelScale` pixels a point. Takes the first of the fonts that the
/// machine has, or Dear ImGui's own. A second font replaces the letters that the first one lacks.
Fonts loadFonts(float scale, float pixelScale);

/// Size that a font was loaded for, pixels; Dear ImGui 1.92 draws it at any size and calls this size LegacySize.
inline float loadedSize(const ImFont& font) {
#if IMGUI_VERSION_NUM >= 19200
    return font.LegacySize;
#else
    return font.FontSize;
#endif
}

/// Sets every colour and measure of Dear ImGui's style.
void applyTheme(float scale);

} // namespace meltpool::ui
