#include "core/training/feedback/cue_shapes.hpp"

#include "core/render/line_of_sight.hpp"
#include "core/scene/stroke_text.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace meltpool {

namespace {

constexpr size_t kMostMarkers = 512; // names have a marker for each stroke of a letter
// Linear sRGB. Every eye distinguishes blue from vermilion; the mark's place says as much as its colour.
constexpr glm::vec3 kGround(0.008F, 0.010F, 0.014F);
constexpr glm::vec3 kTrack(0.04F, 0.05F, 0.06F);
constexpr glm::vec3 kBand(0.22F, 0.27F, 0.30F);
constexpr glm::vec3 kInside(0.42F, 0.78F, 0.90F);
constexpr glm::vec3 kBetween(1.0F, 0.52F, 0.03F);
constexpr glm::vec3 kBeyond(0.95F, 0.07F, 0.02F);
constexpr glm::vec3 kDash(0.42F, 0.78F, 0.90F);
constexpr double kGroundOpacity = 0.6, kBandOpacity = 0.85;

// Shape of the torch that a board avoids: thick from a little behind its tip on, m.
constexpr float kTorchFrom = 4e-3F, kTorchTo = 0.1F, kTorchRadius = 9e-3F;
constexpr int kTorchParts = 12;

constexpr float kCell = kCueBoardHeight / 2; // edge of a field over its distance from the eye
constexpr float kTile = 0.96F;               // share of a field's edge
constexpr float kHalfBar = 0.36F;            // share of a field's edge
constexpr float kBarWidth = 0.2F;            // share of a field's edge
constexpr float kLayer = 0.01F;              // share of a field's edge: distance between shapes on top of one another
constexpr float kNameFigure = 0.24F;         // share of a field's edge: largest height of a figure in a name
constexpr float kNameMargin = 0.4F;          // beside and below a name, in figure heights
constexpr glm::vec3 kNameColour(0.75F, 0.80F, 0.84F);
constexpr float kFarthest = 1.15F;     // place of a mark beyond the band, in half bars
constexpr float kLift = 20e-3F;        // distance of the board before the pool, m
constexpr float kLargestLift = 0.4F;   // share of the eye's distance
constexpr float kClear = 1.15F;        // room between board and pool, in disc radii
constexpr float kClearPerLift = 0.13F; // share of the lift: half the distance between the eyes over their distance from
                                       // the pool

constexpr double kDashLength = 2.5e-3, kDashPeriod = 4e-3; // m
constexpr int kDashes = 6;
constexpr double kDashStart = kPoolDisc + 2e-3;
constexpr float kDashGround = 2;     // width of the dark ground, in dash widths
constexpr float kBesideDisc = 1.05F; // distance in disc radii; a chord between two points outside may cross the disc
constexpr double kDashLift = 0.8e-3; // m above the seam
constexpr float kDashWidth = 4e-3F, kThinnest = 0.4e-3F, kThickest = 1.6e-3F; // share of the eye's distance; m

const glm::vec3& colourOf(BandZone zone) {
    return zone == BandZone::inside ? kInside : zone == BandZone::between ? kBetween : kBeyond;
}

glm::mat4 placed(const glm::vec3& middle, const glm::vec3& x, const glm::vec3& y, const glm::vec3& z) {
    return {glm::vec4(x, 0), glm::vec4(y, 0), glm::vec4(z, 0), glm::vec4(middle, 1)};
}

/// True if the block is between eye and point.
bool hides(const WorkpieceBlock& block, const glm::vec3& eye, const glm::vec3& point) {
    float first = 0, last = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const float way = point[axis] - eye[axis];
        const float inverse = 1 / (std::abs(way) < 1e-9F ? 1e-9F : way);
        const float a = (block.low[axis] - eye[axis]) * inverse, b = (block.high[axis] - eye[axis]) * inverse;
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
    }
    return first < last;
}

/// True beyond the edges of the picture, or behind the eye.
bool outside(const glm::vec4& clip) {
    return clip.w <= 0 || std::abs(clip.x) > clip.w || std::abs(clip.y) > clip.w;
}

/// True if, as the eye sees it, the point is before or behind a torch that points at `pool`.
bool besideTorch(const glm::vec3& pool, const glm::vec3& axis, const glm::vec3& eye, const glm::vec3& point) {
    const glm::vec3 way = glm::normalize(point - eye);
    for (int i = 0; i <= kTorchParts; ++i) {
        const float back = glm::mix(kTorchFrom, kTorchTo, static_cast<float>(i) / kTorchParts);
        const glm::vec3 from = pool - axis * (back + kTorchRadius) - eye;
        if (glm::length(from - way * glm::dot(from, way)) < kTorchRadius) return true;
    }
    return false;
}

} // namespace

bool coversDisc(const glm::vec3& eye, const glm::vec3& point, const glm::vec3& centre, const glm::vec3& normal,
                float radius) {
    const glm::vec3 way = point - eye;
    const float down = glm::dot(way, normal);
    if (std::abs(down) < 1e-9F) return false;
    const float share = glm::dot(centre - eye, normal) / down;
    if (share < 1) return false; // the disc is before the point, or behind the eye
    return glm::distance(eye + way * share, centre) < radius;
}

glm::vec3 CueShapes::Board::shown(const glm::vec3& direction, const glm::vec3& otherwise) const {
    const glm::vec3 flat = right * glm::dot(direction, right) + up * glm::dot(direction, up);
    const float length = glm::length(flat);
    return length > 0.05F ? flat / length : otherwise;
}

CueShapes::CueShapes() {
    markers_.reserve(kMostMarkers);
}

// All names have the size at which the longest is as wide as its field.
void CueShapes::setNames(const CueNames& names) {
    names_ = names;
    float longest = 0;
    for (const CueWords& words : names)
        for (const std::string_view word : {words.name, words.less, words.more})
            longest = std::max(longest, strokeTextLength(word, 1));
    nameFigure_ = longest > 0 ? std::min(kNameFigure, kTile / (longest + 2 * kNameMargin)) : 0;
}

void CueShapes::add(SolidShape shape, const glm::mat4& place, const glm::vec3& colour, double opacity) {
    markers_.push_back({shape, toWorld_ * place, colour, static_cast<float>(opacity)});
}

CueShapes::Board CueShapes::boardAt(const Stand& stand, const glm::vec3& pool, const CueEye& eye) {
    Board board;
    const float distance = std::max(glm::distance(eye.position, pool), 1e-3F);
    const float lift = std::min(kLift * stand.lift, kLargestLift * distance);
    board.toEye = (eye.position - pool) / distance;
    board.right = glm::normalize(glm::cross(eye.up, board.toEye));
    board.up = glm::cross(board.toEye, board.right);
    board.outwards = board.right * stand.side;
    board.cell = kCell * (distance - lift);
    // Nearer things look farther from the middle, the more so from an eye that is off the middle.
    const float clear = kClear * static_cast<float>(kPoolDisc) * (distance - lift) / distance + kClearPerLift * lift;
    board.origin = pool + board.toEye * lift + board.outwards * clear + board.up * (stand.row * board.cell);
    return board;
}

bool CueShapes::behindHands(const glm::vec3& point, const CueEye& eye) const {
    if (eye.hands.empty()) return false;
    const glm::vec3 from = toWorld_ * glm::vec4(eye.position, 1), to = toWorld_ * glm::vec4(point, 1);
    return std::any_of(eye.hands.begin(), eye.hands.end(),
                       [&](const Solid& solid) { return standsBefore(solid, from, to, 0); });
}

/// True if workpiece, table or hands are between the eye and the point.
bool CueShapes::hidden(const glm::vec3& point, const CueEye& eye, std::span<const WorkpieceBlock> blocks) const {
    if (eye.table && glm::dot(glm::vec3(*eye.table), point) < eye.table->w) return true;
    if (std::any_of(blocks.begin(), blocks.end(),
                    [&](const WorkpieceBlock& block) { return hides(block, eye.position, point); }))
        return true;
    return behindHands(point, eye);
}

/// How badly a board is placed: hidden, outside the picture, or before or behind the torch; 0: fully visible. Counts no
/// further than to `enough`, as most of the time goes into the hands' many solids.
int CueShapes::badness(const Board& board, const CuePose& pose, const glm::vec3& pool, const CueEye& eye,
                       std::span<const WorkpieceBlock> blocks, int enough) const {
    constexpr int kHidden = 4, kOutside = 2, kAtTorch = 1;
    int sum = 0;
    const float low = -kMarkerTextLine * nameFigure_, high = 2 - low; // with the names
    for (const auto& [column, row] : {std::pair(0.0F, low), {2.0F, low}, {1.0F, 1.0F}, {0.0F, high}, {2.0F, high}}) {
        const glm::vec3 point = board.field(column, row);
        if (besideTorch(pool, pose.axis, eye.position, point)) sum += kAtTorch;
        if (eye.toClip && outside(*eye.toClip * glm::vec4(point, 1))) sum += kOutside;
        if (sum < enough && hidden(point, eye, blocks)) sum += kHidden;
    }
    // A handle is thin enough to lie between these corners.
    for (const auto& [column, row] : {std::pair(0.5F, 0.5F), {0.5F, 1.5F}, {1.5F, 0.5F}, {1.5F, 1.5F}})
        if (sum < enough && behindHands(board.field(column, row), eye)) sum += kHidden;
    return sum;
}

/// The last board's place while none is better, else the first of the best.
CueShapes::Board CueShapes::boardFor(const CuePose& pose, const SeamFrame& frame, const glm::vec3& pool,
                                     const CueEye& eye, std::span<const WorkpieceBlock> blocks) {
    const glm::vec3 right = boardAt({}, pool, eye).right;
    const float ahead = static_cast<float>(pose.direction) * glm::dot(glm::vec3(frame.tangent), right);
    const float wanted = std::abs(ahead) > 0.1F ? std::copysign(1.0F, ahead) : wanted_ != 0 ? wanted_ : 1;
    constexpr int kWorst = 1000;
    int least = kWorst;
    const auto consider = [&](const Stand& stand) {
        if (least == 0) return;
        const int bad = badness(boardAt(stand, pool, eye), pose, pool, eye, blocks, least);
        if (bad < least) stand_ = stand;
        least = std::min(least, bad);
    };
    if (std::exchange(wanted_, wanted) == wanted) consider(Stand(stand_));
    for (const float lift : {1.0F, 1.75F, 2.75F})
        for (const float side : {wanted, -wanted})
            for (const float row : {0.0F, -1.0F, -2.0F})
                consider({side, row, lift});
    return boardAt(stand_, pool, eye);
}

/// Adds the dark ground of a field, and its name.
void CueShapes::addTile(const Board& board, const glm::vec3& middle, const Cue& cue, double opacity) {
    const float edge = kTile * board.cell;
    const bool above = glm::dot(middle - board.origin, board.up) > board.cell;
    const glm::vec3 place = middle + board.up * (above ? 0.5F * edge : -0.5F * edge);
    const glm::vec3 end = place + board.right * (0.5F * edge);
    labels_[labelCount_++] = {
        cue.kind, glm::vec3(toWorld_ * glm::vec4(place, 1)),          glm::vec3(toWorld_ * glm::vec4(end, 1)), above,
        opacity,  cue.zone == BandZone::beyond ? cue.correction() : 0};
    add(SolidShape::box,
        placed(middle - board.toEye * (2 * kLayer * board.cell), board.right * edge, board.up * edge,
               board.toEye * (kLayer * board.cell)),
        kGround, kGroundOpacity * opacity);
    addName(board, labels_[labelCount_ - 1], place);
}

/// Adds a field's name, or what the hand has to do, beyond the middle of its outer edge.
void CueShapes::addName(const Board& board, const CueLabel& label, const glm::vec3& edge) {
    const CueWords& words = names_[static_cast<size_t>(label.kind)];
    const std::string_view word = words.shown(label.correction);
    if (word.empty()) return;
    const TextPlane plane{edge, board.right, board.up, board.toEye, nameFigure_ * board.cell};
    const float width = kTile / nameFigure_, length = strokeTextLength(word, 1);
    const float low = label.above ? 0 : -kMarkerTextLine;
    const auto cover = static_cast<float>(label.opacity);
    MarkerText::addGround(markers_, plane, {0, low + kMarkerTextLine / 2}, {width, kMarkerTextLine},
                          {kGround, static_cast<float>(kGroundOpacity) * cover}, toWorld_);
    text_.add(markers_, word, plane, {-length / 2, low + kNameMargin},
              {word == words.name ? kNameColour : kBeyond, cover}, toWorld_);
}

/// Adds the ground of a bar, the inner band on it, the line of the ideal and the mark; `along` is a unit vector.
void CueShapes::addBar(const Board& board, const Cue& cue, const glm::vec3& middle, const glm::vec3& along) {
    const float cell = board.cell, half = kHalfBar * cell, width = kBarWidth * cell;
    const glm::vec3 across = glm::cross(board.toEye, along), thick = board.toEye * (kLayer * cell);
    const auto box = [&](float at, float length, float breadth, float layer, const glm::vec3& colour, double opacity) {
        add(SolidShape::box,
            placed(middle + along * at + thick * layer, along * length, across * breadth, thick * 0.5F), colour,
            opacity * cue.opacity);
    };
    const auto inner = static_cast<float>(std::min(cue.inner, 1.0));
    addTile(board, middle, cue, cue.opacity);
    box(0, 2 * half, width, 0, kTrack, kBandOpacity);
    box(0, std::max(2 * half * inner, 0.05F * cell), width, 1, kBand, kBandOpacity);
    const float at = half * std::clamp(static_cast<float>(cue.share), -kFarthest, kFarthest);
    const glm::vec3& colour = colourOf(cue.zone);
    const glm::vec3 place = middle + along * at + board.toEye * (0.12F * cell);
    switch (cue.kind) {
    case CueKind::speed: // an arrow in the torch's direction of travel
        add(SolidShape::cone, alongLine(place - along * (0.17F * cell), place + along * (0.17F * cell), 0.3F * cell),
            colour, cue.opacity);
        break;
    case CueKind::distance: // the torch's end above the metal
        box(-half, 0.05F * cell, 0.5F * cell, 2, kInside, kBandOpacity);
        box(at, 0.11F * cell, 0.46F * cell, 3, colour, 1);
        break;
    default: // aim: the seam, and the point that the torch aims at
        box(0, 0.04F * cell, 0.5F * cell, 2, kInside, kBandOpacity);
        add(SolidShape::sphere,
            placed(place, board.right * (0.24F * cell), board.up * (0.24F * cell), board.toEye * (0.24F * cell)),
            colour, cue.opacity);
    }
}

/// Adds a disc whose light middle is the inner band; the dot shows the lean of the torch's handle.
void CueShapes::addAngles(const Board& board, const CueList& cues, const SeamFrame& frame, int direction) {
    const Cue* work = cues.find(TechniqueQuantity::workAngle);
    const Cue* travel = cues.find(TechniqueQuantity::travelAngle);
    if (work == nullptr && travel == nullptr) return;
    const Cue& any = work != nullptr ? *work : *travel;
    const float cell = board.cell, half = kHalfBar * cell, thick = kLayer * cell;
    const glm::vec3 middle = board.field(1.5F, 1.5F);
    // The handle leans back when the torch pushes.
    const glm::vec3 back = board.shown(glm::vec3(frame.tangent) * (direction < 0 ? 1.0F : -1.0F), board.right);
    const glm::vec3 toWelder = board.shown(glm::vec3(frame.across), -board.up);
    const bool quiet =
        (work == nullptr || work->zone == BandZone::inside) && (travel == nullptr || travel->zone == BandZone::inside);
    const double opacity = std::max(any.opacity, quiet || travel == nullptr ? 0.0 : travel->opacity);
    const auto disc = [&](const glm::vec3& x, const glm::vec3& y, float layer, const glm::vec3& colour, double cover) {
        add(SolidShape::cylinder, placed(middle + board.toEye * (thick * layer), x, y, board.toEye * (thick * 0.5F)),
            colour, cover * opacity);
    };
    addTile(board, middle, any, opacity);
    disc(board.right * (2 * half), board.up * (2 * half), 0, kTrack, kBandOpacity);
    const auto innerOf = [&](const Cue* cue) {
        return 2 * half * static_cast<float>(cue != nullptr ? std::min(cue->inner, 1.0) : any.inner);
    };
    // The seam's directions may be mirrored; the disc faces the eye either way.
    const bool mirrored = glm::dot(glm::cross(back, toWelder), board.toEye) < 0;
    disc(back * innerOf(travel), toWelder * (mirrored ? -innerOf(work) : innerOf(work)), 1, kBand, kBandOpacity);
    const auto share = [](const Cue* cue) { return cue != nullptr ? static_cast<float>(cue->share) : 0.0F; };
    glm::vec3 offset = back * share(travel) + toWelder * share(work);
    if (const float length = glm::length(offset); length > kFarthest) offset *= kFarthest / length;
    const auto zoneOf = [](const Cue* cue) { return cue != nullptr ? cue->zone : BandZone::inside; };
    const float dot = 0.24F * cell;
    add(SolidShape::sphere,
        placed(middle + offset * half + board.toEye * (0.12F * cell), board.right * dot, board.up * dot,
               board.toEye * dot),
        colourOf(std::max(zoneOf(work), zoneOf(travel))), opacity);
}

/// Adds a line for the metal and an arrow to it or from it; a cross if neither helps. `away`: from the metal, unit.
void CueShapes::addArcSign(const Board& board, const Cue& cue, const glm::vec3& away) {
    const float cell = board.cell, half = kHalfBar * cell, thick = kLayer * cell;
    const glm::vec3 middle = board.field(1.0F, 2.5F + kMarkerTextLine * nameFigure_);
    const glm::vec3& colour = colourOf(cue.zone);
    add(SolidShape::cylinder,
        placed(middle, board.right * (2.4F * half), board.up * (2.4F * half), board.toEye * thick), kGround,
        kGroundOpacity * cue.opacity);
    const auto bar = [&](const glm::vec3& at, const glm::vec3& along, float length) {
        add(SolidShape::box,
            placed(at + board.toEye * (2 * thick), along * length, glm::cross(board.toEye, along) * (0.1F * cell),
                   board.toEye * thick),
            colour, cue.opacity);
    };
    const glm::vec3 sideways = glm::cross(board.toEye, away);
    if (cue.correction() == 0) {
        bar(middle, glm::normalize(away + sideways), 1.6F * half);
        bar(middle, glm::normalize(away - sideways), 1.6F * half);
        return;
    }
    bar(middle - away * (0.8F * half), sideways, 1.4F * half);
    const glm::vec3 way = away * static_cast<float>(cue.correction());
    const glm::vec3 centre = middle + away * (0.15F * half) + board.toEye * (0.12F * cell);
    add(SolidShape::cone, alongLine(centre - way * (0.6F * half), centre + way * (0.6F * half), 0.7F * half), colour,
        cue.opacity);
}

/// Adds dashes on the line to aim at, ahead of the pool, to the end of the wanted seam, fainter with distance; none on
/// a weld.
void CueShapes::addSeam(const Cue& cue, const Seam& seam, const CuePose& pose, const glm::vec3& pool, const CueEye& eye,
                        const WeldedPlaces* welded) {
    const double onward = pose.direction != 0 ? pose.direction : pose.place < (pose.from + pose.to) / 2 ? 1 : -1;
    const glm::vec3 normal(seam.at(pose.place).up);
    const float width = std::clamp(kDashWidth * glm::distance(eye.position, pool), kThinnest, kThickest);
    // Each of two eyes is to one side of the middle between them.
    const glm::vec3 apart =
        glm::normalize(glm::cross(eye.up, eye.position - pool)) * (kClearPerLift * glm::distance(eye.position, pool));
    const auto covers = [&](const glm::mat4& dash) {
        for (const float x : {-0.5F, 0.0F, 0.5F})
            for (const float y : {-0.5F, 0.0F, 0.5F})
                for (const float z : {-0.5F, 0.0F, 0.5F})
                    for (const float side : {-1.0F, 0.0F, 1.0F})
                        if (coversDisc(eye.position + apart * side, glm::vec3(dash * glm::vec4(x, y, z, 1)), pool,
                                       normal, kBesideDisc * static_cast<float>(kPoolDisc)))
                            return true;
        return false;
    };
    for (int i = 0; i < kDashes; ++i) {
        const double from = pose.place + onward * (kDashStart + i * kDashPeriod), to = from + onward * kDashLength;
        if (!seam.closed() && (std::max(from, to) > pose.to || std::min(from, to) < pose.from)) continue;
        if (welded != nullptr && welded->any(from, to)) continue;
        const SeamFrame near = seam.at(from), far = seam.at(to);
        const glm::vec3 a(near.point + pose.line * near.across + kDashLift * near.up);
        const glm::vec3 b(far.point + pose.line * far.across + kDashLift * far.up);
        const glm::mat4 dash = alongLine(a, b, width), ground = alongLine(a, b, kDashGround * width);
        if (covers(ground)) continue;
        add(SolidShape::cylinder, ground, kGround, cue.opacity * (0.6 - 0.08 * i));
        add(SolidShape::cylinder, dash, kDash, cue.opacity * (0.95 - 0.12 * i));
    }
}

std::span<const Marker> CueShapes::build(const CueList& cues, const Seam& seam, const CuePose& pose, const CueEye& eye,
                                         std::span<const WorkpieceBlock> blocks, const glm::mat4& toWorld,
                                         const WeldedPlaces* welded) {
    markers_.clear();
    dashes_ = labelCount_ = 0;
    toWorld_ = toWorld;
    if (cues.empty()) return markers_;
    const SeamFrame frame = seam.at(pose.place);
    const glm::vec3 pool(frame.point + frame.across * pose.aim);
    if (const Cue* cue = cues.find(CueKind::seam)) addSeam(*cue, seam, pose, pool, eye, welded);
    dashes_ = markers_.size();
    const Board board = boardFor(pose, frame, pool, eye, blocks);
    const glm::vec3 away = board.shown(-pose.axis, board.up);
    const glm::vec3 ahead = board.shown(glm::vec3(frame.tangent) * (pose.direction < 0 ? -1.0F : 1.0F), board.right);
    if (const Cue* cue = cues.find(CueKind::distance)) addBar(board, *cue, board.field(0.5F, 1.5F), away);
    if (const Cue* cue = cues.find(CueKind::aim))
        addBar(board, *cue, board.field(0.5F, 0.5F), board.shown(glm::vec3(frame.across), -board.up));
    if (const Cue* cue = cues.find(CueKind::speed)) addBar(board, *cue, board.field(1.5F, 0.5F), ahead);
    addAngles(board, cues, frame, pose.direction);
    if (const Cue* cue = cues.find(CueKind::arc)) addArcSign(board, *cue, away);
    return markers_;
}

} // namespace meltpool
