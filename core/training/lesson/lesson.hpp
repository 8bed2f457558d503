// What is practised: which metal under which torch, for how long, seen how. A lesson is data; the Trainer runs it.
#pragma once

#include "core/base/parameter.hpp"
#include "core/metal/classic/classic_parameters.hpp"
#include "core/render/look/look.hpp"
#include "core/surface/surface_parameters.hpp"
#include "core/training/feedback/cues.hpp"
#include "core/training/judging/bands.hpp"
#include "core/training/judging/verdict.hpp"
#include "core/training/lesson/recorded_attempt.hpp"
#include "core/weld/process/processes.hpp"
#include "core/weld/torch/torch_path.hpp"
#include "core/weld/workpiece/workpiece.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

/// Which metal the lesson is made of: the thesis's, or the one that obeys physics.
enum class LessonModel { Classic, Weld };

/// Length of a run and what is kept of it.
struct RunParameters {
    float seconds = 10;      ///< simulated time, s
    float picturesEvery = 1; ///< s between pictures; 0: only one at the end
    int width = 1280;        ///< pixels
    int height = 720;        ///< pixels
};

/// What the source does to the metal.
struct SourceParameters {
    int kind = 0; ///< 0 hot, 1 cold
};

/// A camera on a sphere around the workpiece.
struct CameraParameters {
    float azimuth = 45;     ///< degrees around the vertical, 0 stands before the workpiece
    float elevation = 30;   ///< degrees above the horizon
    float distance = 3;     ///< model units
    float fieldOfView = 35; ///< degrees, of the picture's height
};

ParameterList describe(RunParameters& parameters);
ParameterList describe(SourceParameters& parameters);
ParameterList describe(CameraParameters& parameters);

/// The highest level of a lesson.
inline constexpr int kMostLevel = 5;

/// One of the pictures that are taken at each picture time.
struct PictureLook {
    std::string name; ///< part of the file's name
    LookParameters look;
    CameraParameters camera = {};
    std::optional<float> sectionAt = {}; ///< m along the seam: cut there and show the inside; weld lessons only
    bool measures = false;               ///< draw what the gauge measures into that cut

    /// Every value of this picture; the list points into it.
    ParameterList parameters();
};

/// A setting of the process that the trainee sets on the machine, within limits.
struct ChosenSetting {
    std::string key;
    double from = 0, to = 0; ///< in the setting's unit, both allowed
    /// Where the machine stands before the trainee sets it; may be outside of the limits.
    std::optional<double> start = {};
};

struct Lesson {
    std::string key;            ///< name in the catalogue; of a lesson from elsewhere the file's name without ".toml"
    std::string title;          ///< one line for lists
    std::string text;           ///< what the trainee is asked to do
    int level = 0;              ///< 1 (first steps) to kMostLevel; 0: the author does not say
    std::string next;           ///< key of the lesson that follows; empty: none
    std::filesystem::path file; ///< where it was read
    /// Shown in lists; by default pictures/KEY.png beside the lesson's file. It need not exist.
    std::filesystem::path listPicture;
    std::filesystem::path torchFile;
    TorchPath torch;                         ///< the demonstration; empty: the torch rests with its trigger released
    std::optional<RecordedAttempt> recorded; ///< the attempt that the demonstration repeats, where it does

    RunParameters run;
    LessonModel model = LessonModel::Classic;
    ClassicSetup setup;            ///< classic
    ClassicParameters metal;       ///< classic
    SourceParameters source;       ///< classic
    WorkpieceParameters workpiece; ///< weld
    ProcessSettings process;       ///< weld
    /// Weld: the settings that the trainee chooses. `process` holds the lesson's own values of them, with which its
    /// demonstration runs. All other settings are given.
    std::vector<ChosenSetting> choose;
    SurfaceParameters surface;
    CameraParameters camera;
    LookParameters look;
    std::vector<PictureLook> pictures; ///< at least one; each begins with `look` and `camera`
    // How an attempt is judged; nothing where the lesson does not say.
    std::optional<TechniqueBands> technique; ///< weld
    std::optional<Acceptance> acceptance;    ///< weld
    NominalWeld nominal;                     ///< what the weld was to be, but for its plates: see nominalWeld()
    CueSet cues = CueSet::all();             ///< that a trainee may be shown; an attempt for score has none
    bool ghost = true;                       ///< a trainee may have one; an attempt for score has none

    /// Every adjustable value of this lesson's model. The list points into this lesson, which must outlive it unmoved.
    ParameterList parameters();
    /// Those of them that decide what the metal does.
    ParameterList metalParameters();
    /// Those of the process; the ones to be chosen have the lesson's limits as their range.
    ParameterList processParameters();

    /// What the weld was to be, for the acceptance, with the thickness of the plates that are simulated.
    NominalWeld nominalWeld() const;

    /// Puts the settings to be chosen to where the machine stands at first.
    void takeStartSettings();
    /// What the trainee must still set before the weld, a sentence; empty where all settings are within the limits.
    std::string unsetSettings();
    /// The settings to be chosen as they are: "voltage 22 V, wire feed 4.5 m/min"; empty where there are none.
    std::string chosenText();

    /// Sets one value from text, in the pictures' looks too where it is one of the look. Throws InputError, beginning
    /// with `where`, for an unknown key or a value that does not fit; the lesson is then unchanged.
    void set(std::string_view name, std::string_view value, std::string_view where);
};

/// The files that a run of this lesson reads: its own, the torch path's, a metal's of its own.
std::vector<std::filesystem::path> lessonSources(const Lesson& lesson);

/// Reads and checks a lesson's file. Throws InputError naming file and line for anything unknown, missing or out of
/// range, in the torch path's file too.
Lesson readLesson(const std::filesystem::path& file);

/// The names of the lessons in a folder, in alphabetical order.
std::vector<std::string> lessonNames(const std::filesystem::path& folder);

/// The lesson that a person named: a file where the name ends in ".toml" or ".meltpool", else one of the folder's.
/// Throws InputError, listing what there is, for an unknown name.
Lesson findLesson(const std::string& name, const std::filesystem::path& folder);

/// The lesson that is shown where none was named.
inline constexpr std::string_view kDefaultLesson = "classic";

} // namespace meltpool
