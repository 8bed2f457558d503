#include "core/training/feedback/ghost_shapes.hpp"

#include "core/scene/ghost_model.hpp"
#include "core/scene/stroke_text.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace meltpool {

namespace {

constexpr size_t kMostMarkers = 1024;

constexpr glm::vec3 kGround(0.008F, 0.010F, 0.014F);
constexpr float kGroundOpacity = 0.6F, kWordsOpacity = 0.95F;

constexpr float kFigure = 0.017F;      // height of a digit over its distance from the eye
constexpr float kMargin = 0.7F;        // around the words, in digit heights
constexpr float kOverBoard = 0.2F;     // share of the eye's distance: higher than the cues' board
constexpr float kNameGap = 0.01F;      // likewise, between words and name
constexpr float kLift = 20e-3F;        // m before the pool
constexpr float kLargestLift = 0.4F;   // share of the eye's distance
constexpr float kClear = 1.15F;        // room around the pool, in disc radii
constexpr float kClearPerLift = 0.13F; // share of the lift, for eyes off the middle

/// Height of a covered electrode's end above the seam, m, for a path without the electrode's remaining length.
constexpr double kElectrodeOver = 3e-3;
constexpr double kShortestElectrode = 20e-3; // m
/// Least cosine between torch and the seam's normal: a flatter torch has no usable point of its axis on the seam.
constexpr double kFlattest = 0.1;

bool outside(const glm::mat4& toClip, const glm::vec3& point) {
    const glm::vec4 clip = toClip * glm::vec4(point, 1);
    return clip.w <= 0 || std::abs(clip.x) > clip.w || std::abs(clip.y) > clip.w;
}

/// Electrode length that ends above the seam; the path holds the end of a whole electrode.
ArcState arcOf(const GhostMoment& moment, const ProcessSettings& process, const Seam& seam) {
    ArcState arc;
    const double whole = equipmentOf(process).electrodeLength;
    if (whole <= 0) return arc;
    const glm::dvec3 up = seam.at(moment.place).up;
    const double down = std::max(-glm::dot(glm::dvec3(moment.torch.axis()), up), kFlattest);
    const double burnt = std::max((kElectrodeOver - moment.height) / down, 0.0);
    arc.extension = static_cast<float>(std::max(whole - burnt, std::min(kShortestElectrode, whole)));
    return arc;
}

} // namespace

GhostShapes::GhostShapes() {
    markers_.reserve(kMostMarkers);
}

GhostShapes::Page GhostShapes::pageAt(const glm::vec3& pool, const CueEye& eye, float side, float row) {
    Page page;
    const float distance = std::max(glm::distance(eye.position, pool), 1e-3F);
    const float lift = std::min(kLift, kLargestLift * distance);
    TextPlane& plane = page.plane;
    plane.toEye = (eye.position - pool) / distance;
    plane.right = glm::normalize(glm::cross(eye.up, plane.toEye));
    plane.up = glm::cross(plane.toEye, plane.right);
    plane.figure = kFigure * (distance - lift);
    page.side = side;
    page.row = row;
    // Nearer things look farther from the middle, the more so from an eye that is off the middle.
    const float clear = kClear * static_cast<float>(kPoolDisc) * (distance - lift) / distance + kClearPerLift * lift;
    plane.origin = pool + plane.toEye * lift + plane.right * (side * clear) + plane.up * (row * (distance - lift));
    return page;
}

/// The first page of these about a place that is wholly in the picture, else the first of all.
GhostShapes::Page GhostShapes::pageFor(const glm::vec3& place, const CueEye& eye, std::span<const Stand> stands,
                                       float width, float height) {
    const Page first = pageAt(place, eye, stands.front().side, stands.front().row);
    if (!eye.toClip) return first;
    for (const Stand& stand : stands) {
        const Page page = pageAt(place, eye, stand.side, stand.row);
        const auto inside = [&](float x, float y) { return !outside(*eye.toClip, page.plane.at({x, y})); };
        if (inside(stand.side * width, 0) && inside(stand.side * width, height) && inside(0, height)) return page;
    }
    return first;
}

/// Adds the dark ground of a page; `width` and `height`: in digit heights.
void GhostShapes::addGround(const Page& page, float width, float height, float strength, const glm::mat4& toWorld) {
    MarkerText::addGround(markers_, page.plane, {page.side * width / 2, height / 2}, {width, height},
                          {kGround, kGroundOpacity * strength}, toWorld);
}

/// Adds the words beside the pool; returns the height of their upper edge, as a share of the eye's distance.
float GhostShapes::addWords(const GhostWords& words, const glm::vec3& pool, float side, const GhostLook& look,
                            const CueEye& eye, const glm::mat4& toWorld) {
    if (words.lines() == 0) return 0;
    float width = 0;
    for (size_t i = 0; i < words.lines(); ++i)
        width = std::max(width, strokeTextLength(words.line(i), 1));
    width += 2 * kMargin;
    const float height = kMarkerTextLine * static_cast<float>(words.lines()) + kMargin;
    const std::array<Stand, 3> stands{{{side, 0}, {-side, kOverBoard}, {side, kOverBoard}}};
    const bool taken = look.boardSide == side;
    const Page page = pageFor(pool, eye, std::span(stands).subspan(taken ? 1 : 0), width, height);
    const auto strength = static_cast<float>(look.strength);
    addGround(page, width, height, strength, toWorld);
    for (size_t i = 0; i < words.lines(); ++i) {
        const float left = page.side > 0 ? kMargin : kMargin - width;
        const float base = kMargin + kMarkerTextLine * static_cast<float>(words.lines() - 1 - i);
        text_.add(markers_, words.line(i), page.plane, {left, base}, {kGhostColour, kWordsOpacity * strength}, toWorld);
    }
    return page.row + height * kFigure;
}

/// Adds the name beside the ghost's torch, whose end is at `end`. `row`: lowest height of its lower edge, as a share of
/// the eye's distance.
void GhostShapes::addName(const glm::vec3& end, float side, float row, const GhostLook& look, const CueEye& eye,
                          const glm::mat4& toWorld) {
    const float width = strokeTextLength(look.name, 1) + 2 * kMargin, height = kMarkerTextLine + kMargin;
    const float over = std::max(row + kNameGap, kOverBoard);
    const std::array<Stand, 2> stands{{{side, over}, {-side, over}}};
    const Page page = pageFor(end, eye, stands, width, height);
    const auto strength = static_cast<float>(look.strength);
    addGround(page, width, height, strength, toWorld);
    const float left = page.side > 0 ? kMargin : kMargin - width;
    text_.add(markers_, look.name, page.plane, {left, kMargin}, {kGhostColour, kWordsOpacity * strength}, toWorld);
}

std::span<const Marker> GhostShapes::build(const GhostMoment& moment, const GhostWords& words,
                                           const ProcessSettings& process, const Seam& seam, const GhostLook& look,
                                           const CueEye& eye, const glm::mat4& toWorld) {
    markers_.clear();
    if (look.strength <= 0) return markers_;
    const ArcState arc = arcOf(moment, process, seam);
    addGhostTorch(markers_, parts_, moment.torch, process, arc, static_cast<float>(look.strength), look.size, toWorld);
    const SeamFrame frame = seam.at(look.hand.place);
    const glm::vec3 pool(frame.point + frame.across * look.hand.aim);
    const glm::vec3 right = pageAt(pool, eye, 1, 0).plane.right;
    const float ahead = static_cast<float>(look.hand.direction) * glm::dot(glm::vec3(frame.tangent), right);
    const float behind = ahead < -0.1F ? 1.0F : -1.0F;
    const float top = addWords(words, pool, behind, look, eye, toWorld);
    if (look.name.empty()) return markers_;
    const auto whole = static_cast<float>(equipmentOf(process).electrodeLength);
    const float burnt = whole > 0 ? whole - arc.extension : 0;
    addName(moment.torch.tip - moment.torch.axis() * (burnt * look.size), behind, top, look, eye, toWorld);
    return markers_;
}

} // namespace meltpool
