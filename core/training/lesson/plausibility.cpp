#include "core/training/lesson/plausibility.hpp"

#include "core/base/text.hpp"
#include "core/training/judging/seam.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace meltpool {

namespace {

constexpr double kGrain = 0.05; ///< s between the moments of an authored path that are looked at
constexpr size_t kMostPlaces = 20000;
constexpr double kHour = 3600;      ///< s
constexpr double kReach = 0.03;     ///< m around the workpiece in which a torch may weld it
constexpr double kSeamReach = 0.02; ///< m from the seam's line, for a weave and a fillet's long leg
constexpr double kFastest = 0.5;    ///< m/s, ten times as fast as a laser welds
constexpr double kThousand = 1000;
constexpr double kMm = 1e-3; ///< m

std::string rounded(double value) {
    char text[40];
    std::snprintf(text, sizeof text, std::abs(value) < 100 ? "%.3g" : "%.0f", value);
    return text;
}

/// Where the torch is with its trigger pulled, or anywhere where it never is.
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
    /// The farthest from the origin along any axis, m.
    double farthest() const {
        const glm::dvec3 most = glm::max(glm::abs(low_), glm::abs(high_));
        return std::max({most.x, most.y, most.z});
    }
    /// Its length along the axis on which it is longest, m.
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
    std::string text;
    for (int i = 0; i < 3; ++i)
        text += std::string(i > 0 ? ", " : "") + "xyz"[i] + " from " + rounded(low[i] / kMm) + " to " +
                rounded(high[i] / kMm);
    return text + " mm";
}

/// Whether a path of this length would fit the workpiece (m) once its numbers were other ones by `times`.
bool fitsAfter(double length, double times, double size) {
    return length * times > size / 20 && length * times < 3 * size;
}

/// Of a path whose numbers fit the workpiece in another unit; empty: of none.
std::string unitWarning(const WeldedPlaces& places, double size) {
    const std::string piece =
        " mm, and the workpiece is " + rounded(size / kMm) + " mm long: it is about a thousand times too ";
    if (places.farthest() < size / 100 && fitsAfter(places.farthest(), kThousand, size))
        return "reaches " + rounded(places.farthest() / kMm) + piece +
               "small. Are its positions metres? Millimetres are expected, or a header such as X [m].";
    if (places.span() > 20 * size && fitsAfter(places.span(), 1 / kThousand, size))
        return "is " + rounded(places.span() / kMm) + piece +
               "large. Are its positions micrometres? Millimetres are expected.";
    return {};
}

std::string placeWarning(const Lesson& lesson, const WeldedPlaces& places, const Workpiece& piece) {
    const glm::dvec3 low(piece.bodyLow), high(piece.bodyHigh);
    const auto near = [&](const glm::dvec3& place) {
        return glm::all(glm::greaterThan(place, low - kReach)) && glm::all(glm::lessThan(place, high + kReach));
    };
    if (std::none_of(places.all().begin(), places.all().end(), near))
        return "lies wholly outside the workpiece: " + boxText(places.low(), places.high()) +
               ", and the workpiece has " + boxText(low, high) +
               ". Coordinates are expected whose origin lies on the seam, not those of a robot's world.";
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
        return "never comes within " + rounded(kSeamReach / kMm) + " mm of the joint's seam.";
    return {};
}

/// Of a recorded path that hurries along with its trigger pulled, as one with times of another unit does.
std::string speedWarning(const TorchPath& path) {
    double way = 0, time = 0;
    const std::vector<TorchSample>& samples = path.samples();
    for (size_t i = 1; i < samples.size(); ++i) {
        const TorchSample &before = samples[i - 1], &after = samples[i];
        if (before.trigger <= 0 || after.trigger <= 0 || !before.seen || !after.seen) continue;
        way += glm::length(glm::dvec3(after.tip) - glm::dvec3(before.tip));
        time += after.time - before.time;
    }
    if (time <= 0 || way < kFastest * time) return {};
    return "travels at " + rounded(way / time / kMm) + " mm/s with its trigger pulled, " + rounded(time) +
           " s in all. Are its times of another unit, or do points part their thousands?";
}

std::string pipeWarning(const Lesson& lesson) {
    const bool pipe = lesson.workpiece.kind == static_cast<int>(WorkpieceKind::Pipe);
    const double written = 2 * lesson.torch.pipeRadius() / kMm;
    const auto diameter = static_cast<double>(lesson.workpiece.diameterMm);
    if (written > 0 && !pipe) return "is written for a pipe of " + rounded(written) + " mm, and the workpiece is none.";
    if (written > 0 && std::abs(written - diameter) > 0.5)
        return "is written for a pipe of " + rounded(written) + " mm, and the workpiece has " + rounded(diameter) +
               " mm.";
    return {};
}

std::string triggerWarning(const Lesson& lesson, bool cut) {
    const auto pull = [&]() -> std::optional<double> {
        for (const TorchSample& torch : lesson.torch.samples())
            if (torch.trigger > 0) return torch.time;
        return lesson.torch.samples().empty() ? lesson.torch.firstPull() : std::nullopt;
    }();
    if (!pull) return "never pulls the trigger: nothing is heated.";
    const auto seconds = static_cast<double>(lesson.run.seconds);
    if (!cut && *pull > seconds)
        return "pulls the trigger at " + rounded(*pull) + " s, and the run ends at " + rounded(seconds) +
               " s: nothing is heated.";
    return {};
}

} // namespace

std::vector<std::string> pathWarnings(const Lesson& lesson, bool cut) {
    if (lesson.torch.empty() || lesson.recorded) return {};
    std::vector<std::string> sentences{triggerWarning(lesson, cut)};
    if (lesson.torch.duration() > kHour)
        sentences.push_back("lasts " + rounded(lesson.torch.duration() / kHour) + " hours.");
    if (lesson.model == LessonModel::Weld) {
        const WeldedPlaces places(lesson.torch);
        const Workpiece piece = makeWorkpiece(lesson.workpiece);
        const glm::vec3 size = piece.bodyHigh - piece.bodyLow;
        const std::string unit = unitWarning(places, static_cast<double>(std::max({size.x, size.y, size.z})));
        sentences.push_back(unit.empty() ? placeWarning(lesson, places, piece) : unit);
        sentences.push_back(unit.empty() ? speedWarning(lesson.torch) : std::string());
        sentences.push_back(pipeWarning(lesson));
    }
    std::erase(sentences, "");
    const std::string path = "The torch path " + printable(lesson.torchFile.filename().string(), 80) + " ";
    for (std::string& sentence : sentences)
        sentence.insert(0, path);
    return sentences;
}

std::string pathFormText(const std::filesystem::path& file, const TorchPath& path) {
    constexpr size_t kMostBytes = 1000;
    if (!path.form() || path.form()->ours) return {};
    return "Torch path " + printable(file.string(), kMostBytes) + " is read as " +
           printable(path.form()->text(), kMostBytes) + ".";
}

std::vector<std::string> lessonWarnings(const Lesson& lesson, const LessonFolders& catalogue) {
    std::vector<std::string> sentences;
    const std::string name = "The lesson " + printable(lesson.file.filename().string(), 80) + " ";
    if (lesson.title == lesson.key)
        sentences.push_back(name + "has no title: lists show its file's name. A line such as title = \"Fillet weld\" "
                                   "is expected.");
    if (!lesson.next.empty() && catalogue.named(lesson.next).empty())
        sentences.push_back(name + "names " + quote(lesson.next) +
                            " as the next lesson, which is not in the catalogue.");
    return sentences;
}

} // namespace meltpool
