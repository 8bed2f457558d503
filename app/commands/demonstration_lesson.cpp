#include "app/commands/demonstration_lesson.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/base/toml_table.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <array>
#include <sstream>

namespace meltpool {

namespace {

namespace fs = std::filesystem;

constexpr double kLeastTail = 1; ///< s of cooling after a weld at least

/// Float as TOML shows it to people, not as the double that it converts to.
double shortNumber(float value) {
    return parseDouble(formatNumber(value)).value_or(0);
}

/// Writes the value of a parameter under its key in a lesson.
void put(toml::table& group, const Parameter& parameter) {
    if (!parameter.choices.empty())
        group.insert_or_assign(parameter.key, parameterText(parameter));
    else if (const auto* number = std::get_if<float*>(&parameter.value))
        group.insert_or_assign(parameter.key, shortNumber(**number));
    else if (const auto* whole = std::get_if<int*>(&parameter.value))
        group.insert_or_assign(parameter.key, static_cast<std::int64_t>(**whole));
    else if (const auto* flag = std::get_if<bool*>(&parameter.value))
        group.insert_or_assign(parameter.key, **flag);
    else if (const auto* vector = std::get_if<glm::vec3*>(&parameter.value))
        group.insert_or_assign(parameter.key, toml::array{shortNumber((*vector)->x), shortNumber((*vector)->y),
                                                          shortNumber((*vector)->z)});
    else
        group.insert_or_assign(parameter.key, parameterText(parameter));
}

toml::table& groupIn(toml::table& root, std::string_view name) {
    if (root[name].as_table() == nullptr) root.insert_or_assign(name, toml::table{});
    return *root[name].as_table();
}

/// Writes those values of a group that the file has or the attempt names.
void putValues(toml::table& root, std::string_view name, const ParameterList& list, const RecordedAttempt& attempt) {
    for (const Parameter& parameter : list) {
        const auto isOfThis = [&](const RecordedChange& change) { return change.key == parameter.key; };
        if (std::any_of(attempt.values.begin(), attempt.values.end(), isOfThis) ||
            std::any_of(attempt.changes.begin(), attempt.changes.end(), isOfThis))
            put(groupIn(root, name), parameter);
    }
}

/// Name of a file that a lesson names relative to itself, as seen from another folder.
std::string movedName(const fs::path& named, const fs::path& from, const fs::path& to) {
    const fs::path whole = fs::weakly_canonical(fs::absolute(from / named));
    const fs::path seen = whole.lexically_proximate(fs::weakly_canonical(fs::absolute(to)));
    return seen.generic_string();
}

void moveNames(toml::table& root, const fs::path& from, const fs::path& to) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 2> kNames{
        {{"workpiece", "metal"}, {"acceptance", "use"}}};
    for (const auto& [group, key] : kNames)
        if (toml::table* table = root[group].as_table())
            if (const auto named = (*table)[key].value<std::string>(); named && named->ends_with(".toml"))
                table->insert_or_assign(key, movedName(*named, from, to));
    if (const auto picture = root["list_picture"].value<std::string>())
        root.insert_or_assign("list_picture", movedName(*picture, from, to));
}

/// s between the last sample with a pulled trigger and the path's end.
double lastRelease(const std::vector<TorchSample>& samples) {
    const auto last =
        std::find_if(samples.rbegin(), samples.rend(), [](const TorchSample& torch) { return torch.trigger > 0; });
    if (last == samples.rend()) return 0;
    return last == samples.rbegin() ? last->time : (last - 1)->time;
}

/// s for which the lesson's own demonstration continues after its trigger is released, which the weld needs to cool.
double ownTail(const Lesson& own) {
    double released = 0;
    for (double time = 0; time <= own.torch.duration(); time += TorchPath::kTriggerGrain)
        if (own.torch.sample(time).trigger > 0) released = time;
    return std::max(static_cast<double>(own.run.seconds) - released, kLeastTail);
}

} // namespace

WeldedStretch weldedStretch(const Lesson& lesson) {
    const std::vector<TorchSample>& samples = lesson.torch.samples();
    const auto pulled = [](const TorchSample& torch) { return torch.trigger > 0; };
    const auto first = std::find_if(samples.begin(), samples.end(), pulled);
    if (first == samples.end())
        throw InputError(lesson.torchFile, 0, "never pulls the trigger; expected an attempt that welds");
    WeldedStretch stretch;
    stretch.firstPull = first->time;
    const double lead = first->time - kDemonstrationLead;
    stretch.begin = std::find_if(samples.begin(), first, [&](const auto& torch) { return torch.time >= lead; })->time;
    stretch.end = std::min(lastRelease(samples) + kDemonstrationLead, samples.back().time);
    for (TorchSample torch : samples) {
        if (torch.time < stretch.begin || torch.time > stretch.end) continue;
        torch.time -= stretch.begin;
        stretch.samples.push_back(torch);
    }
    return stretch;
}

std::string demonstrationLesson(const Lesson& lesson, const WeldedStretch& stretch, const fs::path& path,
                                const fs::path& file) {
    toml::table root = parseTomlFile(lesson.file);
    const fs::path from = lesson.file.has_parent_path() ? lesson.file.parent_path() : fs::path(".");
    const fs::path to = file.has_parent_path() ? file.parent_path() : fs::path(".");
    moveNames(root, from, to);
    const RecordedAttempt& attempt = *lesson.recorded;
    Lesson welded = lesson; // with the values of the first pull
    const double step = lesson.torch.duration() / static_cast<double>(std::max<size_t>(attempt.rows, 1));
    for (const RecordedChange& change : attempt.changes)
        if (static_cast<double>(change.steps) * step < stretch.firstPull)
            welded.set(change.key, change.value, attempt.file.string());
    if (lesson.model == LessonModel::Weld) {
        putValues(root, "workpiece", describe(welded.workpiece), attempt);
        if (welded.workpiece.metal.ends_with(".toml")) // in memory the name is relative to the current folder
            groupIn(root, "workpiece").insert_or_assign("metal", movedName(welded.workpiece.metal, ".", to));
        putValues(root, "process", describe(welded.process), attempt);
    } else {
        putValues(root, "start", describe(welded.setup), attempt);
        putValues(root, "metal", describe(welded.metal), attempt);
        putValues(root, "source", describe(welded.source), attempt);
    }
    const double seconds = lastRelease(stretch.samples) + ownTail(readLesson(lesson.file));
    groupIn(root, "run").insert_or_assign("seconds", shortNumber(static_cast<float>(seconds)));
    root.insert_or_assign("torch", path.filename().generic_string());
    root.insert_or_assign("title", phrase("run.demonstration.title", {{"lesson", lesson.title}}));
    root.erase("expect"); // [expect] describes the lesson's own demonstration
    std::ostringstream text;
    text << "# " << printable(lesson.key, 80) << " with a recorded attempt as its demonstration.\n" << root << "\n";
    return text.str();
}

} // namespace meltpool
