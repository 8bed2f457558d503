// A soapstone line on a plate: where to weld, with a mark across it at either end and an arrow in the direction of
// travel beside the first. It is on the piece, as a welder draws it, and no cue.
#pragma once

#include "core/base/function_ref.hpp"
#include "core/render/solid.hpp"

#include <glm/vec3.hpp>

#include <array>
#include <span>
#include <vector>

namespace meltpool {

/// Ends of the line on the plate's face, workpiece frame, m.
struct ChalkEnds {
    glm::vec3 from{0};
    glm::vec3 to{0};
    glm::vec3 up{0, 1, 0};   ///< unit vector out of the face
    glm::vec3 near{0, 0, 1}; ///< to the welder's side, where the arrow is
};

/// One stroke of soapstone from place to place on a face with this normal, m.
Solid chalkStroke(const glm::vec3& from, const glm::vec3& to, const glm::vec3& normal);

/// An arrow of soapstone on a face with this normal: shaft and two barbs. `along`: unit vector of its direction, in the
/// face; `length`: m.
std::array<Solid, 3> chalkArrow(const glm::vec3& from, const glm::vec3& along, const glm::vec3& normal, float length);

class ChalkLine {
  public:
    explicit ChalkLine(const ChalkEnds& ends);

    /// Wipes the strokes off whose part of the line is `welded`, which takes ways (m) from the line's first end. The
    /// others are there again.
    void wipe(FunctionRef<bool(double from, double to)> welded);
    /// Strokes that are left, placed in the workpiece's frame.
    std::span<const Solid> solids() const { return shown_; }

  private:
    /// One stroke with its way along the line, m.
    struct Stroke {
        Solid solid;
        float from = 0, to = 0;
        bool stays = false; ///< beside every weld on the line
    };
    std::vector<Stroke> strokes_;
    std::vector<Solid> shown_;
};

} // namespace meltpool
