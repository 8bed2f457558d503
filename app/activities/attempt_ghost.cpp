#include "app/activities/attempt_ghost.hpp"

#include "core/base/error.hpp"
#include "core/base/words.hpp"

#include <cmath>
#include <utility>

namespace meltpool {

namespace {

constexpr std::array<std::string_view, 4> kNames{"none", "expert", "best", "file"};
constexpr std::array<std::string_view, 2> kPaces{"place", "time"};
constexpr std::array<std::string_view, 3> kKeys{"ghost", "ghost_pace", "ghost_file"};

constexpr double kTold = 8;          // s for which a fault is shown
constexpr double kWordsPeriod = 0.3; // s between two readings: faster ones are illegible

/// Name beside a ghost's torch; empty: none.
std::string_view nameOf(GhostChoice choice) {
    if (choice == GhostChoice::expert) return phrase("ghost.name.expert");
    return choice == GhostChoice::best ? std::string_view(phrase("ghost.name.best")) : std::string_view();
}

/// True for a torch without arc far from the seam, as for cues.
bool isPutAside(const Trainer& trainer) {
    const TechniqueValues& values = trainer.technique()->now();
    return !trainer.arc().burns() && !(std::abs(values[TechniqueQuantity::height]) < kCueReach &&
                                       std::abs(values[TechniqueQuantity::aim]) < kCueReach);
}

} // namespace

std::string_view ghostName(GhostChoice choice) {
    return kNames[static_cast<size_t>(choice)];
}

ParameterList describe(GhostParameters& g) {
    return {
        {"ghost", "Ghost", "", &g.ghost, 0, 3,
         "Pale second torch beside yours: the expert's, that of your best attempt, or that of a file.", kNames},
        {"ghost_pace", "Its pace", "", &g.pace, 0, 1,
         "With place, it stays at your place on the seam. With time, it goes its own way from your first strike.",
         kPaces},
        {"ghost_file", "Its file", "", &g.file, 0, 0, "Attempt or torch path. --ghost FILE chooses another."},
    };
}

TorchPath ghostTorch(const Lesson& lesson, const std::filesystem::path& file) {
    Lesson led = lesson;
    takeTorch(led, file);
    return led.torch;
}

void AttemptGhost::choose(const std::filesystem::path& file) {
    parameters.ghost = static_cast<int>(GhostChoice::file);
    parameters.file = file.string();
}

std::span<const std::string_view> AttemptGhost::idle() const {
    return allowed_ ? std::span<const std::string_view>() : std::span<const std::string_view>(kKeys);
}

void AttemptGhost::open(const Lesson& lesson) {
    allowed_ = lesson.model == LessonModel::Weld && lesson.ghost;
    forget();
}

void AttemptGhost::forget() {
    path_ = {};
    loaded_ = put_ = on_ = used_ = GhostChoice::none;
    fault_.clear();
    untold_ = 0;
    struck_.reset();
    hand_.reset();
    moment_.reset();
    words_ = {};
    wordsAge_ = kWordsPeriod;
}

void AttemptGhost::begin(const Trainer& trainer) {
    forget();
    if (allowed_ && trainer.technique() != nullptr) load(trainer);
}

void AttemptGhost::begin(const Trainer& trainer, const TorchPath& torch) {
    forget();
    if (allowed_ && trainer.technique() != nullptr) follow(trainer, GhostChoice::file, torch);
}

void AttemptGhost::load(const Trainer& trainer) {
    const Lesson& lesson = trainer.lesson();
    loaded_ = put_ = wanted();
    path_ = {};
    untold_ = 0;
    try {
        if (loaded_ == GhostChoice::expert) {
            if (lesson.torch.empty()) return refuse(phrase("lead.fault.no_demonstration"));
            follow(trainer, loaded_, lesson.torch);
        } else if (loaded_ == GhostChoice::best) {
            const std::filesystem::path best = findBest_ ? findBest_(lesson.key) : std::filesystem::path();
            if (best.empty()) return refuse(phrase("lead.fault.no_scored_attempt"));
            follow(trainer, loaded_, read(lesson, best));
        } else if (loaded_ == GhostChoice::file) {
            if (parameters.file.empty()) return refuse(phrase("lead.fault.no_file"));
            follow(trainer, loaded_, read(lesson, parameters.file));
        }
    } catch (const std::exception& fault) {
        refuse(phrase("lead.fault.not_read", {{"fault", fault.what()}}));
    }
}

/// Reads the file; for the next attempt at the lesson it is in memory already.
const TorchPath& AttemptGhost::read(const Lesson& lesson, const std::filesystem::path& file) {
    if (file != readFile_ || lesson.key != readFor_) {
        readFile_.clear();
        readTorch_ = ghostTorch(lesson, file);
        readFile_ = file;
        readFor_ = lesson.key;
    }
    return readTorch_;
}

void AttemptGhost::follow(const Trainer& trainer, GhostChoice choice, const TorchPath& torch) {
    loaded_ = choice;
    path_ = GhostPath(torch, trainer.technique()->seam(), trainer.technique()->settings());
    if (path_.empty()) refuse(phrase("lead.fault.no_trigger"));
}

void AttemptGhost::refuse(std::string fault) {
    path_ = {};
    fault_ = std::move(fault);
    untold_ = kTold;
}

void AttemptGhost::note(Trainer& trainer, GhostChoice now) {
    if (now == on_ && (now == GhostChoice::none || pace() == noted_)) return;
    on_ = now;
    noted_ = pace();
    const std::string name(ghostName(now));
    trainer.event("ghost", now == GhostChoice::none ? name : name + " " + std::string(kPaces[size_t(noted_)]));
}

void AttemptGhost::update(Trainer& trainer, bool test, double strength, double elapsed) {
    strength_ = strength;
    untold_ -= elapsed;
    const Technique* technique = trainer.technique();
    if (technique == nullptr || technique->steps().empty()) return;
    if (allowed_ && !test && wanted() != loaded_) {
        if (wanted() == GhostChoice::none || wanted() == GhostChoice::expert)
            load(trainer);
        else if (std::exchange(put_, wanted()) != wanted())
            refuse(phrase("lead.next_attempt"));
    }
    const bool shows = allowed_ && !test && wanted() != GhostChoice::none && wanted() == loaded_ && !path_.empty();
    note(trainer, shows && strength > 0 ? wanted() : GhostChoice::none);
    if (struck_ && trainer.time() < *struck_) struck_.reset(); // the metal went back to an earlier checkpoint
    if (!struck_ && trainer.arc().burns()) struck_ = trainer.time();
    if (trainer.arc().burns() && on()) used_ = on_;
    if (!on()) {
        moment_.reset();
        hand_.reset();
        return;
    }
    place(trainer, elapsed);
    tellWords(trainer, elapsed);
}

void AttemptGhost::place(const Trainer& trainer, double elapsed) {
    hand_ = followedPose(hand_ ? &*hand_ : nullptr, trainer, elapsed);
    if (pace() == GhostPace::time)
        moment_ = path_.atTime(struck_ ? trainer.time() - *struck_ : 0);
    else if (isPutAside(trainer))
        moment_.reset();
    else
        moment_ = path_.atPlace(hand_->place);
}

void AttemptGhost::tellWords(const Trainer& trainer, double elapsed) {
    wordsAge_ += elapsed;
    if (!moment_ || isPutAside(trainer)) {
        words_ = {};
        wordsAge_ = kWordsPeriod;
        return;
    }
    if (wordsAge_ < kWordsPeriod) return;
    wordsAge_ = 0;
    words_ = GhostWords(ghostDelta(*trainer.technique(), hand_->direction, *moment_, path_), pace());
}

std::span<const Marker> AttemptGhost::markers(const Trainer& trainer, const SceneView& scene, const View& eye,
                                              float zoom, float boardSide) {
    if (!on() || !moment_ || !hand_) return {};
    const GhostLook look{strength_, 1 / zoom, *hand_, nameOf(on_), boardSide};
    return shapes_.build(*moment_, words_, trainer.lesson().process, trainer.technique()->seam(), look,
                         cueEye(scene, eye), scene.modelToWorld);
}

} // namespace meltpool
