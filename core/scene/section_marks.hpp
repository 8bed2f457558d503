// Measures in a section as a drawing has them: lines with ticks at their ends, angles, and figures beside them.
#pragma once

#include "core/render/view.hpp"
#include "shaders/shared/render.h"

#include <string>
#include <vector>

namespace meltpool {

/// One measure. Places are m in the section (z, y).
struct SectionMark {
    enum class Kind {
        length, ///< from `from` to `to`
        angle,  ///< at `from`, between the unit vectors `first` and `second`
        note    ///< its words alone
    };
    enum class Tint { measure, fault, unresolved };

    Kind kind = Kind::length;
    Tint tint = Tint::measure;
    std::string label; ///< such as "throat 4.2", in mm
    glm::vec2 from{0}, to{0};
    glm::vec2 first{1, 0}, second{0, 1};
};

/// How marks stand in the section.
struct MarkLayout {
    glm::vec2 right{-1, 0}; ///< unit vector (z, y) that a reader sees to the right: she looks along -x
    glm::vec2 up{0, 1};     ///< unit vector (z, y) that she sees upwards
    float text = 1.2e-3f;   ///< m, height of a figure
};

/// Upright for whom `up` (in the workpiece's frame) points up; along the workpiece's own y where that is along the
/// seam.
MarkLayout uprightLayout(const glm::vec3& up, float text);

/// Upright in this view of the plane `at` along x, with figures of a fiftieth of the picture's height.
MarkLayout layoutIn(const View& view, const glm::mat4& modelToWorld, float at);

/// Adds the strokes of the marks: each line at its place, the words in a column on either side of all of them, a thin
/// line from each word to what it names. What comes later lies over what comes before.
void layOutMarks(const std::vector<SectionMark>& marks, const MarkLayout& layout, std::vector<SectionStroke>& strokes);

} // namespace meltpool
