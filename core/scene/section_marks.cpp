#include "core/scene/section_marks.hpp"

#include "core/scene/stroke_text.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace meltpool {

namespace {

constexpr glm::vec4 kMeasure(0.12f, 0.85f, 1.0f, 1.0f); // a colour unlike any glow or temper colour
constexpr glm::vec4 kFault(1.0f, 0.13f, 0.06f, 1.0f);
constexpr glm::vec4 kUnresolved(0.60f, 0.60f, 0.60f, 1.0f);
constexpr glm::vec4 kGround(0.004f, 0.005f, 0.007f, 0.8f); ///< background of words, and border of lines
constexpr float kLine = 0.13f;                             ///< width of a measure's line, in heights of a figure
constexpr float kLeader = 0.06f;
constexpr float kTick = 0.9f;       ///< length of the ticks at a line's ends, likewise
constexpr float kRow = 2.3f;        ///< distance between lines of text, likewise
constexpr float kColumnGap = 1.6f;  ///< gap between the measures and the words, likewise
constexpr float kAngleReach = 2.6f; ///< radius of an angle's arc, likewise
constexpr int kArcPieces = 10;

glm::vec4 colourOf(SectionMark::Tint tint) {
    if (tint == SectionMark::Tint::fault) return kFault;
    return tint == SectionMark::Tint::unresolved ? kUnresolved : kMeasure;
}

/// Returns the place of a mark that its words point to.
glm::vec2 middleOf(const SectionMark& mark, float text) {
    if (mark.kind == SectionMark::Kind::length) return 0.5f * (mark.from + mark.to);
    const glm::vec2 between = mark.first + mark.second;
    const float length = glm::length(between);
    return mark.from + (length > 1e-3f ? between / length : mark.first) * kAngleReach * text;
}

class Draughtsman {
  public:
    Draughtsman(const MarkLayout& layout, std::vector<SectionStroke>& strokes) : layout_(layout), strokes_(strokes) {}

    void draw(const std::vector<SectionMark>& marks) {
        for (const SectionMark& mark : marks) {
            if (mark.kind == SectionMark::Kind::length) drawLength(mark);
            if (mark.kind == SectionMark::Kind::angle) drawAngle(mark);
        }
        drawWords(marks);
    }

  private:
    void stroke(glm::vec2 from, glm::vec2 to, float width, glm::vec4 colour) {
        strokes_.push_back({from, to, colour, width * layout_.text, 0, glm::vec2(0)});
    }

    /// Adds a line that is visible on bright and dark metal.
    void line(glm::vec2 from, glm::vec2 to, glm::vec4 colour) {
        stroke(from, to, 2.2f * kLine, kGround);
        stroke(from, to, kLine, colour);
    }

    void drawLength(const SectionMark& mark) {
        const glm::vec2 way = mark.to - mark.from;
        const float length = glm::length(way);
        if (length <= 0) return;
        const glm::vec4 colour = colourOf(mark.tint);
        const glm::vec2 side = glm::vec2(-way.y, way.x) / length * (0.5f * kTick * layout_.text);
        for (const glm::vec2 end : {mark.from, mark.to})
            line(end - side, end + side, colour);
        line(mark.from, mark.to, colour);
    }

    void drawAngle(const SectionMark& mark) {
        const float reach = kAngleReach * layout_.text;
        const float begin = std::atan2(mark.first.y, mark.first.x);
        const float sweep = std::remainder(std::atan2(mark.second.y, mark.second.x) - begin, 6.2831853f);
        const glm::vec4 colour = colourOf(mark.tint);
        glm::vec2 last = mark.from + reach * mark.first;
        line(mark.from, mark.from + 1.25f * reach * mark.second, colour);
        for (int i = 1; i <= kArcPieces; ++i) {
            const float angle = begin + sweep * static_cast<float>(i) / kArcPieces;
            const glm::vec2 next = mark.from + reach * glm::vec2(std::cos(angle), std::sin(angle));
            stroke(last, next, kLine, colour);
            last = next;
        }
    }

    float along(glm::vec2 place) const { return glm::dot(place, layout_.right); }
    float upwards(glm::vec2 place) const { return glm::dot(place, layout_.up); }
    glm::vec2 inPlane(float u, float v) const { return u * layout_.right + v * layout_.up; }

    /// Finds the least and the greatest of all marks' ends, along the text and upwards.
    void enclose(const std::vector<SectionMark>& marks) {
        constexpr float kFar = std::numeric_limits<float>::max();
        low_ = glm::vec2(kFar);
        high_ = glm::vec2(-kFar);
        for (const SectionMark& mark : marks) {
            if (mark.kind == SectionMark::Kind::note) continue;
            const glm::vec2 other = mark.kind == SectionMark::Kind::length ? mark.to : middleOf(mark, layout_.text);
            for (const glm::vec2 place : {mark.from, other}) {
                low_ = glm::min(low_, glm::vec2(along(place), upwards(place)));
                high_ = glm::max(high_, glm::vec2(along(place), upwards(place)));
            }
        }
        if (low_.x > high_.x) low_ = high_ = glm::vec2(0);
    }

    /// Draws the words; half of the marks, those farther left, have them on the left.
    void drawWords(const std::vector<SectionMark>& marks) {
        enclose(marks);
        std::vector<const SectionMark*> order;
        for (const SectionMark& mark : marks)
            order.push_back(&mark);
        const auto place = [&](const SectionMark* mark) { return along(middleOf(*mark, layout_.text)); };
        std::stable_sort(order.begin(), order.end(),
                         [&](const SectionMark* a, const SectionMark* b) { return place(a) < place(b); });
        const auto half = order.begin() + static_cast<std::ptrdiff_t>(order.size() / 2);
        drawColumn({order.begin(), half}, true);
        drawColumn({half, order.end()}, false);
    }

    void drawColumn(std::vector<const SectionMark*> marks, bool left) {
        const auto height = [&](const SectionMark* mark) { return upwards(middleOf(*mark, layout_.text)); };
        std::stable_sort(marks.begin(), marks.end(),
                         [&](const SectionMark* a, const SectionMark* b) { return height(a) > height(b); });
        const float row = kRow * layout_.text, gap = kColumnGap * layout_.text;
        float v = 0.5f * (low_.y + high_.y) + 0.5f * row * static_cast<float>(marks.size()) - 0.5f * row;
        for (const SectionMark* mark : marks) {
            const float length = strokeTextLength(mark->label, layout_.text);
            drawWord(*mark, left ? low_.x - gap - length : high_.x + gap, v, length, left);
            v -= row;
        }
    }

    /// Draws words. `u`, `v`: their left end, and the middle of their height.
    void drawWord(const SectionMark& mark, float u, float v, float length, bool left) {
        const float text = layout_.text;
        const glm::vec4 colour = colourOf(mark.tint);
        if (mark.kind != SectionMark::Kind::note) {
            const float edge = left ? u + length + 0.7f * text : u - 0.7f * text;
            stroke(inPlane(edge, v), middleOf(mark, text), kLeader, glm::vec4(glm::vec3(colour), 0.75f));
        }
        stroke(inPlane(u, v), inPlane(u + length, v), 1.75f, kGround);
        appendStrokeText(strokes_, mark.label, inPlane(u, v - 0.5f * text), {layout_.right, layout_.up, text, colour});
    }

    MarkLayout layout_;
    std::vector<SectionStroke>& strokes_;
    glm::vec2 low_{0}, high_{0};
};

} // namespace

MarkLayout uprightLayout(const glm::vec3& up, float text) {
    constexpr float kLeast = 0.2f; // length of `up` in the plane
    MarkLayout layout;
    layout.text = text;
    const glm::vec2 inPlane(up.z, up.y);
    if (glm::length(inPlane) > kLeast * glm::length(up)) layout.up = glm::normalize(inPlane);
    layout.right = {-layout.up.y, layout.up.x};
    return layout;
}

MarkLayout layoutIn(const View& view, const glm::mat4& modelToWorld, float at) {
    constexpr float kShare = 0.02f; // share of the picture's height
    const glm::mat3 toEye = glm::mat3(view.worldToEye) * glm::mat3(modelToWorld);
    const glm::vec4 middle = view.worldToEye * modelToWorld * glm::vec4(at, 0, 0, 1);
    const float height = 2 * std::max(-middle.z, 0.0f) / view.eyeToClip[1][1]; // height of the picture, at the plane
    const glm::vec3 up = glm::transpose(toEye) * glm::vec3(0, 1, 0);
    return uprightLayout(up, kShare * height / glm::length(glm::vec3(modelToWorld[0])));
}

void layOutMarks(const std::vector<SectionMark>& marks, const MarkLayout& layout, std::vector<SectionStroke>& strokes) {
    if (!marks.empty()) Draughtsman(layout, strokes).draw(marks);
}

} // namespace meltpool
