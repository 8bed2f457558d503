// The ghost of the running attempt, for window and headset: whose torch it is, when it is shown, and how far the hand
// is from it.
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

/// Owner of the ghost's torch, in the order of GhostParameters::ghost.
enum class GhostChoice {
    none,
    expert, ///< the lesson's demonstration
    best,   ///< the person's best scored attempt at the lesson in the stored recordings
    file,   ///< GhostParameters::file
};

/// Word for a choice in settings, records and scores: "none", "expert" ...
std::string_view ghostName(GhostChoice choice);

/// Settings of a person, one set for all lessons.
struct GhostParameters {
    int ghost = static_cast<int>(GhostChoice::none);
    int pace = static_cast<int>(GhostPace::place);
    std::string file; ///< file of an attempt or a torch path
};
ParameterList describe(GhostParameters& parameters);

/// Torch of an attempt file or a torch path for this lesson. Throws whatever takeTorch() throws, and so for an attempt
/// at another lesson.
TorchPath ghostTorch(const Lesson& lesson, const std::filesystem::path& file);

class AttemptGhost {
  public:
    /// Returns the file of the best stored attempt at a lesson, an empty path if there is none. May read the disk.
    using BestFinder = std::function<std::filesystem::path(const std::string& lesson)>;

    GhostParameters parameters;

    /// Sets the finder; without one `best` finds nothing.
    void findBestBy(BestFinder finder) { findBest_ = std::move(finder); }
    /// Chooses a file, for the command line.
    void choose(const std::filesystem::path& file);

    /// Keys of the settings without effect in this lesson.
    std::span<const std::string_view> idle() const;

    /// Takes another lesson.
    void open(const Lesson& lesson);
    /// Begins an attempt and reads the ghost's path. Never throws: a failure is in fault().
    void begin(const Trainer& trainer);
    /// Begins an attempt with this path as the file's.
    void begin(const Trainer& trainer, const TorchPath& torch);

    /// Takes the last step of a frame. `test`: an attempt for score, which has no ghost. `strength`:
    /// remaining share 0..1, see CueSkill. `elapsed`: s of real time since the last call. Choosing the expert after
    /// begin() takes effect at once, choosing a file with the next attempt. Notes in the record which ghost is on, when
    /// that changes: `ghost expert place`. Allocates nothing while nothing changes.
    void update(Trainer& trainer, bool test, double strength, double elapsed);

    /// True if a ghost is on: its place may still be beyond the ends of its path.
    bool on() const { return on_ != GhostChoice::none; }
    /// Place and time of the ghost; nothing while none is shown.
    const std::optional<GhostMoment>& moment() const { return moment_; }
    const GhostWords& words() const { return words_; }
    /// Name of the ghost that was on while the arc burned in this attempt; empty: none was.
    std::string_view used() const { return used_ == GhostChoice::none ? std::string_view() : ghostName(used_); }
    /// Sentence that says why the chosen ghost is missing; empty once it has been shown for a while.
    std::string_view fault() const { return untold_ > 0 ? std::string_view(fault_) : std::string_view(); }

    /// Markers of the last step's ghost for this eye, in the scene's world; valid until the next call. `zoom`: scale at
    /// which the workpiece is shown to the eye; the ghost's torch keeps its own size, as the person's does.
    /// `boardSide`: see GhostLook.
    std::span<const Marker> markers(const Trainer& trainer, const SceneView& scene, const View& eye, float zoom = 1,
                                    float boardSide = 0);

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
    bool allowed_ = true; ///< true if the lesson allows a ghost
    GhostPath path_;
    GhostChoice loaded_ = GhostChoice::none; ///< owner of the loaded path, or of the one that failed to load
    GhostChoice put_ = GhostChoice::none;    ///< choice that is off until the next attempt, with its notice shown
    std::filesystem::path readFile_;         ///< file read last, for a lesson of this key
    std::string readFor_;
    TorchPath readTorch_;
    GhostChoice on_ = GhostChoice::none;
    GhostPace noted_ = GhostPace::place; ///< pace in the record, while a ghost is on
    GhostChoice used_ = GhostChoice::none;
    std::string fault_;
    double untold_ = 0; ///< s for which the fault is still to be shown
    double strength_ = 1;
    std::optional<double> struck_; ///< s of metal time when the hand's arc first burned
    std::optional<CuePose> hand_;  ///< pose that follows the torch a little late, as the cues do
    std::optional<GhostMoment> moment_;
    GhostWords words_;
    double wordsAge_ = 0; ///< s
    GhostShapes shapes_;
};

} // namespace meltpool
