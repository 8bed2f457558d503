// The lesson that window and headset share: what the person does in it, and what they may do next.
#pragma once

#include "app/activities/activities.hpp"
#include "app/activities/question.hpp"
#include "app/session/controls.hpp"
#include "app/session/lesson_picture.hpp"
#include "app/session/lesson_run.hpp"
#include "app/session/lesson_sound.hpp"
#include "app/session/lesson_values.hpp"
#include "app/session/torch_lead.hpp"

#include <string>

namespace meltpool {

/// The lesson of a catalogue name or TOML file. Throws InputError when it cannot be used.
Lesson loadLesson(const std::string& name);

/// Clock of the machine, as a Stopwatch.
double machineSeconds();

/// Switches of the help that a person sees and hears during the weld, for every lesson; those without effect in this
/// one are idle.
struct HelpSections {
    ParameterSection cues, sound, ghost;
};

class LessonSession {
  public:
    /// `stopwatch` measures the steps. `metalThread`: context of the metal, see LessonMetal; it must outlive the
    /// session. Throws InputError when the shaders cannot be used.
    LessonSession(gl::ShaderLibrary& shaders, Lesson lesson, Stopwatch stopwatch = machineSeconds,
                  gl::ContextThread* metalThread = nullptr);
    ~LessonSession() { end("the program ended"); }

    /// Takes another lesson, with the values of its file. A running one ends. Earlier results of sections() become
    /// invalid.
    void open(Lesson lesson);

    /// Makes the metal from the start values: another attempt. Throws InputError or RuntimeFault when memory or driver
    /// do not suffice. See question() for a decision that must come first.
    void begin(Controls& controls);
    /// Makes the metal and plays the lesson's demonstration over it, if it has one. A demonstration has no record and
    /// is not judged; reset() ends it and begins an attempt. Throws as begin() does.
    void demonstrate(Controls& controls);
    /// Makes the metal of a stored attempt, see lessonOfAttempt(), and plays it. A replay has no record and is not
    /// judged; the menus' values do not affect it. reset() ends it and begins an attempt. Throws as begin() does.
    void openReplay(Lesson attempt, Controls& controls);
    /// Compares two stored attempts, see AttemptComparison::begin(), whose metal advance() makes and steps. Without a
    /// second one the first is compared with itself under the chosen change, see AttemptComparison::tryChange(). A
    /// running lesson ends.
    void compare(const AttemptComparison::Side& first, const AttemptComparison::Side& second = {});
    /// Puts metal and source back to their start: another attempt. Compiles no shader.
    void reset(Controls& controls);
    /// Ends the lesson and frees the metal. `reason` is written to the attempt's record.
    void end(std::string_view reason) noexcept;
    /// True while the person is in the lesson: their activity goes on over its metal.
    bool running() const { return activities_.current().inLesson(); }

    /// All activities, and the current one. Demonstration and replay are played, paused and moved through these.
    Activities& activities() { return activities_; }
    const Activities& activities() const { return activities_; }
    TorchLeader leader() const { return lead_.leader(activities_.allowed()); }
    /// True while the person's own arc burns: to interrupt the frames now would lose the hand's motion.
    bool welds() const { return activities_.allowed().ownTorch && run_.arc().burns(); }
    /// True if the lesson is paused or the weld is cut open: the last frame made no step, or steps that put a hand's
    /// arc out.
    bool paused() const { return paused_ || pausing_; }
    Attempt& attempt() { return activities_.attempt; }
    const Attempt& attempt() const { return activities_.attempt; }
    /// Files and checkpoints of the attempts.
    AttemptLog& log() { return attempt().log(); }
    const AttemptLog& log() const { return attempt().log(); }

    /// Runs the steps that fit into `seconds` of real time, also of a comparison. The torch follows `held`, or the
    /// controls if that is empty. View mode pauses the steps.
    void advance(const Controls& controls, double seconds, gl::Profiler* profiler, const TorchSource& held = {});
    /// First of the three parts of advance(); the other two belong to run(), see LessonRun::beginSteps(). `controls`
    /// must not change until the steps are finished. False: all is done.
    bool beginSteps(const Controls& controls, double seconds, gl::Profiler* profiler, const TorchSource& held = {});
    LessonRun& run() { return run_; }
    const LessonRun& run() const { return run_; }

    LessonPicture& picture() { return picture_; }
    const LessonPicture& picture() const { return picture_; }

    /// Question that the person must answer first; until then no step is made. Menus show it and set `answered`.
    Question& question() { return question_; }
    const Question& question() const { return question_; }
    /// Carries out the answer.
    void settle(Controls& controls);

    /// True if the weld can be measured and judged.
    bool judges() const { return activities_.allowed().judging && run_.trainer()->technique() != nullptr; }
    /// Judges the attempt so far, see Attempt::judge(). A fault stops the simulation.
    void judge();
    /// True if the attempt can go back to an earlier checkpoint now.
    bool redoes();
    /// Goes back to before the fault that was chosen in the log's moments(), or some seconds: restores the metal's
    /// checkpoint, and the torch welds on from there once its trigger is released. The attempt is practice from here
    /// on; one that passed is kept as it is, see Attempt::beginFromCheckpoint(). Waits for the GPU.
    void redo(Controls& controls);
    /// True if the weld can be cut open now: it can be judged, and the arc does not burn or the person has paused.
    bool cuts() const;
    /// Cuts the weld open with the desk's camera square before the cut, or closes it and restores camera and mode.
    /// While it is open no step is made; arrow keys and mouse dragging move the cut.
    void toggleCut(Controls& controls);

    /// Sound of the lesson.
    LessonSound& sound() { return sound_; }
    HelpSections& help() { return help_; }
    /// Torch that mouse and keys lead, in a weld lesson.
    const DeskTorch& deskTorch() const { return lead_.desk(); }
    LessonValues& values() { return values_; }
    const Lesson& lesson() const { return values_.lesson(); }
    LessonSections& sections() { return values_.sections(); }

  private:
    void openHelp();
    void prepare(Controls& controls);
    void makeMetal(const ProcessSettings* process = nullptr);
    void beginOver(Activity& activity);
    void beginAttempt();
    void askAboutRecord(const std::string& fault);
    void beginTrial();
    void nextTrial(SpeedTrial::Verdict verdict);
    void settleTrial(int answer, Controls& controls);
    bool waits(const Controls& controls);
    TorchSample nextTorch(int step, int steps);
    void noteSwings();
    void moveCut(const Controls& controls);
    void closeCut(Controls& controls);

    LessonValues values_;
    Activities activities_;
    LessonRun run_;
    TorchLead lead_;
    LessonPicture picture_;
    LessonSound sound_;
    HelpSections help_;
    Question question_;
    bool paused_ = false;
    size_t judgements_ = 0; ///< judgements of the last frame
    bool swings_ = false;   ///< the desk's torch swings by itself, as the record knows
    bool pausing_ = false; ///< the pause begins once the hand's arc is out
    // controls of the frame whose steps are made
    const Controls* controls_ = nullptr;
    TorchSource held_;
};

} // namespace meltpool
