// A lesson in progress: steps the metal under the torch. Windows, headsets, scripts and replays all drive this and only
// this; pictures of it are made by a LessonScene.
#pragma once

#include "core/gl/profiler.hpp"
#include "core/gl/program.hpp"
#include "core/training/attempt/checkpoint_capture.hpp"
#include "core/training/feedback/sound/ear.hpp"
#include "core/training/judging/judgement.hpp"
#include "core/training/lesson/lesson.hpp"
#include "core/training/trainer/attempt_recorder.hpp"
#include "core/training/trainer/figure_reader.hpp"
#include "core/training/trainer/lesson_metal.hpp"

#include <memory>
#include <optional>
#include <utility>

namespace meltpool {

/// The figures of a run at one moment.
struct LessonResult {
    double seconds = 0; ///< simulated
    size_t steps = 0;
    MetalStatistics metal;
    std::uint64_t stateHash = 0;
    size_t metalBytes = 0; ///< GPU memory of the metal
    WireAccount wire;      ///< where the wire has gone; area 0 without wire
};

/// What a record says of its attempt beside the lesson.
struct RecordContext {
    int attempt = 1;
    std::string program;
    std::string driver;
    bool paced = false;  ///< a person welds by the clock
    bool replace = true; ///< a file of this name may be replaced
};

/// Watches the steps of a lesson, on the thread that makes them.
class StepWatcher {
  public:
    virtual ~StepWatcher() = default;
    /// A weld made a step, which heard(), torch() and steps() of its Trainer describe. Not called for the classic
    /// model, which has no arc.
    virtual void stepped() = 0;
    /// The metal is back at its start.
    virtual void beganAgain() = 0;
    /// A checkpoint took the metal's place.
    virtual void restored() = 0;
};

class Trainer {
  public:
    /// Makes the metal. Throws InputError when the lesson's values are impossible here. `metalThere`: the metal lies in
    /// that context, see LessonMetal; all functions may then be called on its thread too.
    Trainer(gl::ShaderLibrary& shaders, Lesson lesson, gl::OtherContext* metalThere = nullptr);
    ~Trainer();
    Trainer(const Trainer&) = delete;
    Trainer& operator=(const Trainer&) = delete;

    /// Values may be changed at any time; those marked onlyAtStart wait for the next Trainer. What metal and process
    /// are changed to while an attempt runs goes through change(), which records it.
    Lesson& lesson() { return lesson_; }
    const Lesson& lesson() const { return lesson_; }
    /// Sets a value from the next step on, in the record too. Throws InputError, beginning with `where`, as
    /// Lesson::set() does.
    void change(std::string_view key, std::string_view value, std::string_view where);

    /// Metal and clock back to the start. A record in progress ends as "reset".
    void reset();

    /// One fixed step under this torch, whose time is taken to be that of the step's end. Whether the metal is still
    /// finite stands in figures(), whether the record could be written on in recordFault().
    void advance(const TorchSample& torch, gl::Profiler* profiler);
    /// One step of the demonstration, with the changes of a recorded one.
    void advanceDemonstration(gl::Profiler* profiler);
    /// Makes the changes of a recorded attempt that fall before the next step; its events that spoil a score happen
    /// again. Where a plain torch path has no pose the torch is lost.
    void applyRecordedChanges();

    /// Simulated time, s, and steps since the start.
    double time() const { return time_; }
    size_t steps() const { return steps_; }
    double timeStep() const;

    /// The demonstration's torch for the next step.
    TorchSample demonstration() const { return lesson_.torch.sample(time_ + timeStep()); }

    /// Shows the torch here until the next step; the metal is not touched by it.
    void show(const TorchSample& torch) { torch_ = torch; }

    /// The torch of the last step, or the one that show() put there since.
    const TorchSample& torch() const { return torch_; }

    /// The metal after the last step, to look at. Its model tells how far the electrode has burnt off, where the wire
    /// has gone and how thick the torch's touching end is.
    const LessonMetal& metal() const { return metal_; }
    /// The arc of the last step: one state for hand, eye, score and record.
    const ArcState& arc() const { return arc_; }
    /// What is heard of the last step, its short circuits one by one; the classic model makes no sound.
    const SoundStep& heard() const { return sound_.last(); }
    /// From the next step on each one is given to `ear` (null: dropped), which must outlive this.
    void listen(Ear* ear) { ear_ = ear; }
    /// From the next step on `watcher`, null for none, replaces the watcher before. It must outlive this or be replaced
    /// before it ends.
    void watch(StepWatcher* watcher) { watcher_ = watcher; }
    /// Tells models without an arc of their own where the shown metal lies from the tip.
    void setSurfaceDistance(const SurfaceDistance& surface) { surfaceDistance_ = surface; }

    /// Writes every following step to `file`; see Record. Throws InputError when it cannot be written.
    void record(const std::filesystem::path& file, const RecordContext& context = {});
    /// Brings every following step to `recording` too, until stopRecord(). What is written there is the same whether or
    /// not there is a record.
    void recordInto(std::shared_ptr<RecordingWriter> recording) { recorder_.recordInto(std::move(recording)); }
    /// The head of an attempt at the lesson as it is now; its file and hash, number, date, program and driver are left
    /// to the caller.
    AttemptHead attemptHead();
    /// Ends record and recording; `reason` stands in them. Waits for the GPU.
    void stopRecord(std::string_view reason = "finished");
    bool writesCsvRecord() const { return recorder_.writesCsv(); }
    /// Why a record ended before it was stopped, as a sentence; empty while none did.
    const std::string& recordFault() const { return recorder_.fault(); }
    /// Notes in the record what happened after the last step, such as `zoom 2`. `torch lost` and `torch seen` tell
    /// whether the torch is tracked from now on, `samples dropped` that places of the torch before the next step are
    /// missing.
    void event(std::string_view name, std::string_view value = {});
    /// Simulated over real time about the next steps, for records and judgements of people.
    void setRealTime(double ratio) { recorder_.setRealTime(ratio); }

    /// True: every step waits for its own figures, as a run without a screen may. False (the default): the figures are
    /// the newest that came back without waiting, asked for ten times a second, in every step while it is recorded. The
    /// record's rows hold the figures of their own step either way.
    void waitForFigures(bool wait) { figures_.setWaiting(wait); }
    const MetalStatistics& figures() const { return figures_.newest(); }

    /// The whole state after the last step. Waits for the GPU. The hand's steps before number `historyFrom` are left
    /// out, see Checkpoint.
    Checkpoint save(size_t historyFrom = 0) const;
    /// The same without waiting: copies on the GPU, and comes frames later through `capture`, which must not be busy.
    void capture(CheckpointCapture& capture, size_t historyFrom) const;
    /// Back to that state: the steps from there on have the same bits as they had after it. A record in progress goes
    /// on; whoever reads it must be told with an event. Waits for the GPU. Throws InputError where the checkpoint is of
    /// another lesson, of another workpiece or damaged; the state is then as before.
    void restore(const Checkpoint& checkpoint);

    /// The same in an attempt that goes on from there as another end of it: record and recording tell it, event `redo
    /// STEP`, and repeat the values as they are then.
    void redo(const Checkpoint& checkpoint);

    /// Waits for the GPU.
    LessonResult result() const;

    /// The weld cut across at `place` (m along the seam); without one where the last of the lesson's pictures cuts it,
    /// else in the middle of what was welded. Nothing in the classic model. Waits for the GPU.
    std::optional<WeldSection> section(std::optional<double> place = {}) const;

    /// What the hand does along the seam, of the last step and of the attempt so far; null in the classic model.
    const Technique* technique() const { return technique_ ? &*technique_ : nullptr; }
    /// The attempt so far by the lesson's bands and limits. Waits for the GPU and measures the whole weld.
    Judgement judge() const;

  private:
    void applyValues();
    std::uint64_t stateHash() const;
    void followUnseen();
    void tellOfStep();
    void transfer(gl::StateArchive& archive);
    void fold();
    void transferLesson(gl::StateArchive& archive);
    void requireFit(const Checkpoint& checkpoint) const;
    static std::uint64_t identityOf(Lesson& lesson);
    static ParameterList liveParameters(Lesson& lesson);

    Lesson lesson_;
    LessonMetal metal_;
    std::uint64_t identity_; ///< of lesson, workpiece and process, which other checkpoints do not have
    ParameterList live_;     ///< the lesson's values that may change while it is welded
    AttemptRecorder recorder_;
    FigureReader figures_;
    ArcAccount account_;
    size_t nextChange_ = 0; ///< of the demonstration's
    size_t nextEvent_ = 0;  ///< the same
    TorchSample torch_;
    ArcState arc_;
    SoundSource sound_;
    Ear* ear_ = nullptr;
    StepWatcher* watcher_ = nullptr;
    std::optional<Technique> technique_;
    bool tracked_ = true; ///< the torch, since the last event of it
    SurfaceDistance surfaceDistance_;
    double time_ = 0;
    size_t steps_ = 0;
};

} // namespace meltpool
