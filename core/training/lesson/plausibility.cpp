#include "core/training/lesson/plausibility.hpp"

#include "core/base/text.hpp"
#include "core/base/words.hpp"
#include "core/training/judging/seam.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace meltpool {

namespace {

constexpr double kGrain = 0.05; ///< s between the examined moments of an authored path
constexpr size_t kMostPlaces = 20000;
constexpr double kHour = 3600;      ///< s
constexpr double kReach = 0.03;     ///< m around the workpiece within which a torch can weld it
constexpr double kSeamReach = 0.02; ///< m from the seam's line, for a weave and a fillet's long leg
constexpr double kFastest = 0.5;    ///< m/s, ten times the speed of laser welding
constexpr double kThousand = 1000;
constexpr double kMm = 1e-3; ///< m

std::string rounded(double value) {
    char text[40];
    std::snprintf(text, sizeof text, std::abs(value) < 100 ? "%.3g" : "%.0f", value);
    return text;
}

/// Places of the torch with the trigger pulled, or all places of a path that never pulls it.
class WeldedPlaces {
  public:
    explicit WeldedPlaces(const TorchPath& path) {
        std::vector<glm::dvec3> others;
        const auto add = [&](const TorchSample& torch) {
            if (torch.seen) (torch.trigger > 0 ? places_ : others).emplace_back(torch.tip);
        };
        for (const TorchSample& torch : path.samples())
            add(torch);
        const double grain = std::max(kGrain, path.duration() / static_cast<double>(kMostPlaces));
        for (double time = 0; path.samples().empty() && time <= path.duration(); time += grain)
            add(path.sample(time));
        if (places_.empty()) places_ = std::move(others);
        for (const glm::dvec3& place : places_) {
            low_ = glm::min(low_, place);
            high_ = glm::max(high_, place);
        }
    }

    const std::vector<glm::dvec3>& all() const { return places_; }
    const glm::dvec3& low() const { return low_; }
    const glm::dvec3& high() const { return high_; }
    /// Farthest place from the origin along any axis, m.
    double farthest() const {
        const glm::dvec3 most = glm::max(glm::abs(low_), glm::abs(high_));
        return std::max({most.x, most.y, most.z});
    }
    /// Longest extent along an axis, m.
    double span() const {
        const glm::dvec3 size = high_ - low_;
        return std::max({size.x, size.y, size.z});
    }

  private:
    std::vector<glm::dvec3> places_;
    glm::dvec3 low_{std::numeric_limits<double>::infinity()};
    glm::dvec3 high_{-std::numeric_limits<double>::infinity()};
};

/// "x from -50 to 50, y from -6 to 0, z from -25 to 25 mm"
std::string boxText(const glm::dvec3& low, const glm::dvec3& high) {
    return phrase("path.box", {{"x_low", rounded(low.x / kMm)},
                               {"x_high", rounded(high.x / kMm)},
                               {"y_low", rounded(low.y / kMm)},
                               {"y_high", rounded(high.y / kMm)},
                               {"z_low", rounded(low.z / kMm)},
                               {"z_high", rounded(high.z / kMm)}});
}

/// True if a path of this length would fit the workpiece (m) with its numbers multiplied by `times`.
bool fitsAfter(double length, double times, double size) {
    return length * times > size / 20 && length * times < 3 * size;
}

/// Warns of a path whose numbers fit the workpiece in another unit; else empty. `path`: its name in the sentences.
std::string unitWarning(const std::string& path, const WeldedPlaces& places, double size) {
    const auto told = [&](std::string_view key, double length) {
        return phrase(key, {{"path", path}, {"length", rounded(length / kMm)}, {"piece", rounded(size / kMm)}});
    };
    if (places.farthest() < size / 100 && fitsAfter(places.farthest(), kThousand, size))
        return told("path.too_small", places.farthest());
    if (places.span() > 20 * size && fitsAfter(places.span(), 1 / kThousand, size))
        return told("path.too_large", places.span());
    return {};
}

std::string placeWarning(const std::string& path, const Lesson& lesson, const WeldedPlaces& places,
                         const Workpiece& piece) {
    const glm::dvec3 low(piece.bodyLow), high(piece.bodyHigh);
    const auto near = [&](const glm::dvec3& place) {
        return glm::all(glm::greaterThan(place, low - kReach)) && glm::all(glm::lessThan(place, high + kReach));
    };
    if (std::none_of(places.all().begin(), places.all().end(), near))
        return phrase(
            "path.outside",
            {{"path", path}, {"path_box", boxText(places.low(), places.high())}, {"piece_box", boxText(low, high)}});
    const Seam seam = seamOf(lesson.workpiece);
    const auto onSeam = [&](const glm::dvec3& place) {
        const SeamPlace found = seam.nearest(place);
        return std::hypot(found.across, found.height) < kSeamReach &&
               (seam.closed() || (found.place > seam.begin() - kReach && found.place < seam.end() + kReach));
    };
    if (lesson.workpiece.kind != static_cast<int>(WorkpieceKind::Cube) &&
        lesson.workpiece.kind != static_cast<int>(WorkpieceKind::Bridge) &&
        lesson.workpiece.kind != static_cast<int>(WorkpieceKind::Plate) &&
        std::none_of(places.all().begin(), places.all().end(), onSeam))
        return phrase("path.off_seam", {{"path", path}, {"distance", rounded(kSeamReach / kMm)}});
    return {};
}

/// Warns of a recorded path that hurries with its trigger pulled, as one with times in another unit does.
std::string speedWarning(const std::string& name, const TorchPath& path) {
    double way = 0, time = 0;
    const std::vector<TorchSample>& samples = path.samples();
    for (size_t i = 1; i < samples.size(); ++i) {
        const TorchSample &before = samples[i - 1], &after = samples[i];
        if (before.trigger <= 0 || after.trigger <= 0 || !before.seen || !after.seen) continue;
        way += glm::length(glm::dvec3(after.tip) - glm::dvec3(before.tip));
        time += after.time - before.time;
    }
    if (time <= 0 || way < kFastest * time) return {};
    return phrase("path.too_fast", {{"path", name}, {"speed", rounded(way / time / kMm)}, {"seconds", rounded(time)}});
}

std::string pipeWarning(const std::string& path, const Lesson& lesson) {
    const bool pipe = lesson.workpiece.kind == static_cast<int>(WorkpieceKind::Pipe);
    const double written = 2 * lesson.torch.pipeRadius() / kMm;
    const auto diameter = static_cast<double>(lesson.workpiece.diameterMm);
    if (written > 0 && !pipe) return phrase("path.no_pipe", {{"path", path}, {"diameter", rounded(written)}});
    if (written > 0 && std::abs(written - diameter) > 0.5)
        return phrase("path.other_pipe",
                      {{"path", path}, {"diameter", rounded(written)}, {"piece", rounded(diameter)}});
    return {};
}

std::string triggerWarning(const std::string& path, const Lesson& lesson, bool cut) {
    const auto pull = [&]() -> std::optional<double> {
        for (const TorchSample& torch : lesson.torch.samples())
            if (torch.trigger > 0) return torch.time;
        return lesson.torch.samples().empty() ? lesson.torch.firstPull() : std::nullopt;
    }();
    if (!pull) return phrase("path.no_trigger", {{"path", path}});
    const auto seconds = static_cast<double>(lesson.run.seconds);
    if (!cut && *pull > seconds)
        return phrase("path.late_trigger", {{"path", path}, {"seconds", rounded(*pull)}, {"end", rounded(seconds)}});
    return {};
}

} // namespace

std::vector<std::string> pathWarnings(const Lesson& lesson, bool cut) {
    if (lesson.torch.empty() || lesson.recorded) return {};
    const std::string path = printable(lesson.torchFile.filename().string(), 80);
    std::vector<std::string> sentences{triggerWarning(path, lesson, cut)};
    if (lesson.torch.duration() > kHour)
        sentences.push_back(
            phrase("path.too_long", {{"path", path}, {"hours", rounded(lesson.torch.duration() / kHour)}}));
    if (lesson.model == LessonModel::Weld) {
        const WeldedPlaces places(lesson.torch);
        const Workpiece piece = makeWorkpiece(lesson.workpiece);
        const glm::vec3 size = piece.bodyHigh - piece.bodyLow;
        const std::string unit = unitWarning(path, places, static_cast<double>(std::max({size.x, size.y, size.z})));
        sentences.push_back(unit.empty() ? placeWarning(path, lesson, places, piece) : unit);
        sentences.push_back(unit.empty() ? speedWarning(path, lesson.torch) : std::string());
        sentences.push_back(pipeWarning(path, lesson));
    }
    std::erase(sentences, "");
    return sentences;
}

std::string pathFormText(const std::filesystem::path& file, const TorchPath& path) {
    constexpr size_t kMostBytes = 1000;
    if (!path.form() || path.form()->ours) return {};
    return phrase("path.form", {{"file", printable(file.string(), kMostBytes)},
                                {"form", printable(path.form()->text(), kMostBytes)}});
}

std::vector<std::string> lessonWarnings(const Lesson& lesson, const LessonFolders& catalogue) {
    std::vector<std::string> sentences;
    const std::string name = "The lesson " + printable(lesson.file.filename().string(), 80) + " ";
    if (lesson.title == lesson.key)
        sentences.push_back(name + "has no title, so lists show its file's name; expected a line such as title = "
                                   "\"Fillet weld\".");
    if (!lesson.next.empty() && catalogue.named(lesson.next).empty())
        sentences.push_back(name + "names " + quote(lesson.next) +
                            " as the next lesson, which is not in the catalogue.");
    return sentences;
}

} // namespace meltpool
