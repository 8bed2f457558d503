// Runs a lesson: it steps the metal under the torch. Windows, headsets, scripts and replays all drive this and only
// this; a LessonScene makes the pictures.
#pragma once

#include "core/gl/profiler.hpp"
#include "core/gl/program.hpp"
#include "core/training/attempt/checkpoint_capture.hpp"
#include "core/training/feedback/sound/sound_steps.hpp"
#include "core/training/judging/judgement.hpp"
#include "core/training/lesson/lesson.hpp"
#include "core/training/trainer/attempt_recorder.hpp"
#include "core/training/trainer/figure_reader.hpp"
#include "core/training/trainer/lesson_metal.hpp"

#include <memory>
#include <optional>
#include <utility>

namespace meltpool {

/// Figures of a run at one moment.
struct LessonResult {
    double seconds = 0; ///< simulated time, s
    size_t steps = 0;
    MetalStatistics metal;
    std::uint64_t stateHash = 0;
    size_t metalBytes = 0; ///< GPU memory of the metal
    WireAccount wire;      ///< account of the wire; area 0 without wire
};

/// Contents of a record's head other than the lesson.
struct RecordContext {
    int attempt = 1;
    std::string program;
    std::string driver;
    bool paced = false;  ///< a person welds by the clock
    bool replace = true; ///< true: replaces a file of this name
    std::string person = {};   ///< name of the person who welds; empty: not named
    std::string personId = {}; ///< see AttemptHead
    std::filesystem::path from = {}; ///< record of an ended attempt that had the same steps so far; empty: none
};

/// Watches the steps of a lesson, on the thread that makes them.
class StepWatcher {
  public:
    virtual ~StepWatcher() = default;
    /// Called after a step of a weld; heard(), torch() and steps() of its Trainer describe it. Not called for the
    /// classic model, which has no arc.
    virtual void stepped() = 0;
    /// Called after the metal was reset to its start.
    virtual void beganAgain() = 0;
    /// Called after a checkpoint replaced the metal.
    virtual void restored() = 0;
};

class Trainer {
  public:
    /// Makes the metal. Throws InputError if the lesson's values are impossible here. `metalThread`: context of the
    /// metal, see LessonMetal; all functions may then be called on its thread too.
    Trainer(gl::ShaderLibrary& shaders, Lesson lesson, gl::ContextThread* metalThread = nullptr);
    ~Trainer();
    Trainer(const Trainer&) = delete;
    Trainer& operator=(const Trainer&) = delete;

    /// Values may be changed at any time; those marked onlyAtStart wait for the next Trainer. Changes of metal and
    /// process during an attempt go through change(), which records them.
    Lesson& lesson() { return lesson_; }
    const Lesson& lesson() const { return lesson_; }
    /// Sets a value from the next step on, in the record too. Throws InputError, beginning with `where`, as
    /// Lesson::set() does.
    void change(std::string_view key, std::string_view value, std::string_view where);

    /// Resets metal and clock to the start. A record in progress ends as "reset".
    void reset();

    /// One fixed step under this torch, whose time counts as the step's end. See figures() for non-finite particles and
    /// recordFault() for a failed record.
    void advance(const TorchSample& torch, gl::Profiler* profiler);
    /// One step of the demonstration, with the changes of a recorded one.
    void advanceDemonstration(gl::Profiler* profiler);
    /// Makes the changes of a recorded attempt before the next step; its events that spoil a score happen again. A
    /// plain torch path without a pose means that the torch is lost.
    void applyRecordedChanges();

    /// Simulated time, s, and steps since the start.
    double time() const { return time_; }
    size_t steps() const { return steps_; }
    double timeStep() const;

    /// The demonstration's torch for the next step.
    TorchSample demonstration() const { return lesson_.torch.sample(time_ + timeStep()); }

    /// Shows the torch here until the next step, without effect on the metal.
    void show(const TorchSample& torch) { torch_ = torch; }

    /// The torch of the last step, or the torch of a later show().
    const TorchSample& torch() const { return torch_; }

    /// The metal after the last step, to read. Its model has the electrode's burn-off, the account of the wire and the
    /// thickness of the torch's touching end.
    const LessonMetal& metal() const { return metal_; }
    /// The arc of the last step: one state for hand, eye, score and record.
    const ArcState& arc() const { return arc_; }
    /// Sound of the last step, its short circuits one by one; the classic model makes no sound.
    const SoundStep& heard() const { return sound_.last(); }
    /// Gives each step from the next one on to `soundSteps` (null: dropped), which must outlive this.
    void listen(SoundSteps* soundSteps) { soundSteps_ = soundSteps; }
    /// Replaces the watcher from the next step on by `watcher` (null: none). It must outlive this or be replaced before
    /// it ends.
    void watch(StepWatcher* watcher) { watcher_ = watcher; }
    /// Sets the distance from the tip to the shown metal, for models without an arc of their own.
    void setSurfaceDistance(const SurfaceDistance& surface) { surfaceDistance_ = surface; }

    /// Writes every following step to `file`; see Record. Throws InputError if it cannot be written.
    void record(const std::filesystem::path& file, const RecordContext& context = {});
    /// Passes every following step to `recording` too, until stopRecord(). A record does not change its contents.
    void recordInto(std::shared_ptr<RecordingWriter> recording) { recorder_.recordInto(std::move(recording)); }
    /// The head of an attempt at the present lesson; its file and hash, number, date, program and driver are left to
    /// the caller.
    AttemptHead attemptHead();
    /// Ends record and recording; `reason` is written in them. Waits for the GPU.
    void stopRecord(std::string_view reason = "finished");
    bool writesCsvRecord() const { return recorder_.writesCsv(); }
    /// Reason why a record ended before it was stopped, as a sentence; else empty.
    const std::string& recordFault() const { return recorder_.fault(); }
    /// Notes in the record an event after the last step, such as `zoom 2`. `torch lost` and `torch seen` set the
    /// tracking of the torch from now on, `samples dropped` says that places of the torch before the next step are
    /// missing.
    void event(std::string_view name, std::string_view value = {});
    /// Simulated time over real time, around the next steps, for records and judgements of people.
    void setRealTime(double ratio) { recorder_.setRealTime(ratio); }

    /// True: every step waits for its own figures, as a run without a screen may. False (the default): the figures are
    /// the newest that came back without waiting, requested ten times a second, in every step while it is recorded. In
    /// both cases the record's rows hold the figures of their own step.
    void waitForFigures(bool wait) { figures_.setWaiting(wait); }
    const MetalStatistics& figures() const { return figures_.newest(); }

    /// The whole state after the last step. Waits for the GPU. The hand's steps before number `historyFrom` are left
    /// out, see Checkpoint.
    Checkpoint save(size_t historyFrom = 0) const;
    /// save() without waiting: copies on the GPU; the result comes frames later through `capture`, which must not be
    /// busy.
    void capture(CheckpointCapture& capture, size_t historyFrom) const;
    /// Restores that state: the steps from there on have the bits that they had after it. A record in progress goes on;
    /// its readers need an event about it. Waits for the GPU. Throws InputError if the checkpoint is of another lesson,
    /// of another workpiece or damaged; the state is then unchanged.
    void restore(const Checkpoint& checkpoint);

    /// restore() in an attempt that goes on to another end: record and recording get an event `redo STEP` and the
    /// values at that time again.
    void redo(const Checkpoint& checkpoint);

    /// Waits for the GPU.
    LessonResult result() const;

    /// Section of the weld at `place` (m along the seam); by default where the last of the lesson's pictures cuts it,
    /// else in the middle of the welded part. Empty in the classic model. Waits for the GPU.
    std::optional<WeldSection> section(std::optional<double> place = {}) const;

    /// The hand along the seam, of the last step and of the attempt so far; null in the classic model.
    const Technique* technique() const { return technique_ ? &*technique_ : nullptr; }
    /// Judges the attempt so far by the lesson's bands and limits. Waits for the GPU and measures the whole weld.
    Judgement judge() const;

  private:
    void applyValues();
    std::uint64_t stateHash() const;
    void followUnseen();
    void tellOfStep();
    void transfer(gl::StateArchive& archive);
    void xorOutDerivedState();
    void transferLesson(gl::StateArchive& archive);
    void requireFit(const Checkpoint& checkpoint) const;
    static std::uint64_t identityOf(Lesson& lesson);
    static ParameterList liveParameters(Lesson& lesson);

    Lesson lesson_;
    LessonMetal metal_;
    std::uint64_t identity_; ///< hash of lesson, workpiece and process; a checkpoint with another one does not fit
    ParameterList live_;     ///< values of the lesson that may change during the weld
    AttemptRecorder recorder_;
    FigureReader figures_;
    ArcAccount account_;
    size_t nextChange_ = 0; ///< next of the demonstration's changes
    size_t nextEvent_ = 0;  ///< next of the demonstration's events
    TorchSample torch_;
    ArcState arc_;
    SoundSource sound_;
    SoundSteps* soundSteps_ = nullptr;
    StepWatcher* watcher_ = nullptr;
    std::optional<Technique> technique_;
    bool tracked_ = true; ///< torch state after its last event
    SurfaceDistance surfaceDistance_;
    double time_ = 0;
    size_t steps_ = 0;
};

} // namespace meltpool
