// A run as people share it: a time-lapse of the weld, and pictures round the finished piece.
#pragma once

#include "core/base/image.hpp"
#include "core/base/parameter.hpp"
#include "core/training/lesson/lesson.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace meltpool {

/// What is made of a run besides its pictures.
struct FilmRequest {
    bool video = false; ///< a time-lapse
    int rate = 30;      ///< its pictures a second
    float speed = 4;    ///< simulated seconds in each of its seconds
    int turntable = 0;  ///< pictures round the finished piece; 0: none
};
ParameterList describe(FilmRequest& film);

/// The look that time-lapse and turntable have: the lesson's first picture that is no section, with all detail.
PictureLook filmLook(const Lesson& lesson);

/// The same from the side that a turntable of `pictures` shows in its picture `index`: once round the vertical from 0
/// to `pictures`, which are the same. Without the torch.
PictureLook turnedLook(PictureLook look, int index, int pictures);

/// Writes the pictures into a run's folder: video-000000.png, .. and turntable-000.png, ..
class Film {
  public:
    Film(const FilmRequest& request, std::filesystem::path folder) : request_(request), folder_(std::move(folder)) {}

    /// How many pictures of the time-lapse are due at `time` s, as far as `within` s before it. More than one where the
    /// time-lapse is slower than the steps.
    size_t due(double time, double within) const;
    /// Adds a picture to the time-lapse so often. Throws RuntimeFault when it cannot be written.
    void add(const Image& picture, size_t times);
    void addTurned(const Image& picture, int index);
    const FilmRequest& request() const { return request_; }

  private:
    FilmRequest request_;
    std::filesystem::path folder_;
    size_t frames_ = 0;
};

/// Whether a film's file in a run's folder has this name.
bool isFilmFile(std::string_view name);

/// Makes video.mp4 of the time-lapse in the folder where ffmpeg is in PATH, and removes the pictures then. Answers what
/// there is, a sentence. Throws RuntimeFault when ffmpeg fails; the pictures stay.
std::string finishFilm(const FilmRequest& request, const std::filesystem::path& folder);

} // namespace meltpool
