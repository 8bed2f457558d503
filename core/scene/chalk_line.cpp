#include "core/scene/chalk_line.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace meltpool {

namespace {

constexpr glm::vec3 kSoapstone(0.80F, 0.82F, 0.78F);
constexpr float kStroke = 2e-3F;       ///< m, length of a stroke: a weld wipes whole strokes off
constexpr float kWidth = 1.1e-3F;      ///< m, of a sharpened stick's line
constexpr float kSlender = 5;          ///< least length of a single stroke in its widths
constexpr float kOver = 1.25F;         ///< of the length of pieces that lie over their neighbours' ragged ends
constexpr float kLift = 0.1e-3F;       ///< m over the face, whose surface is drawn as fine as its cells
constexpr float kEndMark = 16e-3F;     ///< m, length of the mark across either end
constexpr float kCovered = 8e-3F;      ///< m of it in its middle, which the weld covers
constexpr float kArrow = 8e-3F;        ///< m, length of the arrow
constexpr float kArrowAside = 5.5e-3F; ///< m from the line to the arrow
constexpr float kBarb = 0.4F;          ///< length of a barb along and across the arrow, over the arrow's
/// Widths of strokes that follow one another, in kWidth: a stick on rolled steel leaves no even line.
constexpr std::array<float, 7> kUneven{1.0F, 0.82F, 1.08F, 0.9F, 1.12F, 0.78F, 0.96F};

/// Returns a stroke that lies on a face.
Solid strokeAt(const glm::vec3& middle, const glm::vec3& along, const glm::vec3& up, float length, float width) {
    const glm::mat4 place{glm::vec4(along * length, 0), glm::vec4(up * width, 0),
                          glm::vec4(glm::cross(along, up) * width, 0), glm::vec4(middle + up * kLift, 1)};
    return {SolidShape::chalk, place, kSoapstone, 0.0F};
}

} // namespace

Solid chalkStroke(const glm::vec3& from, const glm::vec3& to, const glm::vec3& normal) {
    const float length = glm::distance(from, to);
    return strokeAt((from + to) / 2.0F, (to - from) / length, normal, length, std::min(kWidth, length / kSlender));
}

std::array<Solid, 3> chalkArrow(const glm::vec3& from, const glm::vec3& along, const glm::vec3& normal, float length) {
    const glm::vec3 tip = from + along * length, aside = glm::cross(normal, along) * (0.6F * kBarb * length);
    const glm::vec3 behind = tip - along * (kBarb * length);
    return {chalkStroke(from, tip, normal), chalkStroke(behind + aside, tip, normal),
            chalkStroke(behind - aside, tip, normal)};
}

ChalkLine::ChalkLine(const ChalkEnds& ends) {
    const glm::vec3 way = ends.to - ends.from;
    const float length = glm::length(way);
    if (!(length > kStroke)) return;
    const glm::vec3 along = way / length, across = glm::cross(along, ends.up);
    const int count = static_cast<int>(std::round(length / kStroke));
    const float part = length / static_cast<float>(count);
    const auto add = [&](const Solid& stroke, float from, float to, bool stays = false) {
        strokes_.push_back({stroke, from, to, stays});
    };
    for (int i = 0; i < count; ++i) {
        const float from = part * static_cast<float>(i);
        const float width = kWidth * kUneven[static_cast<size_t>(i) % kUneven.size()];
        const glm::vec3 drawn = i % 2 == 0 ? along : -along; // no two of them alike
        add(strokeAt(ends.from + along * (from + part / 2), drawn, ends.up, kOver * part, width), from, from + part);
    }
    constexpr float kOuter = (kEndMark - kCovered) / 2;
    for (const float at : {0.0F, length}) {
        const glm::vec3 end = ends.from + along * at;
        add(strokeAt(end, across, ends.up, kOver * kCovered, kWidth), at, at);
        for (const float side : {-1.0F, 1.0F})
            add(strokeAt(end + across * (side * (kCovered + kOuter) / 2), across, ends.up, kOuter, kWidth), at, at,
                true);
    }
    const glm::vec3 aside = across * (glm::dot(across, ends.near) < 0 ? -kArrowAside : kArrowAside);
    for (const Solid& stroke : chalkArrow(ends.from + aside + along * kStroke, along, ends.up, kArrow))
        add(stroke, 0, 0, true);
    shown_.reserve(strokes_.size());
    wipe([](double, double) { return false; });
}

void ChalkLine::wipe(FunctionRef<bool(double from, double to)> welded) {
    shown_.clear();
    for (const Stroke& stroke : strokes_)
        if (stroke.stays || !welded(static_cast<double>(stroke.from), static_cast<double>(stroke.to)))
            shown_.push_back(stroke.solid);
}

} // namespace meltpool
