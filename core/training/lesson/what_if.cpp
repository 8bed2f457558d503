#include "core/training/lesson/what_if.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace meltpool {

namespace {

constexpr double kMm = 1e-3;
constexpr double kDegree = std::numbers::pi / 180;
constexpr double kLeastSpeed = 0.1, kMostSpeed = 10; ///< factor of speed
constexpr std::string_view kSpeedUnit = "mm/s";

/// A numeric change of the path, and its destination.
struct PathKey {
    std::string_view key;
    double PathChange::*value;
    double unit;
    double least, most; ///< limits in the key's unit
    std::string_view expected;
};

constexpr std::array kPathKeys{
    PathKey{"arc_length", &PathChange::farther, kMm, -50, 50, "a change in mm from -50 to 50"},
    PathKey{"stick_out", &PathChange::farther, kMm, -50, 50, "a change in mm from -50 to 50"},
    PathKey{"work_angle", &PathChange::workAngle, kDegree, -80, 80, "a change in degrees from -80 to 80"},
    PathKey{"travel_angle", &PathChange::travelAngle, kDegree, -80, 80, "a change in degrees from -80 to 80"},
    PathKey{"stillness", &PathChange::stillness, 1, 0, 1, "a number from 0 (tremor as recorded) to 1 (none)"},
};

constexpr std::array<std::pair<std::string_view, std::string_view>, 2> kShortNames{
    {{"wire_feed", "wire_feed_m_min"}, {"gap", "gap_mm"}}};

/// The length that this lesson's hand controls: arc length or stick-out.
std::string_view lengthKey(const Lesson& lesson) {
    return traitsOf(lesson.process).distance == DistanceKind::arcLength ? "arc_length" : "stick_out";
}

bool fitsProcess(std::string_view key, const Lesson& lesson) {
    return (key != "arc_length" && key != "stick_out") || key == lengthKey(lesson);
}

std::string knownKeys(Lesson& lesson) {
    std::string names;
    const auto add = [&](std::string_view name) { names += (names.empty() ? "" : ", ") + std::string(name); };
    const ParameterList list = lesson.metalParameters();
    if (lesson.model == LessonModel::Weld) {
        add("speed");
        for (const PathKey& each : kPathKeys)
            if (fitsProcess(each.key, lesson)) add(each.key);
        for (const auto& [name, key] : kShortNames)
            if (findParameter(list, key) != nullptr) add(name);
    }
    for (const Parameter& parameter : list)
        add(parameter.key);
    return names;
}

class Reader {
  public:
    explicit Reader(const Lesson& lesson) : lesson_(lesson) {}

    WhatIf read(std::span<const std::string> wishes) {
        for (const std::string& wish : wishes) {
            where_ = "--what-if " + printable(wish, 80);
            const size_t equals = wish.find('=');
            if (equals == std::string::npos || equals == 0 || equals + 1 == wish.size())
                throw InputError("--what-if is " + quote(wish) + "; expected KEY=VALUE, such as speed=0.8");
            take(wish.substr(0, equals), wish.substr(equals + 1));
        }
        return std::move(made_);
    }

  private:
    void take(const std::string& key, const std::string& value) {
        std::string name = key;
        for (const auto& [shortName, whole] : kShortNames)
            if (key == shortName) name = whole;
        for (const std::string& before : names_)
            if (before == name) throw InputError(where_ + ": " + name + " appears twice; expected one value for it");
        names_.push_back(name);
        made_.asked.emplace_back(key, value);
        if (lesson_.model == LessonModel::Weld && takePath(name, value)) return;
        if (findParameter(lesson_.metalParameters(), name) == nullptr) fail(key);
        lesson_.set(name, value, where_); // a copy: checks that the value fits
        made_.values.emplace_back(name, value);
    }

    bool takePath(const std::string& key, const std::string& value) {
        if (key == "speed") {
            takeSpeed(value);
            return true;
        }
        for (const PathKey& each : kPathKeys) {
            if (each.key != key) continue;
            if (!fitsProcess(key, lesson_)) fail(key);
            const auto number = parseDouble(value);
            if (!number || !(*number >= each.least) || !(*number <= each.most))
                throw InputError(where_ + ": expected " + std::string(each.expected));
            made_.path.*each.value = *number * each.unit;
            return true;
        }
        return false;
    }

    void takeSpeed(const std::string& value) {
        const bool travel = value.ends_with(kSpeedUnit);
        const auto number =
            parseDouble(trimText(std::string_view(value).substr(0, value.size() - (travel ? kSpeedUnit.size() : 0))));
        const double least = travel ? 0.1 : kLeastSpeed, most = travel ? 200 : kMostSpeed;
        if (!number || !(*number >= least) || !(*number <= most))
            throw InputError(where_ + ": expected a factor from 0.1 to 10, or a travel speed from 0.1mm/s to 200mm/s");
        if (travel)
            made_.path.travelSpeed = *number * kMm;
        else
            made_.path.speed = *number;
    }

    [[noreturn]] void fail(const std::string& key) {
        std::string hint;
        if (key == "current" && traitsOf(lesson_.process).feedsWire)
            hint = "the wire feed sets the current, see wire_feed; ";
        if (key == "arc_length") hint = "the voltage sets the arc length of a wire; ";
        throw InputError(where_ + ": " + quote(key) + " cannot be changed in this lesson; " + hint +
                         "expected one of " + knownKeys(lesson_));
    }

    Lesson lesson_;
    WhatIf made_;
    std::vector<std::string> names_;
    std::string where_;
};

size_t scaled(size_t steps, double speed) {
    return static_cast<size_t>(std::llround(static_cast<double>(steps) / speed));
}

} // namespace

PathChange PathChange::resolved(std::optional<double> mean) const {
    PathChange made = *this;
    if (!travelSpeed) return made;
    if (!mean || !(*mean > 0))
        throw InputError("--what-if speed: the attempt has no travel speed, because no arc went along the seam; "
                         "expected a factor, such as speed=0.8");
    made.speed = *travelSpeed / *mean;
    if (made.speed < kLeastSpeed || made.speed > kMostSpeed)
        throw InputError("--what-if speed: the attempt went at " + formatNumber(static_cast<float>(*mean / kMm)) +
                         " mm/s; expected 0.1 to 10 times this speed");
    made.travelSpeed.reset();
    return made;
}

std::string WhatIf::text() const {
    std::string words;
    for (const auto& [key, value] : asked)
        words += (words.empty() ? "" : phrase("list.separator")) + key + "=" + value;
    return words.empty() ? phrase("what_if.nothing") : words;
}

WhatIf readWhatIf(std::span<const std::string> wishes, const Lesson& lesson) {
    return Reader(lesson).read(wishes);
}

void takeWhatIf(Lesson& lesson, const WhatIf& whatIf, double speed) {
    for (const auto& [key, value] : whatIf.values)
        lesson.set(key, value, "--what-if " + key);
    if (!lesson.recorded) return;
    RecordedAttempt& recorded = *lesson.recorded;
    const auto isHeld = [&](const RecordedChange& change) {
        return std::any_of(whatIf.values.begin(), whatIf.values.end(),
                           [&](const auto& held) { return held.first == change.key; });
    };
    std::erase_if(recorded.changes, isHeld);
    std::erase_if(recorded.values, isHeld);
    for (RecordedChange& change : recorded.changes)
        change.steps = scaled(change.steps, speed);
    for (RecordedEvent& event : recorded.events)
        event.steps = scaled(event.steps, speed);
    recorded.stateHash.clear();
}

} // namespace meltpool
