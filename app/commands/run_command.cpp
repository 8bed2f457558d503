#include "app/commands/commands.hpp"

#include "app/activities/attempt_ghost.hpp"
#include "app/commands/headless_runner.hpp"
#include "app/commands/named_lesson.hpp"
#include "app/commands/run_folder.hpp"
#include "app/export/mesh_file.hpp"
#include "app/platform/program_info.hpp"
#include "app/platform/say.hpp"
#include "app/platform/stop_signals.hpp"
#include "core/base/error.hpp"
#include "core/base/output_file.hpp"
#include "core/base/resources.hpp"
#include "core/base/text.hpp"
#include "core/base/words.hpp"
#include "core/gl/software_driver/software_driver.hpp"
#include "core/training/attempt/record_text.hpp"
#include "core/training/lesson/lesson.hpp"
#include "core/training/lesson/lesson_capacity.hpp"
#include "core/training/trainer/repetition.hpp"

#include <array>
#include <chrono>
#include <cstdio>

namespace meltpool {

namespace {

/// Time after which a run that was asked to stop, but is in the middle of a long step, is ended.
constexpr std::chrono::seconds kPatience(2);

/// Text from a file or a person, made safe for the terminal.
std::string shown(const std::string& text) {
    constexpr size_t kMostBytes = 1000;
    return printable(text, kMostBytes);
}

void setSize(Lesson& lesson, const std::string& size) {
    const size_t cross = size.find('x');
    if (cross == std::string::npos)
        throw InputError("--size is " + quote(size) + "; expected WIDTHxHEIGHT in pixels, such as 1280x720");
    lesson.set("width", size.substr(0, cross), "--size " + size);
    lesson.set("height", size.substr(cross + 1), "--size " + size);
}

/// Throws if a file that the run writes is one that it reads.
void requireNoSource(const char* option, const std::filesystem::path& written,
                     const std::vector<std::filesystem::path>& sources) {
    for (const auto& source : sources) {
        std::error_code missing;
        if (!written.empty() && std::filesystem::equivalent(written, source, missing))
            throw InputError(written, 0,
                             std::string(option) + " names a file that the run reads; expected another file");
    }
}

/// Throws unless the file for the sound can be written and there is sound.
void requireSound(const std::filesystem::path& sound, const Lesson& lesson) {
    if (sound.empty()) return;
    if (lesson.model != LessonModel::Weld)
        throw InputError(
            sound, 0,
            "--sound is for weld lessons, and a classic lesson has no arc; expected a weld lesson, or no --sound");
    requireNoSource("--sound", sound, lessonSources(lesson));
    requireWritable(sound);
}

/// Path of the ghost in the pictures; empty if none is asked for.
TorchPath requestedGhost(const RunRequest& request, const Lesson& lesson) {
    if (request.ghost.empty()) return {};
    if (lesson.model != LessonModel::Weld)
        throw InputError("--ghost is for weld lessons, and " + quote(lesson.key) +
                         " is not one; expected a lesson with a seam, or no --ghost");
    TorchPath torch = ghostTorch(lesson, request.ghost);
    if (!torch.firstPull())
        throw InputError(request.ghost, 0, "never pulls the trigger; expected a path that welds, for --ghost");
    return torch;
}

FilmRequest requestedFilm(const RunRequest& request) {
    FilmRequest film;
    film.video = request.video;
    const ParameterList list = describe(film);
    if (!request.videoRate.empty()) setParameter(list, "rate", request.videoRate, "--video-rate");
    if (!request.videoSpeed.empty()) setParameter(list, "speed", request.videoSpeed, "--video-speed");
    if (!request.turntable.empty()) setParameter(list, "turntable", request.turntable, "--turntable");
    if (!film.video && !(request.videoRate.empty() && request.videoSpeed.empty()))
        throw InputError("--video-rate and --video-speed are for a time-lapse; expected --video too");
    return film;
}

/// True for a weld that spends its time on steps.
bool hasFewPictures(const Lesson& lesson, const FilmRequest& film) {
    return lesson.model == LessonModel::Weld && lesson.run.picturesEvery == 0 && !film.video && film.turntable == 0;
}

/// Coldest and hottest: "20 to 2310 °C"; of the classic metal, whose scale has no unit, "0 to 0.53 (solid is 0, liquid
/// 1)".
std::string temperatures(const Lesson& lesson, const MetalStatistics& metal) {
    if (lesson.model == LessonModel::Weld)
        return phrase("run.temperature.weld", {{"coldest", PhraseNumber(celsius(metal.minTemperature))},
                                               {"hottest", PhraseNumber(celsius(metal.maxTemperature))}});
    const auto number = [](double value) {
        std::array<char, 24> text{};
        std::snprintf(text.data(), text.size(), "%.3g", value);
        return std::string(text.data());
    };
    return phrase("run.temperature.classic",
                  {{"coldest", number(metal.minTemperature)}, {"hottest", number(metal.maxTemperature)}});
}

std::string endText(const Lesson& lesson, const LessonResult& result, const std::filesystem::path& folder) {
    return phrase("run.end", {{"lesson", shown(lesson.key)},
                              {"seconds", PhraseNumber(result.seconds, 2)},
                              {"steps", std::to_string(result.steps)},
                              {"molten", std::to_string(result.metal.molten)},
                              {"particles", std::to_string(result.metal.particles)},
                              {"temperatures", temperatures(lesson, result.metal)},
                              {"lost", std::to_string(result.metal.lost)},
                              {"folder", shown(folder.string())}});
}

} // namespace

Lesson requestedLesson(const RunRequest& request) {
    Lesson lesson = namedLesson(request.lesson, LessonFolders::ofUser());
    if (!request.torch.empty()) takeTorch(lesson, request.torch);
    for (const std::string& pair : request.sets) {
        const size_t equals = pair.find('=');
        if (equals == std::string::npos || equals == 0)
            throw InputError("--set is " + quote(pair) + "; expected KEY=VALUE, such as particles=8192");
        lesson.set(pair.substr(0, equals), pair.substr(equals + 1), "--set " + printable(pair, 80));
    }
    if (!request.seconds.empty()) lesson.set("seconds", request.seconds, "--seconds");
    if (!request.picturesEvery.empty()) lesson.set("pictures_every", request.picturesEvery, "--pictures");
    if (!request.size.empty()) setSize(lesson, request.size);
    if (lesson.model == LessonModel::Weld) workpieceMaterial(lesson.workpiece); // throws for an unknown metal
    return lesson;
}

void runLesson(const RunRequest& request) {
    StopSignals signals;
    signals.endAfter(kPatience, {});
    Lesson lesson = requestedLesson(request);
    lesson.ghost = lesson.ghost || !request.ghost.empty(); // a headless run is no practice
    RunHooks hooks;
    hooks.ghost = requestedGhost(request, lesson);
    hooks.film = requestedFilm(request);
    std::vector<std::filesystem::path> sources = lessonSources(lesson);
    if (!request.ghost.empty()) sources.push_back(request.ghost);
    requireNoSource("--record", request.record, sources);
    if (!request.record.empty()) requireWritable(request.record);
    requireSound(request.sound, lesson);
    requireNoSource("--mesh", request.mesh, sources);
    if (!request.mesh.empty()) meshFormat(request.mesh); // throws for an unknown ending
    RunFolder folder(request.folder.empty() ? newRunFolder({}, lesson.key) : request.folder, sources);
    if (!request.mesh.empty()) requireWritable(request.mesh); // it may be in the folder
    if (hasFewPictures(lesson, hooks.film)) gl::runDriverSingleThreaded();
    const gl::HeadlessContext context;
    gl::ShaderLibrary shaders(resourceFolder() / "shaders");
    requireCapacity(lesson, machineCapacity());
    tellForm(lesson.torchFile, lesson.torch);
    if (!request.ghost.empty()) tellForm(request.ghost, hooks.ghost);
    hooks.warnings = tellWarnings(lesson, !request.seconds.empty());
    hooks.warn = warn;
    if (const size_t removed = folder.clear(); removed > 0) say("%s\n", removedText(folder.path(), removed).c_str());
    RunStop stop;
    stop.asked = StopSignals::asked;
    stop.grant = [&signals] { signals.grantStop(); };
    stop.endAfter = [&signals](const std::function<void()>& last) { signals.endAfter(kPatience, last); };
    const auto& telemetry = request.record.empty() ? folder.telemetry() : request.record;
    const LessonResult result =
        runHeadless(context.info(), shaders, lesson,
                    {folder.result(), telemetry, folder.path(), request.sound, request.mesh}, stop, hooks);
    say("%s\n", endText(lesson, result, folder.path()).c_str());
    sayResult({}, folder.result());
    if (hooks.film.video) say("%s\n", shown(finishFilm(hooks.film, folder.path())).c_str());
    if (!request.mesh.empty()) sayResult(phrase("run.mesh", {{"file", shown(request.mesh.string())}}), request.mesh);
    if (lesson.recorded)
        say("%s\n", repetitionText(*lesson.recorded, result, programBuild(), context.info().renderer).c_str());
}

} // namespace meltpool
