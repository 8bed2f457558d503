// The lesson that window and headset share: its values, and the Trainer that runs it.
#pragma once

#include "app/activities/attempt_replay.hpp"
#include "app/activities/demonstration.hpp"
#include "app/activities/question.hpp"
#include "app/activities/redo.hpp"
#include "app/activities/speed_trial.hpp"
#include "app/library/recording_keeper.hpp"
#include "app/session/attempt_cues.hpp"
#include "app/session/attempt_ghost.hpp"
#include "app/session/attempt_judge.hpp"
#include "app/session/attempt_records.hpp"
#include "app/session/controls.hpp"
#include "app/session/cut_view.hpp"
#include "app/session/desk_torch.hpp"
#include "app/session/hearing.hpp"
#include "app/session/lesson_figures.hpp"
#include "app/session/lesson_sections.hpp"
#include "app/session/step_clock.hpp"
#include "core/base/function_ref.hpp"
#include "core/render/effects/worn_visor.hpp"
#include "core/render/renderer.hpp"
#include "core/training/trainer/trainer.hpp"
#include "core/weld/workpiece/position.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace meltpool {

/// The lesson of a catalogue name or TOML file. Throws InputError when it cannot be used.
Lesson loadLesson(const std::string& name);

/// A torch that the mouse does not lead: answers the sample for step `step` (from 0) of the `steps` of a frame.
using TorchSource = std::function<TorchSample(int step, int steps)>;

/// Seconds of a clock that never goes back; its zero means nothing.
using Stopwatch = double (*)();
double machineSeconds();

/// A scene and the eye that sees it.
struct DeskPicture {
    SceneView scene;
    View view;
};

class LessonSession {
  public:
    /// `stopwatch` tells how long steps take. `metalThere`: the metal lies in that context, see LessonMetal; it must
    /// outlive the session. Throws InputError when the shaders cannot be used.
    LessonSession(gl::ShaderLibrary& shaders, Lesson lesson, Stopwatch stopwatch = machineSeconds,
                  gl::OtherContext* metalThere = nullptr);
    LessonSession(const LessonSession&) = delete;
    LessonSession& operator=(const LessonSession&) = delete;
    ~LessonSession() { end("the program ended"); }

    /// Takes another lesson, with the values of its file. A running one ends. What sections() answered before is gone.
    void open(Lesson lesson);

    /// Makes the metal from the start values: another attempt. Throws InputError or RuntimeFault when memory or driver
    /// do not suffice. What the person must decide first stands in question().
    void begin(Controls& controls);
    /// Makes the metal and plays the lesson's demonstration over it. It has no record and is not judged. Throws as
    /// begin() does.
    void demonstrate(Controls& controls);
    /// The lesson has one.
    bool hasDemonstration() const { return lesson_.torch.duration() > 0; }
    /// It is played, paused and moved through this; reset() ends it and begins an attempt.
    Demonstration& demonstration() { return demonstration_; }
    const Demonstration& demonstration() const { return demonstration_; }

    /// Makes the metal of a kept attempt, see lessonOfAttempt(), and plays it. It has no record and is not judged; the
    /// menus' values change nothing of it. reset() ends it and begins an attempt. Throws as begin() does.
    void openReplay(Lesson attempt, Controls& controls);
    AttemptReplay& replay() { return replay_; }
    const AttemptReplay& replay() const { return replay_; }
    /// Attempt's time over real time that this machine plays it at.
    double replaySpeed() const;
    /// It jumps to another time, and takes all the time that it can get.
    bool seeks() const { return replay_.shown() && replay_.line().seeking(); }

    /// What the metal's steps cost of the frames.
    const StepClock& clock() const { return clock_; }
    /// Real time (s) that the steps of a second of the metal take; 0 without a running lesson or before the first.
    double loadOfSteps() const { return running() ? 1 / clock_.speedOfSteps(trainer_->timeStep()) : 0; }
    /// The machine's speed is being measured, see SpeedTrial.
    bool measuresSpeed() const { return trial_.running(); }
    /// The torch is that of a demonstration or a replay: nobody leads it.
    bool played() const { return demonstration_.shown() || replay_.shown(); }

    /// Puts metal and source back to their start: another attempt. No shader is compiled anew.
    void reset(Controls& controls);
    /// Ends the lesson and frees the metal. `reason` stands in the attempt's record.
    void end(std::string_view reason) noexcept;
    bool running() const { return trainer_ != nullptr; }
    /// No step was made in the last frame, as the person looks around or the weld is cut open.
    bool paused() const { return paused_; }

    /// Runs the steps that fit into `seconds` of real time. The torch follows `held`, or the controls where that is
    /// empty; then nothing runs in view mode.
    void advance(const Controls& controls, double seconds, gl::Profiler* profiler, const TorchSource& held = {});
    /// The same in three parts. True: makeSteps() and then finishSteps() are to be called before anything else of this
    /// but completeSurface() and draw(); `controls` must stay as they are until then. False: all is done.
    bool beginSteps(const Controls& controls, double seconds, gl::Profiler* profiler, const TorchSource& held = {});
    /// The next steps are made beside a picture, whose frame takes so long besides steps (s); 0: before it.
    void stepBeside(double rest) { beside_ = rest; }
    /// May run on the thread of the metal's context, while completeSurface() and draw() show the metal as it was.
    void makeSteps(gl::Profiler* profiler);
    void finishSteps();

    /// What the desk's picture shows of the lesson as it is now. `aspect`: width over height; `shift`: how far right of
    /// the window's middle the picture's middle is, as a share of half its width. What it lends is valid until the
    /// lesson's next steps are finished.
    /// `surfaceLater`: the surface is still to be made by completeSurface().
    DeskPicture picture(const Controls& controls, float aspect, float shift, bool surfaceLater, gl::Profiler* profiler);
    /// Makes the surface that a picture() left for later.
    void completeSurface(DeskPicture& picture, gl::Profiler* profiler);
    void draw(const DeskPicture& picture, const RenderTarget& target, gl::Profiler* profiler);
    /// The detail of the pictures to come, whatever the lesson's file says; the highest at first.
    void setDetail(PictureDetail detail) { detail_ = detail; }
    /// The lesson's look with that detail.
    LookParameters look() const;

    /// Asks where the metal lies under the torch in the hand. The answer comes frames later; nothing waits for it.
    void sound(const TorchSample& torch);
    /// The newest answer; no metal anywhere before the first.
    const SurfaceDistance& surfaceDistance() const { return surfaceDistance_; }
    /// The arc of the last step; out without a running lesson.
    ArcState arc() const { return running() ? trainer_->arc() : ArcState{}; }
    /// Radius (m) of what touches the metal first.
    float touchRadius() const { return running() ? trainer_->touchRadius() : 0; }

    /// The scene with the current surface; empty without a running lesson.
    SceneView scene(gl::Profiler* profiler);
    Renderer& renderer() { return renderer_; }
    /// Metres of a unit of the scene's world.
    float unit() const;
    /// How far under the workpiece's origin the lowest place of its space lies in the room, m, negative.
    float bottom() const;
    /// How the workpiece is held; as it lies without a running weld lesson.
    Fixture fixture() const;
    /// From the next start on each attempt has a record; see AttemptRecords.
    AttemptRecords& records() { return records_; }
    const AttemptRecords& records() const { return records_; }
    /// The same of recordings, which nobody has to ask for.
    RecordingKeeper& recordings() { return recordings_; }
    const RecordingKeeper& recordings() const { return recordings_; }
    /// Notes in the attempt's record what happened after the last step: `recentred`, `torch_lost`, `zoom 2`. Nothing
    /// without a running lesson.
    void event(std::string_view name, std::string_view value = {});
    /// Why the attempt's record was cut short; empty while it is whole or none is wanted.
    const std::string& recordFault() const;

    /// What the person must answer first; until then no step is made. Menus show it and set `answered`.
    Question& question() { return question_; }
    const Question& question() const { return question_; }
    /// Does what the person answered.
    void settle(Controls& controls);

    /// Settings of the machine that the lesson gives are others than its own.
    bool settingsChanged() const;
    /// See Lesson::chosenText().
    std::string chosenText() { return lesson_.chosenText(); }

    /// Whether this lesson's weld can be measured and judged.
    bool judges() const { return running() && !played() && trainer_->technique() != nullptr; }
    /// Judges the attempt so far; nothing while the arc burns or before the attempt has begun. Waits for the GPU. A
    /// finished weld is judged without being asked for, see AttemptJudge.
    void judge();
    /// The judgement of the attempt, until the arc burns again or another attempt begins, and how many there were.
    const std::optional<JudgedAttempt>& judged() const { return judge_.judged(); }
    size_t judgements() const { return judge_.count(); }

    /// Writes the page of the judged attempt: beside its record, where it has one, else into the user's folder. `zoom`
    /// at which the workpiece was shown; `driver` of the graphics. Answers where it is. Waits for the GPU. Throws
    /// InputError where nothing is judged or nothing can be written there, RuntimeFault where the machine fails.
    std::filesystem::path writePage(double zoom, const std::string& driver);

    /// Whether the attempt can go back to an earlier moment now.
    bool redoes();
    /// Goes back to before the fault that was chosen in earlierMoments(), or some seconds: the metal is as it was then,
    /// and the torch welds on from there once its trigger was let go. The attempt is practice from here on. Waits for
    /// the GPU.
    void redo(Controls& controls);
    Redo& earlierMoments() { return redo_; }
    const Redo& earlierMoments() const { return redo_; }

    /// Whether the weld can be cut open now: it can be judged, and the arc does not burn or the person has paused.
    bool cuts() const;
    /// Cuts the weld open, the desk's camera square before the cut, or closes it again, with camera and mode as before.
    /// While it is open no step is made; arrow keys and a dragging mouse move the cut.
    void toggleCut(Controls& controls);
    CutView& cut() { return cut_; }
    const CutView& cut() const { return cut_; }

    /// What is shown beside the torch, in attempts only.
    AttemptCues& cues() { return cues_; }
    const AttemptCues& cues() const { return cues_; }
    /// Their switches, the same in every lesson; those that do nothing in this one are idle.
    ParameterSection& cueSection() { return cueSection_; }
    /// The cues for this eye, or for the middle between two, in the world of `scene`; none outside an attempt. Valid
    /// until the next call.
    std::span<const Marker> cueMarkers(const SceneView& scene, const View& eye);

    /// What is heard of the lesson, and the switches of it, the same in every lesson.
    Hearing& hearing() { return hearing_; }
    const Hearing& hearing() const { return hearing_; }
    ParameterSection& soundSection() { return soundSection_; }
    /// Where the arc is from an eye of this view matrix, in the eye's directions, m. Nothing without a running weld
    /// lesson.
    std::optional<glm::vec3> arcFrom(const glm::mat4& worldToEye) const;
    /// See ShortCircuits::phase(); 0 without a running lesson.
    double shortPhase() const { return running() ? trainer_->heard().shortPhase : 0; }
    /// The visor and the eye of the window's picture, see WornVisor. They are those of lesson().look.
    const WornVisor& visor() const { return visor_; }
    /// Another's torch beside one's own, in attempts only.
    AttemptGhost& ghost() { return ghost_; }
    const AttemptGhost& ghost() const { return ghost_; }
    /// Whose it is and how it is paced, the same in every lesson; all idle where a lesson allows none.
    ParameterSection& ghostSection() { return ghostSection_; }
    /// The ghost for this eye, or for the middle between two, in the world of `scene`; none outside an attempt. `zoom`:
    /// see AttemptGhost::markers(). Valid until the next call.
    std::span<const Marker> ghostMarkers(const SceneView& scene, const View& eye, float zoom = 1);

    /// The torch of the last steps came from `held`, not from the controls.
    bool held() const { return held_; }

    /// The fault that stopped the simulation; empty while it runs.
    const std::string& fault() const { return fault_; }
    void fillFigures(LessonFigures& figures) const;
    /// The torch of the last step. Only while running().
    const TorchSample& torch() const { return trainer_->torch(); }
    /// The torch that mouse and keys lead, in a weld lesson.
    const DeskTorch& deskTorch() const { return desk_; }
    /// What the metal's temperature numbers mean. Only while running().
    TemperatureMeaning temperature() const { return trainer_->scene().temperature; }
    size_t steps() const { return trainer_ == nullptr ? 0 : trainer_->steps(); }
    const Lesson& lesson() const { return lesson_; }
    /// The workpiece, or the classic metal's particles, are others than the lesson's file says.
    bool workpieceChanged();
    LessonSections& sections() { return *sections_; }

  private:
    void openCues();
    bool takeOverChanges(const Controls& controls);
    void makeTrainer(const ProcessSettings* process = nullptr);
    void beginAttempt();
    void tellRecordingJudgement();
    void beginTrial();
    void nextTrial(SpeedTrial::Verdict verdict);
    void measureSpeed(double seconds, gl::Profiler* profiler);
    void settleTrial(int answer, Controls& controls);
    bool waits(const Controls& controls);
    TorchSample nextTorch(const Controls& controls, const TorchSource& held, int step, int due);
    void prepare(Controls& controls);
    glm::mat3 toScreen(const Controls& controls) const;
    void closeCut(Controls& controls);
    void placeCameraBeforeCut(Controls& controls) const;
    void inspect(const Controls& controls);
    void beginMoments();
    void keepMoment();
    bool beginDemonstration(double seconds);
    bool beginReplay(double seconds, gl::Profiler* profiler);
    void finishReplay();
    void makeStep(int step, int due, gl::Profiler* profiler);
    void makeDueSteps(double seconds, FunctionRef<void(int step, int due)> make);
    void timeSteps(int due, FunctionRef<void(int step, int due)> make);
    void guarded(FunctionRef<void()> work);
    void noteSurface();
    SceneView sceneOfMetal();

    gl::ShaderLibrary& shaders_;
    gl::OtherContext* metalThere_;
    ProcessSettings given_; ///< the lesson's own settings
    Lesson lesson_;
    std::optional<LessonSections> sections_; ///< of lesson_; always there
    SurfaceParameters shownSurface_;
    Renderer renderer_;
    std::unique_ptr<Trainer> trainer_;
    Stopwatch now_;
    StepClock clock_;
    double beside_ = 0; ///< see stepBeside()
    /// Between beginSteps() and finishSteps().
    struct {
        const Controls* controls = nullptr;
        TorchSource held;
        double seconds = 0;
        int due = 0;
    } steps_;
    std::string fault_;
    PictureDetail detail_ = kHighDetail;
    bool surfaceIsOld_ = true;
    SurfaceDistance surfaceDistance_;
    bool handLed_ = false; ///< the torch of the last step
    bool held_ = false;    ///< the torch of the last step came from a TorchSource
    bool paused_ = false;
    ParameterList wanted_;  ///< the live values of metal and process as the menus have them
    ParameterList running_; ///< the same as the running metal has them
    AttemptRecords records_;
    RecordingKeeper recordings_;
    AttemptJudge judge_;
    Redo redo_;
    CutView cut_;
    OrbitCamera cameraBeforeCut_;
    Mode modeBeforeCut_ = Mode::interact;
    AttemptCues cues_;
    ParameterSection cueSection_{"cues", describe(cues_.parameters)};
    Hearing hearing_;
    ParameterSection soundSection_{"sound", describe(hearing_.parameters)};
    WornVisor visor_;
    double sinceSeen_ = 0; ///< real s since the last picture
    AttemptGhost ghost_;
    ParameterSection ghostSection_{"ghost", describe(ghost_.parameters)};
    Question question_;
    SpeedTrial trial_;
    double trialTime_ = 0; ///< s in the demonstration
    Demonstration demonstration_;
    AttemptReplay replay_;
    DeskTorch desk_;
};

} // namespace meltpool
