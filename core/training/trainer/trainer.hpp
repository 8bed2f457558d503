// A lesson in progress: steps the metal under the torch, keeps its surface, record and figures. Windows, headsets,
// scripts and replays all drive this and only this.
#pragma once

#include "core/gl/profiler.hpp"
#include "core/gl/program.hpp"
#include "core/render/scene.hpp"
#include "core/surface/mesh_copy.hpp"
#include "core/surface/surface.hpp"
#include "core/training/attempt/checkpoint_capture.hpp"
#include "core/training/feedback/sight.hpp"
#include "core/training/feedback/sound/ear.hpp"
#include "core/training/judging/judgement.hpp"
#include "core/training/lesson/lesson.hpp"
#include "core/training/trainer/attempt_recorder.hpp"
#include "core/training/trainer/figure_reader.hpp"
#include "core/training/trainer/lesson_metal.hpp"
#include "core/training/trainer/tip_probe.hpp"

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
    size_t metalBytes = 0;   ///< GPU memory of the metal
    size_t surfaceBytes = 0; ///< GPU memory of the surface
    WireAccount wire;        ///< where the wire has gone; area 0 without wire
};

/// What a record says of its attempt beside the lesson.
struct RecordContext {
    int attempt = 1;
    std::string program;
    std::string driver;
    bool paced = false;  ///< a person welds by the clock
    bool replace = true; ///< a file of this name may be replaced
};

class Trainer {
  public:
    /// Makes metal and surface. Throws InputError when the lesson's values are impossible here. `metalThere`: the metal
    /// lies in that context, see LessonMetal; advance() and what makes no surface may then be called on its thread.
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

    /// Makes the surface of the metal as it is now, for the pictures to come; nothing is read back.
    void updateSurface(gl::Profiler* profiler) {
        noteMetal();
        makeSurface(profiler);
    }
    /// The same in two parts: of a metal elsewhere makeSurface() shows the metal as it was at noteMetal(), while steps
    /// are made there. Nothing where nothing was noted since the last one.
    void noteMetal();
    void makeSurface(gl::Profiler* profiler);
    SurfaceMesh mesh() const { return surface_->mesh(); }

    /// Asks where the metal lies under this torch, on the surface of the last updateSurface(); never waits.
    void requestDistance(const TorchSample& torch);
    /// The answer, once, frames later.
    std::optional<SurfaceDistance> pollDistance();
    /// Waits for the GPU.
    SurfaceDistance distanceNow(const TorchSample& torch) { return probe_.now(*surface_, metal_.model(), torch); }
    /// The arc of the last step: one state for hand, eye, score and record.
    const ArcState& arc() const { return arc_; }
    /// What is heard of the last step, its short circuits one by one; the classic model makes no sound.
    const SoundStep& heard() const { return sound_.last(); }
    /// From the next step on each one is given to `ear` (null: to nobody), which must outlive this.
    void listen(Ear* ear) { ear_ = ear; }
    /// Tells models without an arc of their own where the shown metal lies from the tip.
    void setSurfaceDistance(const SurfaceDistance& surface) { surfaceDistance_ = surface; }
    /// Radius (m) of what touches the metal first.
    float touchRadius() const { return metal_.model().touchRadius(); }
    /// See Process::burntOff().
    float burntOff() const { return metal_.model().burntOff(); }
    WireAccount wire() const { return metal_.model().wire(); }
    /// The lesson's metal has an arc, whose figures stand in the record.
    bool hasArc() const { return lesson_.model == LessonModel::Weld; }

    /// The world under the last torch, with the surface of the last updateSurface().
    SceneView scene() const;
    const TorchSample& torch() const { return torch_; }
    Surface& surface() { return *surface_; }
    /// The bodies of the metal as they are now, for files; see bodyMesh() in body_mesh.hpp. Waits for the GPU. What an
    /// earlier scene() lends is no longer valid.
    MeshCopy bodyMesh(gl::ShaderLibrary& shaders) const;

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
    void hearAndSee();
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
    std::unique_ptr<Surface> surface_;
    std::optional<ParticleView> noted_; ///< for the surface
    TipProbe probe_;
    bool forgetProbe_ = false; ///< what it was asked is of another metal; not forgotten at once, but on its own thread
    AttemptRecorder recorder_;
    FigureReader figures_;
    ArcAccount account_;
    size_t nextChange_ = 0; ///< of the demonstration's
    size_t nextEvent_ = 0;  ///< the same
    TorchSample torch_;
    ArcState arc_;
    SoundSource sound_;
    Ear* ear_ = nullptr;
    mutable Sight sight_; ///< what it shows is made when somebody looks
    std::optional<Technique> technique_;
    bool tracked_ = true; ///< the torch, since the last event of it
    SurfaceDistance surfaceDistance_;
    double time_ = 0;
    size_t steps_ = 0;
};

} // namespace meltpool
