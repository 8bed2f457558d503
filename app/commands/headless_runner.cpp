#include "app/commands/headless_runner.hpp"

#include "app/program/program_info.hpp"
#include "app/program/progress_bar.hpp"
#include "core/base/error.hpp"
#include "core/render/renderer.hpp"
#include "core/render/view/camera.hpp"
#include "core/render/view/picture_target.hpp"
#include "core/training/result_file.hpp"
#include "core/training/verdict/section_measures.hpp"

#include <glm/trigonometric.hpp>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>

namespace meltpool {

namespace {

constexpr int kSamples = 4; ///< of a pixel, for smooth edges
constexpr int kManyPixels = 4096 * 2304;

/// Above kManyPixels the samples would cost gigabytes, and pixels that small need none.
int samplesFor(const RunParameters& run) {
    return run.width * run.height > kManyPixels ? 1 : kSamples;
}

View viewOf(const CameraParameters& camera, float aspect) {
    Lens lens;
    lens.fieldOfView = glm::radians(camera.fieldOfView);
    const OrbitCamera orbit(glm::radians(camera.azimuth), glm::radians(camera.elevation), camera.distance);
    return orbit.view(lens, aspect);
}

/// What the gauge measures on a section, drawn into its picture as a station of the weld is judged.
std::vector<SectionStroke> measureStrokes(const WeldSection& section, const WorkpieceParameters& workpiece,
                                          const View& view, const SceneView& scene) {
    const WeldKind kind = weldKindOf(workpiece);
    const WeldStation station = stationOf(section.figures, kind, section.cut.at());
    std::vector<SectionStroke> strokes;
    layOutMarks(sectionMarks(station, kind, section.map, section.cut.fusion, SectionFaces::of(workpiece)),
                layoutIn(view, scene.modelToWorld, scene.section.at), strokes);
    return strokes;
}

/// Takes the lesson's pictures at their times.
class Photographer {
  public:
    Photographer(gl::ShaderLibrary& shaders, const RunParameters& run, std::filesystem::path folder)
        : renderer_(shaders),
          target_(run.width, run.height, samplesFor(run)),
          folder_(std::move(folder)),
          every_(static_cast<double>(run.picturesEvery)) {}

    void takeDue(Trainer& trainer, bool last) {
        const double half = trainer.timeStep() / 2;
        const bool due = every_ > 0 && trainer.time() + half >= static_cast<double>(taken_) * every_;
        if (!due && !last) return;
        ++taken_;
        trainer.updateSurface(nullptr);
        for (const PictureLook& picture : trainer.lesson().pictures)
            take(trainer, picture);
    }

  private:
    void take(Trainer& trainer, const PictureLook& picture) {
        const float aspect = static_cast<float>(target_.width()) / static_cast<float>(target_.height());
        const View view = viewOf(picture.camera, aspect);
        SceneView scene = trainer.scene();
        if (!picture.look.showSource) scene.solids = {}; // the torch is the source of a weld
        std::optional<WeldSection> section;
        if (picture.sectionAt) {
            section = trainer.section(static_cast<double>(*picture.sectionAt));
            scene.section = {true, *picture.sectionAt, section ? &section->map : nullptr};
            scene.solids = {};
        }
        std::vector<SectionStroke> strokes;
        if (picture.measures && section) {
            strokes = measureStrokes(*section, trainer.lesson().workpiece, view, scene);
            scene.section.strokes = strokes;
        }
        renderer_.draw(scene, picture.look, {&view, 1}, target_.target(), nullptr);
        try {
            writePng(folder_ / runPictureName(trainer.time(), picture.name), target_.read());
        } catch (const InputError& error) {
            // The folder was writable when the run began: by now it is the disk that fails, not the input.
            throw RuntimeFault(error.what());
        }
    }

    Renderer renderer_;
    PictureTarget target_;
    std::filesystem::path folder_;
    double every_;
    size_t taken_ = 0;
};

ResultContext contextOf(const gl::ContextInfo& driver, const std::string& error) {
    ResultContext context;
    context.version = programVersion();
    context.commit = programCommit();
    context.renderer = driver.renderer;
    context.error = error;
    return context;
}

/// Steps of the whole run: those of the recorded attempt where it is repeated to its end.
size_t stepsOf(const Trainer& trainer) {
    const Lesson& lesson = trainer.lesson();
    if (lesson.recorded && lesson.run.seconds == static_cast<float>(lesson.torch.duration()))
        return lesson.recorded->rows;
    return stepsFor(static_cast<double>(lesson.run.seconds), trainer.timeStep());
}

class Run {
  public:
    Run(const gl::ContextInfo& driver, Trainer& trainer, const RunPlaces& places)
        : driver_(driver), trainer_(trainer), places_(places) {}

    LessonResult toTheEnd(gl::ShaderLibrary& shaders, const RunStop& stop) {
        try {
            steps(shaders, stop);
            trainer_.stopRecord();
            requireRecorded();
            stop.grant();
            return keepResult("");
        } catch (const std::exception& error) {
            stop.grant();
            keepWhatThereIs(error.what());
            throw;
        }
    }

  private:
    void steps(gl::ShaderLibrary& shaders, const RunStop& stop) {
        trainer_.waitForFigures(true);
        RecordContext context;
        context.program = programBuild();
        context.driver = driver_.renderer;
        trainer_.record(places_.telemetry, context);
        const RunParameters& run = trainer_.lesson().run;
        const size_t whole = stepsOf(trainer_);
        Photographer photographer(shaders, run, places_.folder);
        ProgressBar bar(trainer_.lesson().key);
        photographer.takeDue(trainer_, whole == 0);
        for (size_t step = 1; step <= whole; ++step) {
            if (stop.asked()) throw RuntimeFault("the run was stopped before its end");
            trainer_.advanceDemonstration(nullptr);
            requireRecorded();
            requireFinite(trainer_);
            photographer.takeDue(trainer_, step == whole);
            bar.show(static_cast<double>(step), static_cast<double>(whole));
        }
    }

    void requireRecorded() const {
        if (!trainer_.recordFault().empty()) throw RuntimeFault(trainer_.recordFault());
    }

    LessonResult keepResult(const std::string& error) {
        const LessonResult result = trainer_.result();
        const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
        ResultContext context = contextOf(driver_, error);
        context.wallSeconds = wall;
        context.section = trainer_.section();
        context.judgement = trainer_.judge();
        writeTables(context.judgement);
        writeResult(places_.result, trainer_.lesson(), result, context);
        return result;
    }

    /// What was measured along the seam, by the hand and on the weld.
    void writeTables(const Judgement& judgement) const {
        if (trainer_.technique() != nullptr)
            writeTechniqueCsv(places_.folder / "technique.csv", judgement.seam, judgement.distance);
        if (judgement.weld) writeWeldTable(places_.folder / "weld.csv", *judgement.weld);
    }

    /// After a failure; a second one must not hide the first.
    void keepWhatThereIs(const std::string& error) {
        try {
            trainer_.stopRecord(error);
        } catch (const std::exception&) {
        }
        try {
            keepResult(error);
        } catch (const std::exception&) {
        }
    }

    const gl::ContextInfo& driver_;
    Trainer& trainer_;
    RunPlaces places_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

} // namespace

LessonResult runHeadless(const gl::ContextInfo& driver, gl::ShaderLibrary& shaders, const Lesson& lesson,
                         const RunPlaces& places, const RunStop& stop) {
    Lesson copy = lesson;
    writeUnfinishedResult(places.result, copy,
                          contextOf(driver, "the run has not ended; if it is over, it was killed"));
    stop.endAfter([&] {
        try {
            writeUnfinishedResult(places.result, copy,
                                  contextOf(driver, "the run was stopped in the middle of a long step"));
        } catch (const std::exception&) {
        }
    });
    std::optional<Trainer> trainer;
    try {
        trainer.emplace(shaders, lesson);
    } catch (const std::exception& fault) {
        stop.grant();
        writeUnfinishedResult(places.result, copy, contextOf(driver, fault.what()));
        throw;
    }
    return Run(driver, *trainer, places).toTheEnd(shaders, stop);
}

void requireFinite(const Trainer& trainer) {
    const size_t broken = trainer.figures().nonFinite;
    if (broken == 0) return;
    char sentence[200];
    std::snprintf(sentence, sizeof sentence,
                  "the metal stopped being finite at %.3f s (%zu times); a shorter time step, less heat or a lower "
                  "gas stiffness may keep it stable",
                  trainer.time(), broken);
    throw RuntimeFault(sentence);
}

size_t stepsFor(double seconds, double timeStep) {
    // A time step is a rounded float: 10 s of 1/60 are 600 steps, not 601 for the last bit.
    return static_cast<size_t>(std::ceil(seconds / timeStep * (1 - 1e-6)));
}

std::string runPictureName(double time, const std::string& look) {
    char name[64];
    std::snprintf(name, sizeof name, "%07.3fs-", time);
    return name + look + ".png";
}

} // namespace meltpool
