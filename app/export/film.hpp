// A run for sharing: a time-lapse of the weld, and pictures around the finished piece.
#pragma once

#include "core/base/image.hpp"
#include "core/base/parameter.hpp"
#include "core/training/lesson/lesson.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace meltpool {

/// Films to make of a run in addition to its pictures.
struct FilmRequest {
    bool video = false; ///< true: a time-lapse
    int rate = 30;      ///< pictures per second of the time-lapse
    float speed = 4;    ///< simulated seconds per second of it
    int turntable = 0;  ///< count of pictures around the finished piece; 0: none
};
ParameterList describe(FilmRequest& film);

/// Look of time-lapse and turntable: the lesson's first picture that is no section, with all detail.
PictureLook filmLook(const Lesson& lesson);

/// Look of a turntable of `pictures` in its picture `index`, without the torch: once around the vertical from 0 to
/// `pictures`, which are identical.
PictureLook turnedLook(PictureLook look, int index, int pictures);

/// Writer of the pictures in a run's folder: video-000000.png, .. and turntable-000.png, ..
class Film {
  public:
    Film(const FilmRequest& request, std::filesystem::path folder) : request_(request), folder_(std::move(folder)) {}

    /// Count of the time-lapse's pictures due at `time` s, up to `within` s after it. More than one if the time-lapse
    /// is slower than the steps.
    size_t due(double time, double within) const;
    /// Adds a picture to the time-lapse so many times. Throws RuntimeFault when it cannot be written.
    void add(const Image& picture, size_t times);
    void addTurned(const Image& picture, int index);
    const FilmRequest& request() const { return request_; }

  private:
    FilmRequest request_;
    std::filesystem::path folder_;
    size_t frames_ = 0;
};

/// True if a film's file in a run's folder has this name.
bool isFilmFile(std::string_view name);

/// Makes video.mp4 of the time-lapse in the folder if ffmpeg is in PATH, and then removes the pictures. Returns a
/// sentence about the results. Throws RuntimeFault when ffmpeg fails; the pictures stay.
std::string finishFilm(const FilmRequest& request, const std::filesystem::path& folder);

} // namespace meltpool
