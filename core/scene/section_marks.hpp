// Measures in a section as in a drawing: lines with ticks at their ends, angles, and figures next to them.
#pragma once

#include "core/render/view.hpp"
#include "shaders/shared/render.h"

#include <string>
#include <vector>

namespace meltpool {

/// One measure. Places are m in the section (z, y).
struct SectionMark {
    enum class Kind {
        length, ///< line from `from` to `to`
        angle,  ///< angle at `from`, between the unit vectors `first` and `second`
        note    ///< words alone
    };
    enum class Tint { measure, fault, unresolved };

    Kind kind = Kind::length;
    Tint tint = Tint::measure;
    std::string label; ///< label such as "throat 4.2", in mm
    glm::vec2 from{0}, to{0};
    glm::vec2 first{1, 0}, second{0, 1};
};

/// Layout of marks in the section.
struct MarkLayout {
    glm::vec2 right{-1, 0}; ///< unit vector (z, y) to the reader's right, who looks along -x
    glm::vec2 up{0, 1};     ///< unit vector (z, y) upwards for the reader
    float text = 1.2e-3f;   ///< m, height of a figure
};

/// Returns a layout upright for a reader whose `up` (in the workpiece's frame) this is; along the workpiece's own y if
/// `up` is along the seam.
MarkLayout uprightLayout(const glm::vec3& up, float text);

/// Returns a layout upright in this view of the plane `at` along x, with figures of a fiftieth of the picture's height.
MarkLayout layoutIn(const View& view, const glm::mat4& modelToWorld, float at);

/// Adds the strokes of the marks: each line at its place, the words in a column on either side of all of them, a thin
/// line from each word to its mark. Later ones cover earlier ones.
void layOutMarks(const std::vector<SectionMark>& marks, const MarkLayout& layout, std::vector<SectionStroke>& strokes);

} // namespace meltpool
