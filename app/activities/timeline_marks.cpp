#include "app/activities/timeline_marks.hpp"

#include "app/activities/redo.hpp"
#include "core/base/text.hpp"
#include "core/base/words.hpp"
#include "core/weld/gauge/weld_figures.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

std::string eventText(const RecordedEvent& event) {
    if (event.name == "torch") return phrase(event.value == "lost" ? "timeline.torch_lost" : "timeline.torch_seen");
    if (event.name == "samples") return phrase("timeline.samples_missing");
    return event.value.empty() ? event.name : event.name + " " + event.value;
}

bool spoils(const RecordedEvent& event) {
    return event.name == "samples" || (event.name == "torch" && event.value == "lost");
}

/// Steps at which the attempt resumed after each redo; a later redo from an earlier step removes those after it.
std::vector<size_t> redoneAt(const RecordedAttempt& attempt) {
    std::vector<size_t> steps;
    for (const RecordedEvent& note : attempt.notes) {
        if (note.name != "redo") continue;
        const auto value = parseDouble(note.value);
        const size_t step = value && *value >= 0 ? static_cast<size_t>(*value) : note.steps;
        std::erase_if(steps, [&](size_t before) { return before >= step; });
        steps.push_back(step);
    }
    return steps;
}

/// Sentence of a failure: "undercut" -> "Undercut fails: 0.8 mm at 23 mm of the seam".
std::string failText(const VerdictItem& item) {
    const std::string text = capitalised(imperfectionName(item.name));
    if (!item.value) return phrase("timeline.fails", {{"imperfection", text}});
    return phrase("timeline.fails_by", {{"imperfection", text},
                                        {"value", PhraseNumber(*item.value, 1)},
                                        {"unit", item.unit == "deg" ? std::string_view("\xC2\xB0") : item.unit},
                                        {"place", PhraseNumber(item.place.value_or(0) * 1e3)}});
}

void sortByTime(std::vector<TimelineMark>& marks) {
    std::stable_sort(marks.begin(), marks.end(),
                     [](const TimelineMark& a, const TimelineMark& b) { return a.time < b.time; });
}

} // namespace

std::vector<TimelineMark> timelineMarks(const RecordedAttempt& attempt, double duration) {
    std::vector<TimelineMark> marks;
    const auto timeOf = [&](size_t steps) {
        if (attempt.rows == 0) return 0.0;
        return std::min(duration, duration * static_cast<double>(steps) / static_cast<double>(attempt.rows));
    };
    for (const RecordedChange& change : attempt.changes)
        marks.push_back(
            {change.seconds > 0 ? change.seconds : timeOf(change.steps), change.key + " " + change.value, false});
    for (const RecordedEvent& event : attempt.events)
        marks.push_back({timeOf(event.steps), eventText(event), spoils(event)});
    for (const size_t step : redoneAt(attempt))
        marks.push_back({timeOf(step), phrase("timeline.redo"), false, true});
    sortByTime(marks);
    return marks;
}

std::vector<TimelineMark> faultMarks(const Technique& technique, const Judgement& judgement) {
    std::vector<TimelineMark> marks;
    const auto add = [&](double place, std::string text) {
        if (!std::isfinite(place)) return;
        if (const auto time = firstTimeAt(technique, place)) marks.push_back({*time, std::move(text), true});
    };
    for (const Correction& correction : judgement.corrections) {
        if (!correction.quantity || !judgement.score) continue;
        const ParameterScore* parameter = judgement.score->find(*correction.quantity);
        if (parameter != nullptr) add(parameter->worstPlaceMm * 1e-3, correction.sentence);
    }
    if (judgement.verdict)
        for (const VerdictItem& item : judgement.verdict->items)
            if (item.state == VerdictState::fail && item.place) add(*item.place, failText(item));
    sortByTime(marks);
    return marks;
}

} // namespace meltpool
