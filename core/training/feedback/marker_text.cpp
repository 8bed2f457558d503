#include "core/training/feedback/marker_text.hpp"

#include "core/scene/stroke_text.hpp"

#include <glm/geometric.hpp>

namespace meltpool {

namespace {

constexpr size_t kMostStrokes = 512;
// In figure heights.
constexpr float kStroke = 0.13F; // width of a stroke
constexpr float kLayer = 0.1F;   // distance of the ground behind the words

} // namespace

MarkerText::MarkerText() {
    strokes_.reserve(kMostStrokes);
}

void MarkerText::add(std::vector<Marker>& markers, std::string_view text, const TextPlane& plane, const glm::vec2& from,
                     const TextInk& ink, const glm::mat4& toWorld) {
    strokes_.clear();
    StrokeTextStyle style;
    style.height = 1;
    appendStrokeText(strokes_, text, from, style);
    constexpr float half = kStroke / 2;
    for (const SectionStroke& stroke : strokes_) {
        const glm::vec2 way = stroke.to - stroke.from;
        const float length = glm::length(way);
        // A stroke without length is a square.
        const glm::vec2 end = (length > 0 ? way / length : glm::vec2(1, 0)) * half;
        markers.push_back(
            {SolidShape::box,
             toWorld * alongLine(plane.at(stroke.from - end), plane.at(stroke.to + end), 2 * half * plane.figure),
             ink.colour, ink.opacity});
    }
}

void MarkerText::addGround(std::vector<Marker>& markers, const TextPlane& plane, const glm::vec2& middle,
                           const glm::vec2& size, const TextInk& ink, const glm::mat4& toWorld) {
    const glm::mat4 ground{glm::vec4(plane.right * (size.x * plane.figure), 0),
                           glm::vec4(plane.up * (size.y * plane.figure), 0),
                           glm::vec4(plane.toEye * (0.5F * kLayer * plane.figure), 0),
                           glm::vec4(plane.at(middle) - plane.toEye * (kLayer * plane.figure), 1)};
    markers.push_back({SolidShape::box, toWorld * ground, ink.colour, ink.opacity});
}

} // namespace meltpool
