#include "core/training/lesson/lesson_check.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/base/toml_table.hpp"
#include "core/weld/gauge/weld_figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>

namespace meltpool {

namespace {

namespace fs = std::filesystem;

constexpr double kMm = 1e-3;
constexpr double kDegree = std::numbers::pi / 180;
constexpr double kMostFarther = 100; // mm

const QuantityInfo* findQuantity(std::string_view key, DistanceKind distance) {
    for (const QuantityInfo& info : quantities(distance))
        if (!info.key.empty() && info.key == key) return &info;
    return nullptr;
}

NumberRange readRange(TomlTable& table, std::string_view key) {
    const std::vector<double> ends = table.numbers(key, {}, 2);
    if (ends.size() != 2 || ends[0] > ends[1]) table.fail(key, "expected [least, most]");
    return {ends[0], ends[1]};
}

std::string readWord(TomlTable& table, std::string_view key, std::span<const std::string_view> words) {
    const std::string word = table.text(key);
    if (std::find(words.begin(), words.end(), word) != words.end()) return word;
    std::string known;
    for (const std::string_view each : words)
        known += (known.empty() ? "" : ", ") + std::string(each);
    table.fail(key, "is " + quote(word) + "; expected one of " + known);
}

std::vector<std::string_view> judgedKeys(const Lesson& lesson) {
    std::vector<std::string_view> keys;
    if (lesson.technique)
        for (const TechniqueBand& band : lesson.technique->bands)
            keys.push_back(quantityInfo(band.quantity, lesson.technique->distance).key);
    return keys;
}

Expectation readExpectation(TomlTable& table, const std::string& key, const Lesson& lesson) {
    const bool technique =
        key == "score" || key == "scored" || key == "lowest" || findQuantity(key, traitsOf(lesson.process).distance);
    if (technique && !lesson.technique) table.fail(key, "expected a lesson with a table [technique]");
    if ((key == "accepted" || findImperfection(key)) && !lesson.acceptance)
        table.fail(key, "expected a lesson with a table [acceptance]");
    if (key == "scored" || key == "accepted") return {key, table.flag(key, true)};
    if (key == "lowest") return {key, readWord(table, key, judgedKeys(lesson))};
    if (const WeldFigure* imperfection = findImperfection(key))
        return {std::string(imperfection->key), readWord(table, key, kVerdictStates)};
    const std::vector<std::string_view> judged = judgedKeys(lesson);
    const bool banded = std::find(judged.begin(), judged.end(), key) != judged.end();
    if (key == "score" || banded || findStationFigure(key)) return {key, readRange(table, key)};
    table.fail(key,
               "is not a value of a judged weld; expected score, scored, lowest, accepted, a parameter that the lesson "
               "judges, an imperfection, or a column of weld.csv");
}

void readExpectations(TomlTable& root, LessonCheck& check) {
    TomlTable table = root.table("expect");
    for (const std::string& key : table.keys())
        check.expectations.push_back(readExpectation(table, key, check.lesson));
    if (check.expectations.empty()) root.fail("expect", "is empty; expected at least one value");
    table.finish();
}

PathPerturbation readBend(TomlTable& root) {
    PathPerturbation bend;
    root.allow("bend");
    if (!root.has("bend")) return bend;
    TomlTable table = root.table("bend");
    bend.time = table.number("time", {0.1, 10}, 1);
    bend.farther = table.number("farther_mm", {-kMostFarther, kMostFarther}, 0) * kMm;
    bend.turn = table.number("turn_deg", {-90, 90}, 0) * kDegree;
    bend.aside = table.number("aside_mm", {-kMostFarther, kMostFarther}, 0) * kMm;
    const double seed = table.number("tremor_seed", {0, 1e6}, 0);
    if (seed != std::floor(seed)) table.fail("tremor_seed", "expected a whole number");
    bend.tremor = static_cast<std::uint32_t>(seed);
    bend.tremorPlace = table.number("tremor_mm", {0, kMostFarther}, HandTremor::kPlace / kMm) * kMm;
    bend.tremorAngle = table.number("tremor_deg", {0, 90}, HandTremor::kAngle / kDegree) * kDegree;
    table.finish();
    return bend;
}

void readValues(TomlTable& root, Lesson& lesson) {
    root.allow("set");
    if (!root.has("set")) return;
    TomlTable table = root.table("set");
    for (const std::string& key : table.keys())
        lesson.set(key, table.valueText(key), table.file().string() + ":" + std::to_string(table.lineOf(key)));
    table.finish();
}

/// The lesson of a check, with the check's own torch path.
Lesson namedLesson(TomlTable& root, const LessonFolders& lessons) {
    const std::string name = root.text("lesson");
    const fs::path beside = root.file().parent_path();
    Lesson lesson;
    try {
        lesson = findLesson(name.ends_with(".toml") ? (beside / name).string() : name, lessons);
    } catch (const InputError& fault) {
        root.fail("lesson", fault.what());
    }
    root.allow("torch");
    if (!root.has("torch")) return lesson;
    const float seconds = lesson.run.seconds;
    try {
        takeTorch(lesson, beside / root.text("torch"));
    } catch (const InputError& fault) {
        root.fail("torch", fault.what());
    }
    if (!lesson.recorded) lesson.run.seconds = std::max(seconds, static_cast<float>(lesson.torch.duration()));
    return lesson;
}

std::string rangeText(const NumberRange& range) {
    return formatNumber(range.minimum) + " to " + formatNumber(range.maximum);
}

CheckedValue checkNumber(const std::string& key, const NumberRange& wanted, std::optional<double> found) {
    CheckedValue value{key, rangeText(wanted), "none", false};
    if (!found || !std::isfinite(*found)) return value;
    char text[40];
    std::snprintf(text, sizeof text, "%.4g", *found);
    value.found = text;
    value.passed = *found >= wanted.minimum && *found <= wanted.maximum;
    return value;
}

std::optional<double> numberOf(const std::string& key, const Judgement& judgement) {
    const auto& score = judgement.score;
    if (key == "score") return score && score->scored ? std::optional(score->total) : std::nullopt;
    if (const QuantityInfo* info = findQuantity(key, judgement.distance)) {
        const ParameterScore* parameter = score && score->scored ? score->find(info->quantity) : nullptr;
        return parameter != nullptr ? std::optional(parameter->score) : std::nullopt;
    }
    const WeldFigure* figure = findStationFigure(key);
    if (figure == nullptr || !judgement.weld) return std::nullopt;
    const auto& mean = judgement.weld->mean.*figure->member;
    return mean ? std::optional(*mean / figure->inSi()) : std::nullopt;
}

std::string wordOf(const std::string& key, const Judgement& judgement) {
    if (key == "lowest") {
        if (!judgement.score || !judgement.score->lowest) return "none";
        return std::string(quantityInfo(*judgement.score->lowest, judgement.distance).key);
    }
    if (!judgement.verdict) return "none";
    for (const VerdictItem& item : judgement.verdict->items)
        if (item.name == key) return std::string(nameOf(item.state));
    return "none";
}

std::string flagOf(const std::string& key, const Judgement& judgement) {
    const auto yesOrNo = [](bool flag) { return std::string(flag ? "yes" : "no"); };
    if (key == "scored") return judgement.score ? yesOrNo(judgement.score->scored) : "none";
    return judgement.verdict ? yesOrNo(judgement.verdict->accepted) : "none";
}

} // namespace

bool isLessonCheck(const fs::path& file) {
    return parseTomlFile(file).contains("expect");
}

LessonCheck readLessonCheck(const fs::path& file, const LessonFolders& lessons) {
    const toml::table parsed = parseTomlFile(file);
    TomlTable root(parsed, file);
    LessonCheck check;
    check.file = file;
    check.name = file.stem().string();
    if (!root.has("lesson")) {
        check.lesson = readLesson(file);
        if (check.lesson.model != LessonModel::Weld) root.fail("expect", "expected a lesson whose model is weld");
        readExpectations(root, check);
        return check;
    }
    check.lesson = namedLesson(root, lessons);
    readValues(root, check.lesson);
    check.bend = readBend(root);
    if (check.lesson.recorded) { // an event at a place of the path happens there in the bent path, too
        const auto bent = [&](size_t steps) {
            return static_cast<size_t>(std::lround(static_cast<double>(steps) * check.bend.time));
        };
        for (RecordedChange& change : check.lesson.recorded->changes)
            change.steps = bent(change.steps);
        for (RecordedEvent& event : check.lesson.recorded->events)
            event.steps = bent(event.steps);
    }
    readExpectations(root, check);
    root.finish();
    if (check.lesson.model != LessonModel::Weld) root.fail("lesson", "expected a lesson whose model is weld");
    return check;
}

std::vector<CheckedValue> checkJudgement(const LessonCheck& check, const Judgement& judgement) {
    std::vector<CheckedValue> values;
    for (const Expectation& each : check.expectations) {
        if (const auto* range = std::get_if<NumberRange>(&each.wanted)) {
            values.push_back(checkNumber(each.key, *range, numberOf(each.key, judgement)));
            continue;
        }
        const bool* flag = std::get_if<bool>(&each.wanted);
        const std::string expected = flag == nullptr ? std::get<std::string>(each.wanted) : *flag ? "yes" : "no";
        const std::string found = flag == nullptr ? wordOf(each.key, judgement) : flagOf(each.key, judgement);
        values.push_back({each.key, expected, found, found == expected});
    }
    return values;
}

} // namespace meltpool
