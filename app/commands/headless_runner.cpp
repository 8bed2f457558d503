#include "app/commands/headless_runner.hpp"

#include "app/activities/attempt_ghost.hpp"
#include "app/export/mesh_file.hpp"
#include "app/platform/program_info.hpp"
#include "app/platform/progress_bar.hpp"
#include "app/platform/say.hpp"
#include "app/report/attempt_pictures.hpp"
#include "app/session/seeing.hpp"
#include "core/base/error.hpp"
#include "core/base/resources.hpp"
#include "core/base/text.hpp"
#include "core/base/words.hpp"
#include "core/render/picture_target.hpp"
#include "core/render/renderer.hpp"
#include "core/training/feedback/sound/sound_track.hpp"
#include "core/training/trainer/result_file.hpp"
#include "core/weld/workpiece/simulated_size.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>
#include <vector>

namespace meltpool {

namespace {

constexpr double kTimeToLight = 0.2; ///< s of a pulled trigger in which an arc strikes
constexpr int kSamples = 4;          ///< samples of a pixel, for smooth edges
constexpr double kLongAgo = 10;      ///< s since the last picture, for a ghost that need not move smoothly
constexpr int kManyPixels = 4096 * 2304;

/// Above kManyPixels the samples would cost gigabytes, and pixels that small need none.
int samplesFor(const RunParameters& run) {
    return run.width * run.height > kManyPixels ? 1 : kSamples;
}

/// Taker of the lesson's pictures at their times.
class Photographer {
  public:
    Photographer(gl::ShaderLibrary& shaders, LessonScene& scene, const RunParameters& run, const FilmRequest& film,
                 std::filesystem::path folder)
        : scene_(scene),
          renderer_(shaders, cacheFolder()),
          target_(run.width, run.height, samplesFor(run)),
          film_(film, folder),
          folder_(std::move(folder)),
          every_(static_cast<double>(run.picturesEvery)) {}

    /// Shows another torch in the pictures from now on; an empty path shows none.
    void showGhost(const Trainer& trainer, const TorchPath& torch) {
        ghost_.parameters.ghost = static_cast<int>(GhostChoice::file);
        ghost_.open(trainer.lesson());
        ghost_.begin(trainer, torch);
    }

    /// Updates the visors that darken by themselves and the eyes that adapt, which depend on the past; call it after
    /// each step.
    void see(const Trainer& trainer) {
        const std::vector<PictureLook>& pictures = trainer.lesson().pictures;
        seen_.resize(pictures.size());
        for (size_t i = 0; i < pictures.size(); ++i) {
            const LookParameters& look = pictures[i].look;
            if (!hasPast(look)) continue;
            const SeenArc arc = seenArc(scene_.view(), {}, trainer.arc().length);
            seen_[i].update({arc.intensity, arc.height, true, arc.towards}, visorOf(look), look, trainer.timeStep());
        }
    }

    void takeDue(Trainer& trainer, bool last) {
        const double half = trainer.timeStep() / 2;
        const bool due = every_ > 0 && trainer.time() + half >= static_cast<double>(taken_) * every_;
        const size_t frames = film_.due(trainer.time(), half);
        if (!due && !last && frames == 0) return;
        trainer.lesson().look.detail = mostDetail(trainer.lesson());
        scene_.updateSurface(nullptr);
        ghost_.update(trainer, false, 1, kLongAgo);
        if (frames > 0) film_.add(picture(trainer, filmLook(trainer.lesson())), frames);
        if (due || last) takePictures(trainer);
        if (last) turn(trainer);
    }

  private:
    /// Greatest detail of all pictures: the surface holds the data for it.
    int mostDetail(const Lesson& lesson) const {
        const bool filmed = film_.request().video || film_.request().turntable > 0;
        int most = filmed ? filmLook(lesson).look.detail : static_cast<int>(kLowDetail);
        for (const PictureLook& picture : lesson.pictures)
            most = std::max(most, picture.look.detail);
        return most;
    }

    static bool hasPast(const LookParameters& look) { return look.adaptation || look.visorLightShade > 0; }

    void takePictures(Trainer& trainer) {
        ++taken_;
        const std::vector<PictureLook>& pictures = trainer.lesson().pictures;
        seen_.resize(pictures.size());
        for (size_t i = 0; i < pictures.size(); ++i) {
            PictureLook picture = pictures[i];
            if (hasPast(picture.look)) seen_[i].wear(visorOf(picture.look), picture.look);
            keep(trainer, picture);
        }
    }

    /// Takes the turntable's pictures of the piece alone: an arc that still burns gives no light.
    void turn(Trainer& trainer) {
        const int pictures = film_.request().turntable;
        const auto putOut = [](SceneView& scene, const View&) { scene.arc = {}; };
        for (int i = 0; i < pictures; ++i) {
            const PictureLook look = turnedLook(filmLook(trainer.lesson()), i, pictures);
            film_.addTurned(takePicture(renderer_, target_, scene_, look, putOut), i);
        }
    }

    Image picture(Trainer& trainer, const PictureLook& look) {
        const auto ghost = [&](SceneView& scene, const View& view) {
            if (look.look.showSource && !look.sectionAt) scene.ghost = ghost_.markers(trainer, scene, view);
        };
        return takePicture(renderer_, target_, scene_, look, ghost);
    }

    void keep(Trainer& trainer, const PictureLook& look) {
        const Image image = picture(trainer, look);
        try {
            writePng(folder_ / runPictureName(trainer.time(), look.name), image);
        } catch (const InputError& error) {
            // The folder was writable when the run began: by now the disk fails, not the input.
            throw RuntimeFault(error.what());
        }
    }

    LessonScene& scene_;
    Renderer renderer_;
    AttemptGhost ghost_;
    std::vector<WornVisor> seen_; ///< one for each of the lesson's pictures
    PictureTarget target_;
    Film film_;
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
    context.date = formatDate(std::chrono::system_clock::now());
    return context;
}

class Run {
  public:
    Run(const gl::ContextInfo& driver, Trainer& trainer, LessonScene& scene, const RunPlaces& places,
        const RunHooks& hooks)
        : driver_(driver), trainer_(trainer), scene_(scene), places_(places), hooks_(hooks) {}

    LessonResult toTheEnd(gl::ShaderLibrary& shaders, const RunStop& stop) {
        try {
            steps(shaders, stop);
            trainer_.stopRecord();
            requireRecorded();
            stop.grant();
            writeSound();
            keepMesh(shaders);
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
        const size_t whole = stepsOfRun(trainer_); // before a change of values at some time
        if (hooks_.start) hooks_.start(trainer_);
        const size_t before = trainer_.steps();
        if (before > 0) trainer_.event("begun_at", std::to_string(before));
        Photographer photographer(shaders, scene_, run, hooks_.film, places_.folder);
        if (!hooks_.ghost.empty()) photographer.showGhost(trainer_, hooks_.ghost);
        ProgressBar bar(trainer_.lesson().key);
        photographer.takeDue(trainer_, whole <= before);
        for (size_t step = before + 1; step <= whole; ++step) {
            if (stop.asked()) throw RuntimeFault("the run was stopped before its end");
            advance();
            if (!places_.sound.empty()) sound_.add(trainer_.heard());
            requireRecorded();
            requireFinite(trainer_);
            photographer.see(trainer_);
            photographer.takeDue(trainer_, step == whole);
            bar.show(static_cast<double>(step), static_cast<double>(whole));
        }
    }

    void advance() {
        trainer_.applyRecordedChanges();
        const TorchSample torch = hooks_.torch ? hooks_.torch(trainer_) : trainer_.demonstration();
        if (torch.trigger > 0) pulledSeconds_ += static_cast<double>(trainer_.timeStep());
        trainer_.advance(torch, nullptr);
    }

    void keepMesh(gl::ShaderLibrary& shaders) const {
        if (places_.mesh.empty()) return;
        try {
            writeMesh(shaders, scene_, places_.mesh);
        } catch (const InputError& error) { // as with pictures: the file was writable when the run began
            throw RuntimeFault(error.what());
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
        context.surfaceBytes = scene_.surface().bytes();
        if (const auto& recorded = trainer_.lesson().recorded) context.attempt = factsOf(*recorded);
        context.whatIf = hooks_.whatIf;
        context.warnings = hooks_.warnings;
        if (const std::string late = arcWarning(context.judgement); error.empty() && !late.empty()) {
            context.warnings.push_back(late);
            if (hooks_.warn) hooks_.warn(late);
        }
        writeTables(context.judgement);
        writeResult(places_.result, trainer_.lesson(), result, context);
        return result;
    }

    /// Warning for a weld whose arc never burned though its trigger was pulled; empty: it burned, or a warning named
    /// the reason.
    std::string arcWarning(const Judgement& judgement) const {
        const Lesson& lesson = trainer_.lesson();
        if (lesson.model != LessonModel::Weld || !isArcWelding(lesson.process) || judgement.arc.seconds > 0 ||
            pulledSeconds_ < kTimeToLight || !hooks_.warnings.empty())
            return {};
        return phrase("run.never_lit", {{"lesson", quote(lesson.key)}});
    }

    void writeSound() const {
        if (places_.sound.empty()) return;
        try {
            sound_.write(places_.sound);
        } catch (const InputError& error) {
            // The place was writable when the run began: by now the disk fails, not the input.
            throw RuntimeFault(error.what());
        }
    }

    /// Writes the measurements along the seam, of the hand and of the weld.
    void writeTables(const Judgement& judgement) const {
        if (trainer_.technique() != nullptr)
            writeTechniqueCsv(places_.folder / "technique.csv", judgement.seam, judgement.distance);
        if (judgement.weld) writeWeldTable(places_.folder / "weld.csv", *judgement.weld);
    }

    /// Stores the results so far after a failure; a second failure must not hide the first.
    void keepWhatThereIs(const std::string& error) {
        try {
            trainer_.stopRecord(error);
        } catch (const std::exception&) {
        }
        try {
            writeSound();
        } catch (const std::exception&) {
        }
        try {
            keepResult(error);
        } catch (const std::exception&) {
        }
    }

    const gl::ContextInfo& driver_;
    Trainer& trainer_;
    LessonScene& scene_;
    RunPlaces places_;
    SoundTrack sound_;
    double pulledSeconds_ = 0; ///< s with the trigger pulled
    const RunHooks& hooks_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Prints the workpiece's sizes, rounded to whole layers of particles, before the weld.
void tellSizes(const Lesson& lesson) {
    if (lesson.model != LessonModel::Weld) return;
    const std::string text = simulatedSizesText(lesson.workpiece);
    if (!text.empty()) say("%s\n", text.c_str());
}

} // namespace

LessonResult runHeadless(const gl::ContextInfo& driver, gl::ShaderLibrary& shaders, const Lesson& lesson,
                         const RunPlaces& places, const RunStop& stop, const RunHooks& hooks) {
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
    std::optional<LessonScene> scene;
    try {
        trainer.emplace(shaders, lesson);
        scene.emplace(shaders, *trainer);
    } catch (const std::exception& fault) {
        stop.grant();
        writeUnfinishedResult(places.result, copy, contextOf(driver, fault.what()));
        throw;
    }
    tellSizes(lesson);
    return Run(driver, *trainer, *scene, places, hooks).toTheEnd(shaders, stop);
}

void requireFinite(const Trainer& trainer) {
    const size_t broken = trainer.figures().nonFinite;
    if (broken == 0) return;
    char sentence[200];
    std::snprintf(sentence, sizeof sentence,
                  "the metal became unstable at %.3f s (%zu particle states were not finite); expected a shorter time "
                  "step, less heat or a lower gas stiffness",
                  trainer.time(), broken);
    throw RuntimeFault(sentence);
}

size_t stepsOfRun(const Trainer& trainer) {
    const Lesson& lesson = trainer.lesson();
    if (lesson.recorded && lesson.run.seconds == static_cast<float>(lesson.torch.duration()))
        return lesson.recorded->rows;
    return stepsFor(static_cast<double>(lesson.run.seconds), trainer.timeStep());
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
