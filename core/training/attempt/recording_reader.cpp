#include "core/training/attempt/recording_reader.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/training/attempt/content.hpp"
#include "core/training/attempt/frame.hpp"
#include "core/training/attempt/little_endian.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <utility>

namespace meltpool {

namespace fs = std::filesystem;

namespace {

std::string secondsText(double seconds) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.2f s", seconds);
    return text.data();
}

/// Place of a frame, in words.
std::string placeText(size_t frame, double seconds) {
    return "frame " + std::to_string(frame) + ", after " + secondsText(seconds);
}

class Reader {
  public:
    explicit Reader(const fs::path& file) : frames_(file) { recording_.file = file; }

    Recording read() {
        RecordingFrame frame;
        while (frames_.next(frame))
            takeChecked(frame);
        recording_.frames = frames_.frames();
        orderCheckpoints();
        if (frames_.ended() != FrameReader::Ended::whole)
            recording_.fault =
                RecordingFault{frames_.ended() == FrameReader::Ended::cut, frames_.frames() + 1, frames_.offset()};
        else
            requireNoneEarly();
        return std::move(recording_);
    }

  private:
    void takeChecked(const RecordingFrame& frame) {
        try {
            take(frame);
        } catch (const InputError& fault) {
            throw InputError(recording_.file, 0, placeText(frame.number, recording_.seconds()) + ": " + fault.what());
        }
    }

    void take(const RecordingFrame& frame) {
        if (frame.is(FrameKind::head) != (frame.number == 1))
            throw InputError("the head is missing or misplaced; expected it first, and once");
        if (frame.is(FrameKind::head)) recording_.head = readHead(frame.content);
        if (frame.is(FrameKind::step)) addStep(frame);
        if (frame.is(FrameKind::person)) addPerson(frame);
        if (frame.is(FrameKind::change)) recording_.changes.push_back(note(frame));
        if (frame.is(FrameKind::event)) addEvent(frame);
        if (frame.is(FrameKind::checkpoint)) addCheckpoint(frame);
        if (frame.is(FrameKind::end)) recording_.end = readEnd(frame.content);
    }

    void addStep(const RecordingFrame& frame) {
        const RecordingStep step = readStep(frame.content);
        if (step.steps != recording_.steps.size() + 1)
            throw InputError("it is step " + std::to_string(step.steps) + "; expected step " +
                             std::to_string(recording_.steps.size() + 1));
        if (step.torch.time < recording_.seconds())
            throw InputError("its time is earlier than the previous step's; expected a later one");
        recording_.steps.push_back(step);
    }

    /// Throws unless a frame between two steps holds the number of steps made so far.
    void requireSteps(std::uint64_t steps) const {
        if (steps != recording_.steps.size())
            throw InputError("it follows " + std::to_string(steps) + " steps; expected " +
                             std::to_string(recording_.steps.size()));
    }

    void addPerson(const RecordingFrame& frame) {
        recording_.people.push_back(readPerson(frame.content));
        requireSteps(recording_.people.back().steps);
    }

    RecordingNote note(const RecordingFrame& frame) const {
        RecordingNote note = readNote(frame.content);
        requireSteps(note.steps);
        note.seconds = recording_.seconds();
        note.frame = frame.number;
        return note;
    }

    void addEvent(const RecordingFrame& frame) {
        if (const RecordingNote event = readNote(frame.content); event.name == "redo") goBack(event);
        recording_.events.push_back(note(frame));
    }

    /// Drops frames after this step: they belong to the abandoned branch. Events that are not of torch and arc, such as
    /// shown cues, still hold.
    void goBack(const RecordingNote& redo) {
        const std::uint64_t steps = redo.steps;
        if (steps > recording_.steps.size() || redo.value != std::to_string(steps))
            throw InputError("it goes back to step " + printable(redo.value, 20) +
                             "; expected the step that it follows, from 0 to " +
                             std::to_string(recording_.steps.size()));
        recording_.steps.resize(steps);
        const auto after = [steps](const auto& each) { return each.steps > steps; };
        std::erase_if(recording_.people, after);
        std::erase_if(recording_.changes, after);
        std::erase_if(recording_.checkpoints, after);
        std::erase_if(recording_.events, [&](const RecordingNote& event) {
            if (event.name == "samples") return event.steps >= steps; // these samples are missing before the next step
            return after(event) && (event.name == "torch" || event.name == "arc_out");
        });
        for (RecordingNote& event : recording_.events) {
            if (!after(event)) continue;
            event.steps = steps;
            event.seconds = recording_.seconds();
            if (event.name == "redo") event.value = redo.value;
        }
        backTo_.push_back(steps);
        recording_.redone = backTo_.size();
        for (const EarlyCheckpoint& early : std::exchange(early_, {}))
            addCheckpoint(early);
    }

    /// A checkpoint whose way back is not read yet: early programs wrote the two in either order.
    struct EarlyCheckpoint {
        CheckpointHead head;
        RecordingCheckpoint place;
        size_t frame = 0; ///< frame number in the file
    };

    void addCheckpoint(const RecordingFrame& frame) {
        const CheckpointHead head = readCheckpointHead(frame.content);
        addCheckpoint({head,
                       {head.steps, frame.offset + kFrameHeadBytes + kCheckpointHeadBytes,
                        frame.content.size() - kCheckpointHeadBytes},
                       frame.number});
    }

    void addCheckpoint(const EarlyCheckpoint& checkpoint) {
        const CheckpointHead& head = checkpoint.head;
        if (head.redone > backTo_.size()) {
            early_.push_back(checkpoint);
            return;
        }
        const auto later = backTo_.begin() + static_cast<std::ptrdiff_t>(head.redone);
        if (std::any_of(later, backTo_.end(), [&](std::uint64_t back) { return head.steps > back; })) return;
        recording_.checkpoints.push_back(checkpoint.place);
    }

    void requireNoneEarly() const {
        if (early_.empty()) return;
        throw InputError(recording_.file, 0,
                         placeText(early_.front().frame, recording_.seconds()) + ": its checkpoint follows " +
                             std::to_string(early_.front().head.redone) + " returns; expected at most " +
                             std::to_string(backTo_.size()));
    }

    /// Drops checkpoints of steps that are not in a cut file: they are of no use.
    void orderCheckpoints() {
        auto& checkpoints = recording_.checkpoints;
        std::erase_if(checkpoints, [&](const auto& each) { return each.steps > recording_.steps.size(); });
        std::stable_sort(checkpoints.begin(), checkpoints.end(),
                         [](const auto& a, const auto& b) { return a.steps < b.steps; });
    }

    FrameReader frames_;
    Recording recording_;
    std::vector<std::uint64_t> backTo_; ///< steps that the attempt went back to, in turn
    std::vector<EarlyCheckpoint> early_;
};

/// The last end in the file; empty if there is none.
std::optional<RecordingEnd> lastEnd(std::ifstream& stream, std::uint64_t size) {
    constexpr std::uint64_t kTail = 16; // bytes of the frame's length and its hash
    constexpr std::uint64_t kLongest = 1 << 16;
    std::string bytes(kTail, '\0');
    stream.seekg(static_cast<std::streamoff>(size - kTail));
    if (!stream.read(bytes.data(), kTail)) return std::nullopt;
    const std::uint64_t length = ByteReader(bytes).u64();
    if (length < kFrameBytes + 8 || length > kLongest || length > size) return std::nullopt;
    bytes.resize(length);
    stream.seekg(static_cast<std::streamoff>(size - length));
    if (!stream.read(bytes.data(), static_cast<std::streamsize>(length))) return std::nullopt;
    ByteReader head(bytes);
    if (head.u32() != static_cast<std::uint32_t>(FrameKind::end) || head.u32() + kFrameBytes != length)
        return std::nullopt;
    try {
        return readEnd(std::string_view(bytes).substr(kFrameHeadBytes, length - kFrameBytes));
    } catch (const InputError&) {
        return std::nullopt;
    }
}

/// Follows the frame lengths through a file without an end.
void walk(std::ifstream& stream, RecordingSummary& summary) {
    constexpr std::uint64_t kLongest = 4096; // bytes of the longest frame to read
    std::string head(kFrameHeadBytes, '\0'), content;
    std::uint64_t at = kRecordingSignature.size();
    double last = 0;
    stream.clear();
    stream.seekg(static_cast<std::streamoff>(at));
    while (at + kFrameBytes <= summary.bytes && stream.read(head.data(), kFrameHeadBytes)) {
        ByteReader reader(head);
        const std::uint32_t kind = reader.u32(), length = reader.u32();
        at += kFrameBytes + length;
        if (at > summary.bytes) break;
        if (length > kLongest) {
            stream.seekg(static_cast<std::streamoff>(at));
            continue;
        }
        content.resize(length + sizeof(std::uint64_t));
        if (!stream.read(content.data(), static_cast<std::streamsize>(content.size()))) break;
        const std::string_view text = std::string_view(content).substr(0, length);
        ByteReader frame(text);
        if (kind == static_cast<std::uint32_t>(FrameKind::step) && length >= kStepBytes) {
            frame.u64();
            last = frame.f64();
        }
        if (kind == static_cast<std::uint32_t>(FrameKind::event) && length >= kNoteHeadBytes + 4) {
            frame.u64();
            if (frame.u32() == 4 && frame.rest().substr(0, 4) == "redo") ++summary.redone;
        }
    }
    summary.seconds = std::isfinite(last) && last >= 0 && last <= 86400 ? last : 0;
}

/// True if an event before the first step says that the attempt is a test.
bool beginsForScore(std::ifstream& stream, std::uint64_t size) {
    constexpr std::uint64_t kLongest = 4096; // bytes of the longest frame to read
    constexpr std::string_view kName = "for_score", kYes = "yes";
    std::string head(kFrameHeadBytes, '\0'), content;
    std::uint64_t at = kRecordingSignature.size();
    while (at + kFrameBytes <= size) {
        stream.clear();
        stream.seekg(static_cast<std::streamoff>(at));
        if (!stream.read(head.data(), kFrameHeadBytes)) return false;
        ByteReader reader(head);
        const std::uint32_t kind = reader.u32(), length = reader.u32();
        if (kind == static_cast<std::uint32_t>(FrameKind::step)) return false;
        at += kFrameBytes + length;
        if (kind != static_cast<std::uint32_t>(FrameKind::event) || length < kNoteHeadBytes || length > kLongest)
            continue;
        content.resize(length);
        if (!stream.read(content.data(), static_cast<std::streamsize>(length))) return false;
        ByteReader frame(content);
        frame.u64();
        const std::uint32_t name = frame.u32();
        if (name == kName.size() && frame.rest() == std::string(kName) + std::string(kYes)) return true;
    }
    return false;
}

AttemptHead headOf(const fs::path& file) {
    FrameReader frames(file);
    RecordingFrame first;
    if (!frames.next(first) || !first.is(FrameKind::head))
        throw InputError(file, 0, "has no whole head; expected a recording");
    return readHead(first.content);
}

} // namespace

std::string durationText(double seconds) {
    const auto whole = std::lround(std::max(0.0, seconds));
    if (whole < 60) return std::to_string(whole) + " s";
    return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
}

std::string Recording::stateSentence() const {
    const std::string until = secondsText(seconds()) + " (" + std::to_string(frames) + " frames) are whole";
    if (damaged())
        return until + "; " + placeText(fault->frame, seconds()) + ", at byte " + std::to_string(fault->byte) +
               ", is damaged";
    if (fault)
        return until + "; the file is cut short in " + placeText(fault->frame, seconds()) + ", at byte " +
               std::to_string(fault->byte);
    return until + (end ? "; the attempt ended: " + end->reason : "; the program ended without a word");
}

bool isRecording(const fs::path& file) {
    return file.extension() == kRecordingEnding;
}

Recording readRecording(const fs::path& file) {
    return Reader(file).read();
}

Recording readSoundRecording(const fs::path& file) {
    Recording recording = readRecording(file);
    if (recording.damaged())
        throw InputError(file, 0,
                         recording.stateSentence() +
                             "; expected an undamaged recording ('meltpool recordings --csv' saves the whole part)");
    if (recording.steps.empty())
        throw InputError(file, 0, "holds no whole step; expected an attempt with one step or more");
    return recording;
}

TorchPath torchPathOf(const Recording& recording) {
    std::vector<TorchSample> samples;
    samples.reserve(recording.steps.size());
    for (const RecordingStep& step : recording.steps)
        samples.push_back(step.torch);
    return TorchPath(std::move(samples));
}

std::vector<std::byte> readCheckpoint(const fs::path& file, const RecordingCheckpoint& checkpoint) {
    std::error_code unreadable;
    const std::uint64_t size = fs::file_size(file, unreadable);
    const bool fits = !unreadable && checkpoint.offset <= size && checkpoint.size <= size - checkpoint.offset;
    std::vector<std::byte> bytes(fits ? checkpoint.size : 0);
    std::ifstream stream(file, std::ios::binary);
    stream.seekg(static_cast<std::streamoff>(checkpoint.offset));
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!fits || !stream) throw InputError(file, 0, "has changed meanwhile; expected its checkpoints unchanged");
    return bytes;
}

RecordingSummary readRecordingSummary(const fs::path& file) {
    RecordingSummary summary;
    summary.head = headOf(file);
    std::error_code unreadable;
    summary.bytes = fs::file_size(file, unreadable);
    std::ifstream stream(file, std::ios::binary);
    summary.forScore = beginsForScore(stream, summary.bytes);
    stream.clear();
    summary.end = lastEnd(stream, summary.bytes);
    if (!summary.end) {
        walk(stream, summary);
        return summary;
    }
    summary.seconds = summary.end->seconds;
    summary.redone = summary.end->redone;
    return summary;
}

Moment beginOf(const AttemptHead& head, const fs::path& file) {
    if (const auto moment = parseMoment(head.utc)) return *moment;
    if (const auto moment = parseMoment(head.date)) return *moment;
    return writtenAt(file).value_or(momentNow());
}

Moment beginOf(const fs::path& file) {
    try {
        return beginOf(headOf(file), file);
    } catch (const InputError&) {
        return beginOf(AttemptHead{}, file);
    }
}

std::string fileHash(const fs::path& file) {
    try {
        StateHash hash;
        const std::string text = readTextFile(file);
        hash.add(std::span<const char>(text.data(), text.size()));
        return formatHexadecimal(hash.value());
    } catch (const InputError&) {
        return {};
    }
}

} // namespace meltpool
