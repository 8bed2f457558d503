#include "app/activities/attempt_cues.hpp"

#include "core/base/words.hpp"
#include "core/weld/workpiece/position.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>

#include <cmath>
#include <utility>

namespace meltpool {

namespace {

constexpr double kFollowing = 0.08; // s, time constant of following
constexpr double kJumps = 4e-3;     // m; the cues jump to a torch that is so far from them

CueSet possibleIn(const Lesson& lesson) {
    CueSet possible;
    if (lesson.model != LessonModel::Weld) return possible;
    possible.set(CueKind::seam);
    possible.set(CueKind::arc, isArcWelding(lesson.process));
    if (!lesson.technique) return possible;
    for (const CuedQuantity& cued : cuedQuantities())
        if (lesson.technique->find(cued.quantity) != nullptr) possible.set(cued.kind);
    return possible;
}

CuePose poseOf(const Trainer& trainer) {
    const Technique& technique = *trainer.technique();
    const auto& bands = trainer.lesson().technique;
    const Seam& seam = technique.seam();
    CuePose pose;
    pose.place = technique.place();
    pose.aim = technique.steps().back().aim;
    if (const TechniqueBand* band = bands ? bands->find(TechniqueQuantity::aim) : nullptr)
        pose.line = band->ideal / quantityInfo(TechniqueQuantity::aim, bands->distance).perSi;
    pose.axis = trainer.torch().axis();
    pose.direction = cueDirection(technique, bands ? &*bands : nullptr);
    pose.from = bands ? bands->lengthFromMm * 1e-3 : seam.begin();
    pose.to = bands ? bands->lengthToMm * 1e-3 : seam.end();
    return pose;
}

/// Returns the top of the table on which a workpiece lies; see CueEye::table.
std::optional<glm::vec4> tableBelow(const WorkpieceParameters& workpiece, const SceneView& scene) {
    const Fixture fixture = fixtureOf(workpiece);
    if (fixture.overTable > 0) return std::nullopt;
    const glm::vec3 up = fixture.up();
    return glm::vec4(up, lowestAlong(up, scene.boxMin, scene.boxMax));
}

} // namespace

CuePose followedPose(const CuePose* before, const Trainer& trainer, double elapsed) {
    CuePose pose = poseOf(trainer);
    if (before == nullptr || std::hypot(pose.place - before->place, pose.aim - before->aim) > kJumps) return pose;
    const double share = 1 - std::exp(-elapsed / kFollowing);
    pose.place = before->place + (pose.place - before->place) * share;
    pose.aim = before->aim + (pose.aim - before->aim) * share;
    return pose;
}

CueEye cueEye(const SceneView& scene, const View& eye) {
    const glm::mat4 toModel = glm::inverse(scene.modelToWorld);
    CueEye from;
    from.position = toModel * glm::vec4(eye.eye, 1);
    from.up = glm::normalize(glm::mat3(toModel) * glm::vec3(glm::row(eye.worldToEye, 1)));
    from.toClip = eye.eyeToClip * eye.worldToEye * scene.modelToWorld;
    return from;
}

CueWords cueWords(CueKind kind) {
    CueWords words{phraseOf("notice.cues", cueName(kind))};
    if (kind != CueKind::speed && kind != CueKind::distance) return words; // the others have more than two ways
    words.less = phraseOf("notice.cues.less", cueName(kind));
    words.more = phraseOf("notice.cues.more", cueName(kind));
    return words;
}

ParameterList describe(CueParameters& c) {
    return {
        {"speed", "Speed", "", &c.speed, 0, 1, "Arrow on a bar along the seam. Ahead of the middle means too fast."},
        {"angles", "Angles", "", &c.angles, 0, 1, "Dot in a disc. It shows the lean of the torch's handle."},
        {"distance", "Arc length or distance", "", &c.distance, 0, 1,
         "Bar along the torch. A mark over the middle means too far from the metal."},
        {"aim", "Aim", "", &c.aim, 0, 1, "Ball on a bar across the seam. Off the middle means off the seam."},
        {"seam", "Seam ahead", "", &c.seam, 0, 1, "Dashes on the next stretch of the seam."},
        {"arc", "Arc out", "", &c.arc, 0, 1, "Sign when the arc is out, with the reason and your next step."},
    };
}

void AttemptCues::open(const Lesson& lesson) {
    const CueSet possible = possibleIn(lesson);
    allowed_ = {};
    idle_.clear();
    for (const CueKind kind : kCueKinds) {
        const bool shows = possible.has(kind) && lesson.cues.has(kind);
        allowed_.set(kind, shows);
        if (!shows) idle_.push_back(cueName(kind));
    }
    setSkill({});
    begin();
}

void AttemptCues::begin() {
    before_ = skill_;
    used_ = on_ = faded_ = {};
    heldByDesk_.reset();
    notedHeld_.reset();
    showsFaded_ = false;
    pose_.reset();
    welded_.reset();
}

CueSet AttemptCues::switchedOn() const {
    CueSet on;
    on.set(CueKind::speed, parameters.speed);
    on.set(CueKind::angles, parameters.angles);
    on.set(CueKind::distance, parameters.distance);
    on.set(CueKind::aim, parameters.aim);
    on.set(CueKind::seam, parameters.seam);
    on.set(CueKind::arc, parameters.arc);
    return on;
}

void AttemptCues::update(Trainer& trainer, bool test, double elapsed) {
    const CueSet switched = switchedOn();
    CueSet on;
    for (const CueKind kind : kCueKinds) {
        const bool follows = kind == CueKind::aim && swings_;
        wanted_.set(kind, !test && switched.has(kind) && allowed_.has(kind) && !follows);
        faded_.set(kind, wanted_.has(kind) && before_.strength(kind) <= 0);
        on.set(kind, wanted_.has(kind) && (showsFaded_ || !faded_.has(kind)));
    }
    if (on != on_) trainer.event("cues", on.empty() ? "none" : on.names());
    on_ = on;
    noteHeld(trainer);
    if (trainer.technique() == nullptr || trainer.technique()->steps().empty()) return;
    if (trainer.arc().burns()) used_.add(on);
    pose_ = followedPose(pose_ ? &*pose_ : nullptr, trainer, elapsed);
    if (!welded_) welded_.emplace(trainer.technique()->seam(), pose_->line);
    welded_->update(*trainer.technique());
}

void AttemptCues::noteHeld(Trainer& trainer) {
    const auto& bands = trainer.lesson().technique;
    if (!bands || !trainer.arc().burns()) return;
    QuantitySet held = heldByDesk_;
    for (size_t i = 0; i < held.size(); ++i)
        held.set(i, held.test(i) && bands->find(static_cast<TechniqueQuantity>(i)) != nullptr);
    if (std::exchange(notedHeld_, held) == held) return;
    trainer.event("desk_holds", held.none() ? "none" : keysOf(held, bands->distance));
}

/// Returns the names of the board's fields; none if the person has made progress with each of them, as one field
/// without a name among named ones would look like a fault.
CueNames AttemptCues::names() const {
    CueNames names;
    bool anyNew = false;
    for (const CueKind kind : {CueKind::speed, CueKind::angles, CueKind::distance, CueKind::aim}) {
        names[static_cast<size_t>(kind)] = cueWords(kind);
        anyNew = anyNew || (on_.has(kind) && isNew(kind));
    }
    return anyNew ? names : CueNames();
}

std::span<const Marker> AttemptCues::markers(const Trainer& trainer, const SceneView& scene, const View& eye,
                                             CueNaming naming) {
    if (!pose_ || on_.empty()) return {};
    const Technique& technique = *trainer.technique();
    const auto& bands = trainer.lesson().technique;
    const CueList cues = liveCues(technique, trainer.arc(), bands ? &*bands : nullptr, on_, shownSkill());
    CueEye from = cueEye(scene, eye);
    from.table = tableBelow(trainer.lesson().workpiece, scene);
    from.hands = scene.hands;
    shapes_.setNames(naming == CueNaming::whileNew ? names() : CueNames());
    return shapes_.build(cues, technique.seam(), *pose_, from, scene.blocks, scene.modelToWorld,
                         welded_ ? &*welded_ : nullptr);
}

} // namespace meltpool
