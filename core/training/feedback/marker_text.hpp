// Words made of markers on a plane that faces the eye, for signs beside the torch in window and headset.
#pragma once

#include "core/render/solids.hpp"
#include "shaders/shared/render.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <string_view>
#include <vector>

namespace meltpool {

inline constexpr float kMarkerTextLine = 1.9F; ///< height of a line, in figure heights

/// A plane that faces the eye, in the markers' frame.
struct TextPlane {
    glm::vec3 origin{0};
    glm::vec3 right{1, 0, 0}; ///< unit vectors
    glm::vec3 up{0, 1, 0};
    glm::vec3 toEye{0, 0, 1};
    float figure = 0; ///< height of a figure

    /// Returns the point at these distances from the origin, in figure heights.
    glm::vec3 at(const glm::vec2& place) const { return origin + (right * place.x + up * place.y) * figure; }
};

/// Look of words, or of the ground behind them.
struct TextInk {
    glm::vec3 colour{1}; ///< linear sRGB
    float opacity = 1;
};

class MarkerText {
  public:
    MarkerText();

    /// Adds a line of text that begins at `from` on its baseline, in figure heights; letters as appendStrokeText() has
    /// them. Allocates nothing for words of usual length, if `markers` has room.
    void add(std::vector<Marker>& markers, std::string_view text, const TextPlane& plane, const glm::vec2& from,
             const TextInk& ink, const glm::mat4& toWorld);

    /// Adds a ground behind the plane, `size` in figure heights, about the place `middle`.
    static void addGround(std::vector<Marker>& markers, const TextPlane& plane, const glm::vec2& middle,
                          const glm::vec2& size, const TextInk& ink, const glm::mat4& toWorld);

  private:
    std::vector<SectionStroke> strokes_;
};

} // namespace meltpool
