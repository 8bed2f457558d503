// Words and figures made of straight strokes, for measures that are drawn into a section: identical in pictures without
// a screen, in the window and in both eyes.
#pragma once

#include "shaders/shared/render.h"

#include <string_view>
#include <vector>

namespace meltpool {

/// Position and style of a line of text in the section's plane.
struct StrokeTextStyle {
    glm::vec2 right{1, 0};  ///< unit vector along the line
    glm::vec2 up{0, 1};     ///< unit vector from the baseline upwards
    float height = 1e-3f;   ///< height of a figure, model units
    glm::vec4 colour{1.0f}; ///< linear sRGB, cover
};

/// Returns the length of a line of text of this height.
float strokeTextLength(std::string_view text, float height);

/// Adds the strokes of a line of text that begins at `origin`, on its baseline. It has small letters with those of
/// German, figures and the signs ". , - / <" and the degree sign (UTF-8); capitals are drawn small, anything else is
/// left out as a space.
void appendStrokeText(std::vector<SectionStroke>& strokes, std::string_view text, glm::vec2 origin,
                      const StrokeTextStyle& style);

} // namespace meltpool
