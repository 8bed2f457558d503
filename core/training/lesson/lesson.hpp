// Describes a lesson as data: the metal, the torch, the duration and the view. The Trainer runs it.
#pragma once

#include "core/base/parameter.hpp"
#include "core/metal/classic/classic_parameters.hpp"
#include "core/render/look/look.hpp"
#include "core/surface/surface_parameters.hpp"
#include "core/training/feedback/cues.hpp"
#include "core/training/judging/bands.hpp"
#include "core/training/judging/cures.hpp"
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

/// Model of the metal: the thesis's, or the one that obeys physics.
enum class LessonModel { Classic, Weld };

/// Length of a run and its pictures.
struct RunParameters {
    float seconds = 10;      ///< simulated time, s
    float picturesEvery = 1; ///< s between pictures; 0: one picture at the end
    int width = 1280;        ///< pixels
    int height = 720;        ///< pixels
};

/// Effect of the source on the metal.
struct SourceParameters {
    int kind = 0; ///< 0 hot, 1 cold
};

/// A camera on a sphere around the workpiece.
struct CameraParameters {
    float azimuth = 45;     ///< degrees around the vertical, 0 is in front of the workpiece
    float elevation = 30;   ///< degrees above the horizon
    float distance = 3;     ///< model units
    float fieldOfView = 35; ///< degrees, over the picture's height
};

ParameterList describe(RunParameters& parameters);
ParameterList describe(SourceParameters& parameters);
ParameterList describe(CameraParameters& parameters);

/// The highest level of a lesson.
inline constexpr int kMostLevel = 5;

/// One of the pictures taken at each picture time.
struct PictureLook {
    std::string name; ///< part of the file's name
    LookParameters look;
    CameraParameters camera = {};
    std::optional<float> sectionAt = {}; ///< m along the seam: cut there and show the inside; weld lessons only
    bool measures = false;               ///< draw the gauge's measures into that cut

    /// Every value of this picture; the list points into it.
    ParameterList parameters();
};

/// A setting of the process that the trainee sets on the machine, within limits.
struct ChosenSetting {
    std::string key;
    double from = 0, to = 0; ///< limits in the setting's unit, both included
    /// The machine's setting before the trainee sets it; may be outside the limits.
    std::optional<double> start = {};
};

/// Values of a lesson's file that a person or a record may change.
struct OwnValues {
    WorkpieceParameters workpiece;
    ProcessSettings process;
};

struct Lesson {
    std::string key;            ///< name in the catalogue; outside it the file's name without ".toml"
    std::string title;          ///< one line for lists
    std::string text;           ///< task for the trainee
    int level = 0;              ///< 1 (first steps) to kMostLevel; 0: not given
    std::string next;           ///< key of the following lesson; empty: none
    std::filesystem::path file; ///< source file
    /// Picture for lists; by default pictures/KEY.png in the folder of the lesson's file. It need not exist.
    std::filesystem::path listPicture;
    std::filesystem::path torchFile;
    TorchPath torch;                         ///< the demonstration; empty: the torch rests with its trigger released
    std::optional<RecordedAttempt> recorded; ///< the attempt that the demonstration repeats, if any

    RunParameters run;
    LessonModel model = LessonModel::Classic;
    ClassicSetup setup;            ///< classic
    ClassicParameters metal;       ///< classic
    SourceParameters source;       ///< classic
    WorkpieceParameters workpiece; ///< weld
    ProcessSettings process;       ///< weld
    /// Weld: the settings that the trainee chooses. `process` holds the lesson's own values of them, which its
    /// demonstration uses. All other settings are given.
    std::vector<ChosenSetting> choose;
    std::optional<OwnValues> own; ///< weld: values of the file; empty for a lesson without a file
    SurfaceParameters surface;
    CameraParameters camera;
    LookParameters look;
    std::vector<PictureLook> pictures; ///< pictures, at least one; each begins with `look` and `camera`
    // Rules for judging an attempt; empty if the lesson has none.
    std::optional<TechniqueBands> technique; ///< weld
    std::optional<Acceptance> acceptance;    ///< weld
    NominalWeld nominal;                     ///< nominal sizes of the weld without the plates: see nominalWeld()
    CueSet cues = CueSet::all();             ///< cues that a trainee may see; a test has none
    bool ghost = true;                       ///< true: a trainee may have one; a test has none

    /// Every adjustable value of this lesson's model. The list points into this lesson, which must outlive it unmoved.
    ParameterList parameters();
    /// The parameters that decide the metal's behaviour.
    ParameterList metalParameters();
    /// The parameters of the process; the chosen settings have the lesson's limits as their range.
    ParameterList processParameters();

    /// Nominal sizes of the weld for the acceptance, with the thickness of the simulated plates.
    NominalWeld nominalWeld() const;

    /// Sets the chosen settings to the machine's start values.
    void takeStartSettings();
    /// Settings that the trainee must still set before the weld, a sentence; empty if all are within the limits.
    std::string unsetSettings();
    /// Numeric settings of machine and workpiece as they are and as the file has them. A given setting may differ by a
    /// fiftieth, a chosen one within its limits.
    std::vector<SettingFact> settingFacts() const;
    /// Present values of the chosen settings: "voltage 22 V, wire feed 4.5 m/min"; empty without chosen settings.
    std::string chosenText();

    /// Sets one value from text; a value of the look is set in the pictures' looks too. Throws InputError, beginning
    /// with `where`, for an unknown key or a value that does not fit; the lesson is then unchanged.
    void set(std::string_view name, std::string_view value, std::string_view where);
};

/// The files that a run of this lesson reads: lesson, torch path and the metal's own file.
std::vector<std::filesystem::path> lessonSources(const Lesson& lesson);

/// Reads and checks a lesson's file. Throws InputError naming file and line for an unknown or missing key and a value
/// out of range, in the torch path's file too.
Lesson readLesson(const std::filesystem::path& file);

/// The names of the lessons in a folder, in alphabetical order.
std::vector<std::string> lessonNames(const std::filesystem::path& folder);

/// Finds a lesson by a person's name for it: a file if the name ends in ".toml" or ".meltpool", else one of the
/// folder's. Throws InputError, listing the lessons, for an unknown name.
Lesson findLesson(const std::string& name, const std::filesystem::path& folder);

/// The lesson shown when none is named.
inline constexpr std::string_view kDefaultLesson = "classic";

} // namespace meltpool
