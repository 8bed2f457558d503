#include "core/training/attempt/recording_csv.hpp"

#include "core/base/text.hpp"
#include "core/training/attempt/record_text.hpp"
#include "core/weld/torch/torch_csv.hpp"

namespace meltpool {

namespace {

std::string headLines(const Recording& recording) {
    AttemptHead head = recording.head;
    for (std::string* each : {&head.lessonFile, &head.lessonHash, &head.utc}) // a CSV record has none of these
        each->clear();
    std::string text(kRecordFirstLine);
    text += '\n';
    appendHeadLines(text, "#", head);
    appendStartValues(text, "#", head);
    for (const std::string_view name : torchColumns())
        text += (name == torchColumns().front() ? "" : ",") + std::string(name);
    for (const std::string_view name : head.rod ? rodColumns() : std::span<const std::string_view>{})
        text += "," + std::string(name);
    if (head.arc) text += "," + std::string(kArcColumns);
    return text + ",real_time\n";
}

/// Lines of notes before the step after `steps`; changes and events are in the order of their frames.
class Notes {
  public:
    explicit Notes(const Recording& recording) : recording_(recording) {}

    void append(std::string& text, std::uint64_t steps) {
        while (true) {
            const RecordingNote* change = next(recording_.changes, change_, steps);
            const RecordingNote* event = next(recording_.events, event_, steps);
            if (change == nullptr && event == nullptr) return;
            const bool changeFirst = event == nullptr || (change != nullptr && change->frame < event->frame);
            const RecordingNote& note = changeFirst ? *change : *event;
            ++(changeFirst ? change_ : event_);
            appendRecordLine(text, "#", changeFirst ? "set" : "event", note.name, note.value);
        }
    }

  private:
    static const RecordingNote* next(const std::vector<RecordingNote>& notes, size_t index, std::uint64_t steps) {
        return index < notes.size() && notes[index].steps <= steps ? &notes[index] : nullptr;
    }

    const Recording& recording_;
    size_t change_ = 0;
    size_t event_ = 0;
};

void appendStep(std::string& text, const RecordingStep& step, const AttemptHead& head) {
    appendTorchRow(text, step.torch);
    if (head.rod) {
        text += ',';
        appendRodCells(text, step.torch.rod);
    }
    if (head.arc) appendArcCells(text, step.arc);
    appendCell(text, static_cast<float>(step.realTime));
    text += '\n';
}

} // namespace

std::string recordingCsv(const Recording& recording) {
    std::string text = headLines(recording);
    Notes notes(recording);
    for (const RecordingStep& step : recording.steps) {
        notes.append(text, step.steps - 1);
        appendStep(text, step, recording.head);
    }
    notes.append(text, recording.steps.size());
    if (recording.fault) appendRecordLine(text, "#", "incomplete", recording.stateSentence(), {});
    if (!recording.end) return text;
    appendRecordLine(text, "#", "ended", recording.end->reason, {});
    appendRecordLine(text, "#", "state_hash", recording.end->stateHash, {});
    appendRecordLine(text, "#", "real_time", formatNumber(static_cast<float>(recording.end->realTime)), {});
    appendRecordLine(text, "#", "least_real_time", formatNumber(static_cast<float>(recording.end->leastRealTime)), {});
    return text;
}

} // namespace meltpool
