// The ghost of the running attempt, for window and headset: whose torch it is, when it is shown, and how far the hand
// is off it.
#pragma once

#include "app/activities/attempt_cues.hpp"
#include "core/base/parameter.hpp"
#include "core/training/feedback/ghost_shapes.hpp"
#include "core/training/trainer/trainer.hpp"

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace meltpool {

/// Whose torch the ghost leads, in the order of GhostParameters::ghost.
enum class GhostChoice {
    none,
    expert, ///< the lesson's demonstration
    best,   ///< the person's best scored attempt at the lesson that is kept
    file,   ///< of GhostParameters::file
};

/// The word for a choice in settings, records and scores: "none", "expert" ...
std::string_view ghostName(GhostChoice choice);

/// A person's wishes, the same in every lesson.
struct GhostParameters {
    int ghost = static_cast<int>(GhostChoice::none);
    int pace = static_cast<int>(GhostPace::place);
    std::string file; ///< of an attempt or a torch path
};
ParameterList describe(GhostParameters& parameters);

/// The torch of an attempt file or a torch path for this lesson. Throws what takeTorch() throws, so for an attempt at
/// another lesson too.
TorchPath ghostTorch(const Lesson& lesson, const std::filesystem::path& file);

class AttemptGhost {
  public:
    /// Answers the file of the best attempt at a lesson that is kept, an empty path where there is none. It may read
    /// the disk.
    using BestFinder = std::function<std::filesystem::path(const std::string& lesson)>;

    GhostParameters parameters;

    /// Without it `best` finds nothing.
    void findBestBy(BestFinder finder) { findBest_ = std::move(finder); }
    /// Chooses a file, as a person does on the command line.
    void choose(const std::filesystem::path& file);

    /// Keys of the wishes that do nothing in the lesson at hand.
    std::span<const std::string_view> idle() const;

    /// Another lesson.
    void open(const Lesson& lesson);
    /// An attempt begins: reads the ghost's path. Never throws: what is wrong stands in fault().
    void begin(const Trainer& trainer);
    /// An attempt begins with this path as the file's.
    void begin(const Trainer& trainer, const TorchPath& torch);

    /// Takes the last step of a frame. `test`: an attempt for score, which has no ghost. `strength`: 0..1 that is left
    /// of it, see CueSkill. `elapsed`: real seconds since the last call. A wish for the expert that came since begin()
    /// is met at once, one for a file with the next attempt. Notes in the record which ghost is on, where it is another
    /// than before: `ghost expert place`. Allocates nothing while nothing changes.
    void update(Trainer& trainer, bool test, double strength, double elapsed);

    /// A ghost is on: its place may still be beyond the ends of its path.
    bool on() const { return on_ != GhostChoice::none; }
    /// Where it stands; nothing while none is shown.
    const std::optional<GhostMoment>& moment() const { return moment_; }
    const GhostWords& words() const { return words_; }
    /// The name of the one that was on while the arc burned in this attempt; empty: none was.
    std::string_view used() const { return used_ == GhostChoice::none ? std::string_view() : ghostName(used_); }
    /// Why there is no ghost though one is wished for, a sentence; empty once it has been told for a while.
    std::string_view fault() const { return untold_ > 0 ? std::string_view(fault_) : std::string_view(); }

    /// The ghost of the last step for this eye, in the scene's world; valid until the next call. `zoom` at which the
    /// workpiece is shown to the eye: the ghost's torch keeps its own size, as the person's does.
    std::span<const Marker> markers(const Trainer& trainer, const SceneView& scene, const View& eye, float zoom = 1);

  private:
    GhostChoice wanted() const { return static_cast<GhostChoice>(parameters.ghost); }
    GhostPace pace() const { return static_cast<GhostPace>(parameters.pace); }
    void forget();
    void load(const Trainer& trainer);
    const TorchPath& read(const Lesson& lesson, const std::filesystem::path& file);
    void follow(const Trainer& trainer, GhostChoice choice, const TorchPath& torch);
    void refuse(std::string fault);
    void note(Trainer& trainer, GhostChoice now);
    void place(const Trainer& trainer, double elapsed);
    void tellWords(const Trainer& trainer, double elapsed);

    BestFinder findBest_;
    bool allowed_ = true; ///< by the lesson
    GhostPath path_;
    GhostChoice loaded_ = GhostChoice::none; ///< whose path that is, or would be without fault
    GhostChoice put_ = GhostChoice::none;    ///< off to the next attempt, and told so
    std::filesystem::path readFile_;         ///< the file read last, for a lesson of this key
    std::string readFor_;
    TorchPath readTorch_;
    GhostChoice on_ = GhostChoice::none;
    GhostPace noted_ = GhostPace::place; ///< in the record, while one is on
    GhostChoice used_ = GhostChoice::none;
    std::string fault_;
    double untold_ = 0; ///< s that the fault is still to be told
    double strength_ = 1;
    std::optional<double> struck_; ///< s of metal time when the hand's arc first burned
    std::optional<CuePose> hand_;  ///< follows the torch a little late, as the cues do
    std::optional<GhostMoment> moment_;
    GhostWords words_;
    double wordsAge_ = 0; ///< s
    GhostShapes shapes_;
};

} // namespace meltpool
