#include "app/headset/headset_notice.hpp"

#include "core/base/short_text.hpp"
#include "core/base/words.hpp"
#include "core/training/feedback/cue_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

namespace meltpool {

namespace {

constexpr size_t kMostWarnings = 3;
constexpr size_t kLongestLine = 240; // bytes; the window shows longer messages whole
constexpr float kLooksThere = 0.85f; // cosine: within 32 degrees of the head's direction
constexpr float kNearest = 0.1f;     // m, least distance for which the size is right
constexpr float kPanelHalf = 0.37f;  // m from the panel's middle to its lower edge
constexpr float kPanelSide = 0.30f;  // m from its middle to its sides
constexpr float kAhead = 0.6f;       // m before the eyes, if the torch is out of sight
constexpr float kAboveBoard = 0.02f; // share of the eyes' distance: from the cues' board to the notice's lower edge
constexpr double kFollowing = 0.15;  // s

float widthAt(float distance) {
    return 2 * std::max(distance, kNearest) * std::tan(NoticePlace::kAngle / 2);
}

float heightOf(float width) {
    constexpr xr::PanelShape kShape = HeadsetNotice::kShape;
    return width * static_cast<float>(kShape.heightPixels) / static_cast<float>(kShape.widthPixels);
}

/// Returns the place along the panel's width (m from its middle) that the head is turned to, or its nearer edge.
float turnedTo(const xr::Pose& head, const xr::Pose& panel) {
    const xr::Pose inPanel = panel.inverse() * head;
    const glm::vec3 way = inPanel.forward();
    const float ahead = way.z < -1e-3f ? -inPanel.position.z / way.z : 0;
    return std::clamp(inPanel.position.x + way.x * ahead, -kPanelSide, kPanelSide);
}

bool looksAt(const xr::Pose& head, const glm::vec3& place) {
    return glm::dot(glm::normalize(place - head.position), head.forward()) > kLooksThere;
}

/// Returns the text's beginning that ends with a sentence and fits into a line of the notice; else cut after a word.
std::string_view wholeSentences(std::string_view text) {
    if (text.size() <= kLongestLine) return text;
    const std::string_view head = text.substr(0, kLongestLine);
    for (const std::string_view end : {". ", " "})
        if (const size_t at = head.rfind(end); at != std::string_view::npos)
            return head.substr(0, at + (end.size() > 1 ? 1 : 0));
    return {};
}

} // namespace

void NoticeText::addLine(std::string_view line) {
    const size_t fits = std::min(line.size(), kLongestLine);
    if (length_ + fits + 1 > text_.size()) return;
    std::memcpy(text_.data() + length_, line.data(), fits);
    length_ += fits;
    text_[length_++] = '\n';
}

void NoticeText::compose(const Messages& messages, const LessonFigures& figures, float zoom, std::string_view task,
                         std::span<const std::string_view> way) {
    length_ = 0;
    const auto warns = [](const Message& m) { return m.topic == kDeskTopic || m.kind == Message::Kind::warning; };
    auto left = static_cast<size_t>(std::count_if(messages.shown().begin(), messages.shown().end(), warns));
    for (const Message& message : messages.shown())
        if (warns(message) && left-- <= kMostWarnings) addLine(message.text);
    quietFrom_ = length_;
    for (const std::string_view line : way)
        addLine(line);
    if (quietFrom_ == 0 && !task.empty()) addLine(wholeSentences(task));
    // Slow metal warns by a sentence with advice at first; its figure stays, where it covers no torch.
    const auto isSlow = [](const Message& m) { return m.topic == kSlowTopic; };
    if (!figures.slow.empty() && std::none_of(messages.shown().begin(), messages.shown().end(), isSlow))
        addLine(figures.slow);
    if (!figures.caption.empty()) addLine(figures.caption);
    if (zoom == 1) return;
    std::array<char, 16> times{};
    std::snprintf(times.data(), times.size(), "%.3g", static_cast<double>(zoom));
    ShortText line;
    appendPhrase(line, "headset.notice.zoom", {{"zoom", withDecimalMark(times.data())}});
    addLine(line);
}

bool faces(const xr::Pose& head, const glm::vec3& place) {
    constexpr float kSeesIt = 0.82f; // cosine of 35 degrees
    return glm::dot(glm::normalize(place - head.position), head.forward()) > kSeesIt;
}

std::string_view wayToWork(const xr::Pose& head, const glm::vec3& work) {
    if (faces(head, work)) return {};
    const glm::vec3 way = work - head.position;
    const float rise = way.y / glm::length(way);
    if (rise < -0.3f) return phrase("headset.notice.look_down");
    return phrase(rise > 0.3f ? "headset.notice.look_up" : "headset.notice.look_ahead");
}

void NoticePlace::update(bool atTorch, const xr::Pose& head, const std::optional<glm::vec3>& tip, float tableHeight,
                         double elapsed, const std::optional<xr::Pose>& panel) {
    end_ = tip.value_or(end_);
    if (!atTorch) {
        pose_ = {glm::angleAxis(-1.0f, glm::vec3(1, 0, 0)), {0, tableHeight + 0.06f, 0.22f}};
        width_ = widthAt(glm::distance(head.position, pose_.position));
        known_ = false;
        return;
    }
    if (panel && looksAt(head, panel->position)) {
        width_ = widthAt(glm::distance(head.position, panel->position));
        position_ = *panel * glm::vec3(turnedTo(head, *panel), -kPanelHalf - heightOf(width_) / 2, 0);
        pose_ = {panel->orientation, position_};
        known_ = true;
        return;
    }
    const bool seen = tip && looksAt(head, *tip);
    const glm::vec3 target = seen ? *tip : head.position + head.forward() * kAhead;
    const glm::vec3 back = glm::normalize(head.position - target);
    const glm::vec3 right = glm::normalize(glm::cross(head.orientation * glm::vec3(0, 1, 0), back));
    const glm::vec3 up = glm::cross(back, right);
    const float distance = glm::distance(head.position, target);
    const float aboveTip = (kCueBoardHeight + kAboveBoard) * distance;
    const float raise = seen ? aboveTip + heightOf(widthAt(distance)) / 2 : -0.1f;
    const glm::vec3 there = target + up * raise;
    const auto share = static_cast<float>(known_ ? 1 - std::exp(-elapsed / kFollowing) : 1.0);
    position_ += (there - position_) * share;
    known_ = true;
    pose_ = {glm::quat_cast(glm::mat3(right, up, back)), position_};
    width_ = widthAt(distance);
}

bool HeadsetNotice::draw(const xr::Panel& picture, int opening, bool dimmed, double elapsed) {
    if (opening_ == opening && dimmed_ == dimmed && drawn_.text() == text.text()) return false;
    drawn_ = text;
    opening_ = opening;
    dimmed_ = dimmed;
    if (panel_ == nullptr)
        panel_ = std::make_unique<HeadsetPanel>(kShape.widthPixels, kShape.heightPixels, HeadsetPanel::Ground::clear,
                                                kTextScale);
    panel_->draw(picture.framebuffer(), {}, elapsed, [&](ui::Context& context) { drawText(context); });
    return true;
}

/// Draws the text at the picture's lower edge, in a box of the text's height.
void HeadsetNotice::drawText(ui::Context& context) const {
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float pad = context.points(8), inner = screen.x - 4 * pad;
    const auto height = [&](std::string_view part) {
        if (part.empty()) return 0.0f;
        return ImGui::CalcTextSize(part.data(), part.data() + part.size() - 1, false, inner).y;
    };
    const std::string_view warnings = drawn_.warnings(), quiet = drawn_.quiet();
    const float first = height(warnings), second = height(quiet);
    const float top = std::max(screen.y - first - second - 3 * pad, 0.0f);
    const ImVec2 corner{pad, top}, end{screen.x - pad, screen.y - pad / 2};
    const auto add = [&](std::string_view part, float y, ImU32 colour) {
        if (!part.empty())
            draw->AddText(nullptr, 0, {2 * pad, y}, colour, part.data(), part.data() + part.size() - 1, inner);
    };
    ui::fillRounded(*draw, corner, end, IM_COL32(22, 25, 31, warnings.empty() ? 150 : 225), context.points(6));
    if (!warnings.empty()) ui::fillRounded(*draw, corner, {corner.x + pad / 2, end.y}, ui::colour::kWarning, 0);
    add(warnings, top + pad, ui::colour::kText);
    add(quiet, top + pad + first, warnings.empty() ? ui::colour::kText : ui::colour::kQuiet);
    // Bright letters would outshine the pool behind a dark filter.
    if (dimmed_) ui::fillRounded(*draw, corner, end, IM_COL32(0, 0, 0, 150), context.points(6));
}

} // namespace meltpool
