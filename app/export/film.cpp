#include "app/export/film.hpp"

#include "app/platform/other_program.hpp"
#include "core/base/error.hpp"
#include "core/base/files.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace meltpool {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kFrames = "video-", kTurned = "turntable-", kVideo = "video.mp4";
constexpr size_t kFrameDigits = 6, kTurnedDigits = 3;

std::string numbered(std::string_view name, size_t digits, size_t number) {
    std::string text = std::to_string(number);
    if (text.size() < digits) text.insert(0, digits - text.size(), '0');
    return std::string(name) + text + ".png";
}

bool isNumbered(std::string_view name, std::string_view begin, size_t digits) {
    constexpr std::string_view kEnding = ".png";
    if (!name.starts_with(begin) || !name.ends_with(kEnding)) return false;
    const std::string_view number = name.substr(begin.size(), name.size() - begin.size() - kEnding.size());
    return number.size() >= digits &&
           std::all_of(number.begin(), number.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::vector<fs::path> framesIn(const fs::path& folder) {
    std::vector<fs::path> frames;
    std::error_code failure;
    for (const fs::path& file : listFolder(folder, failure))
        if (isNumbered(file.filename().string(), kFrames, kFrameDigits)) frames.push_back(file);
    return frames;
}

void write(const fs::path& file, const Image& picture) {
    try {
        writePng(file, picture);
    } catch (const InputError& error) {
        // The folder was writable when the run began: by now the disk fails, not the input.
        throw RuntimeFault(error.what());
    }
}

/// Pattern of the frames' names for ffmpeg; a percent sign in the folder's name is doubled.
std::string patternIn(const fs::path& folder) {
    std::string text;
    for (const char c : folder.string())
        text += c == '%' ? std::string("%%") : std::string(1, c);
    return (fs::path(text) / (std::string(kFrames) + "%06d.png")).string();
}

} // namespace

ParameterList describe(FilmRequest& f) {
    return {
        {"rate", "Pictures a second", "1/s", &f.rate, 1, 240,
         "Pictures of a second of the time-lapse. More make larger files."},
        {"speed", "Speed", "", &f.speed, 0.01, 1000, "Simulated seconds in each second of the time-lapse."},
        {"turntable", "Turntable", "", &f.turntable, 2, 720, "Pictures round the finished piece."},
    };
}

PictureLook filmLook(const Lesson& lesson) {
    const auto outside = std::find_if(lesson.pictures.begin(), lesson.pictures.end(),
                                      [](const PictureLook& picture) { return !picture.sectionAt; });
    PictureLook look = outside != lesson.pictures.end() ? *outside : PictureLook{"film", lesson.look};
    look.look.detail = kHighDetail;
    return look;
}

PictureLook turnedLook(PictureLook look, int index, int pictures) {
    constexpr double kRound = 360;
    const double turned = kRound * (index % pictures) / pictures;
    look.camera.azimuth = static_cast<float>(std::remainder(static_cast<double>(look.camera.azimuth) + turned, kRound));
    look.look.showSource = false;
    return look;
}

size_t Film::due(double time, double within) const {
    if (!request_.video) return 0;
    const double between = static_cast<double>(request_.speed) / request_.rate;
    const auto reached = static_cast<size_t>(std::floor((time + within) / between)) + 1; // the first is at 0 s
    return reached > frames_ ? reached - frames_ : 0;
}

void Film::add(const Image& picture, size_t times) {
    for (size_t i = 0; i < times; ++i)
        write(folder_ / numbered(kFrames, kFrameDigits, frames_++), picture);
}

void Film::addTurned(const Image& picture, int index) {
    write(folder_ / numbered(kTurned, kTurnedDigits, static_cast<size_t>(index)), picture);
}

bool isFilmFile(std::string_view name) {
    return name == kVideo || isNumbered(name, kFrames, kFrameDigits) || isNumbered(name, kTurned, kTurnedDigits);
}

std::string finishFilm(const FilmRequest& request, const fs::path& folder) {
    const std::vector<fs::path> frames = framesIn(folder);
    const auto told = [&](std::string_view key, const fs::path& place) {
        return phrase(key, {{"pictures", std::to_string(frames.size())},
                            {"seconds", PhraseNumber(static_cast<double>(frames.size()) / request.rate, 1)},
                            {"place", place.string()}});
    };
    const fs::path program = findProgram("ffmpeg");
    if (program.empty()) return told("page.film.pictures", folder / (std::string(kFrames) + "*.png"));
    std::error_code failure;
    const fs::path whole = fs::absolute(folder, failure);
    const fs::path video = whole / kVideo;
    // Usual players want both sizes even, and colours with a quarter of the pixels.
    const std::array<std::string, 15> words{"-nostdin",    "-loglevel",
                                            "error",       "-y",
                                            "-framerate",  std::to_string(request.rate),
                                            "-i",          patternIn(whole),
                                            "-vf",         "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                                            "-pix_fmt",    "yuv420p",
                                            "-q:v",        "3",
                                            video.string()};
    const int code = runToItsEnd(program, words);
    if (code != 0 || !fs::is_regular_file(video, failure))
        throw RuntimeFault("ffmpeg made no video of the time-lapse (exit code " + std::to_string(code) +
                           "); its pictures are in " + folder.string() + ", expected an ffmpeg that writes MP4");
    for (const fs::path& frame : frames)
        fs::remove(frame, failure);
    return told("page.film.video", folder / kVideo);
}

} // namespace meltpool
