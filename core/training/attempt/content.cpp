#include "core/training/attempt/content.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/training/attempt/frame.hpp"
#include "core/training/attempt/little_endian.hpp"
#include "core/training/attempt/record_text.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr double kLongest = 86400;        ///< s, limit of a torch path
constexpr float kFarthest = 100;          ///< m, limit of a torch path
constexpr double kQuaternionSlack = 5e-4; ///< tolerance of the quaternion's length, 1
constexpr std::uint32_t kRod = 1;         ///< flag of a step: the hand holds a rod
constexpr std::uint32_t kRodInPool = 2;   ///< flag of a step: the rod is in the pool
constexpr std::uint32_t kHead = 1;        ///< flag of a person: the head is known
constexpr std::uint32_t kLeft = 2;        ///< flag of a person: the left hand is known
constexpr std::uint32_t kRight = 4;       ///< flag of a person: the right hand is known
constexpr size_t kEndTailBytes = 8;       ///< bytes of the frame's length behind an end's text

void require(bool sound, const char* sentence) {
    if (!sound) throw InputError(sentence);
}

void putPlace(ByteWriter& writer, const glm::vec3& place) {
    for (const float each : {place.x, place.y, place.z})
        writer.f32(each);
}

void putTurn(ByteWriter& writer, const glm::quat& q) {
    for (const float each : {q.x, q.y, q.z, q.w})
        writer.f32(each);
}

glm::vec3 readPlace(ByteReader& reader) {
    const float x = reader.f32(), y = reader.f32(), z = reader.f32();
    for (const float each : {x, y, z})
        require(std::abs(each) <= kFarthest, "a place is not within 100 m; expected metres in the workpiece's frame");
    return {x, y, z};
}

glm::quat readTurn(ByteReader& reader) {
    const float x = reader.f32(), y = reader.f32(), z = reader.f32(), w = reader.f32();
    double square = 0;
    for (const float each : {x, y, z, w})
        square += static_cast<double>(each) * static_cast<double>(each);
    require(std::abs(std::sqrt(square) - 1) <= kQuaternionSlack,
            "an orientation's length is not 1; expected a unit quaternion");
    return {w, x, y, z};
}

/// Calls `take` for each line of `word rest`.
template <class Take>
void eachLine(std::string_view text, Take take) {
    for (const std::string_view line : splitText(text, '\n')) {
        const size_t end = std::min(line.find(' '), line.size());
        if (end > 0) take(line.substr(0, end), trimText(line.substr(end)));
    }
}

double number(std::string_view text, double least, double most, const char* sentence) {
    const auto value = parseDouble(text);
    require(value && *value >= least && *value <= most, sentence);
    return *value;
}

std::uint64_t wholeNumber(std::string_view text, const char* sentence) {
    const auto value = parseInteger(text);
    require(value && *value >= 0, sentence);
    return static_cast<std::uint64_t>(*value);
}

void appendArc(ByteWriter& writer, const ArcState& arc) {
    writer.u32(static_cast<std::uint32_t>(arc.action));
    writer.u32(static_cast<std::uint32_t>(arc.noArc));
    for (const float each : {arc.distance, arc.extension, arc.length, arc.current, arc.voltage})
        writer.f32(each);
    writer.f64(arc.power);
    for (const float each :
         {arc.radius, arc.pressure, arc.shorts, arc.share, arc.stretch, arc.liquid, arc.rodEaten, arc.rodBall})
        writer.f32(each);
}

ArcState readArc(ByteReader& reader) {
    ArcState arc;
    const std::uint32_t action = reader.u32(), noArc = reader.u32();
    require(action <= static_cast<std::uint32_t>(ArcAction::breaking), "the arc's action is unknown; expected 0 to 5");
    require(noArc <= static_cast<std::uint32_t>(NoArc::usedUp), "the reason for no arc is unknown; expected 0 to 11");
    arc.action = static_cast<ArcAction>(action);
    arc.noArc = static_cast<NoArc>(noArc);
    for (float* each : {&arc.distance, &arc.extension, &arc.length, &arc.current, &arc.voltage})
        *each = reader.f32();
    arc.power = reader.f64();
    for (float* each :
         {&arc.radius, &arc.pressure, &arc.shorts, &arc.share, &arc.stretch, &arc.liquid, &arc.rodEaten, &arc.rodBall})
        *each = reader.f32();
    return arc;
}

/// An unknown pose takes as many bytes as a known one.
void putPose(ByteWriter& writer, const std::optional<RecordingPose>& pose) {
    const RecordingPose known = pose.value_or(RecordingPose{});
    putPlace(writer, known.position);
    putTurn(writer, known.orientation);
}

std::optional<RecordingPose> readPose(ByteReader& reader, bool known) {
    const glm::vec3 position = readPlace(reader);
    const glm::quat orientation = readTurn(reader);
    return known ? std::optional(RecordingPose{position, orientation}) : std::nullopt;
}

} // namespace

std::string headContent(const AttemptHead& head) {
    std::string text;
    appendRecordLine(text, "", "format", std::to_string(kRecordingFormat), {});
    appendHeadLines(text, "", head);
    appendRecordLine(text, "", "arc", head.arc ? "yes" : "no", {});
    appendRecordLine(text, "", "rod", head.rod ? "yes" : "no", {});
    appendStartValues(text, "", head);
    return text;
}

AttemptHead readHead(std::string_view content) {
    AttemptHead head;
    std::uint64_t format = 0;
    eachLine(content, [&](std::string_view word, std::string_view rest) {
        if (word == "format") format = wholeNumber(rest, "the format is not a number; expected 1");
        if (readHeadLine(head, word, rest)) return;
        if (word == "arc") head.arc = rest == "yes";
        if (word == "rod") head.rod = rest == "yes";
        if (word != "value") return;
        const size_t key = std::min(rest.find(' '), rest.size());
        require(key > 0 && key < rest.size(), "a value is missing; expected 'value KEY VALUE'");
        head.values.emplace_back(rest.substr(0, key), trimText(rest.substr(key)));
    });
    require(format >= 1 && format <= kRecordingFormat,
            "the recording has another format; expected format 1, or a newer version of the program");
    return head;
}

std::string endContent(const RecordingEnd& end) {
    std::string text;
    appendRecordLine(text, "", "ended", end.reason, {});
    appendRecordLine(text, "", "state_hash", end.stateHash, {});
    appendRecordLine(text, "", "steps", std::to_string(end.steps), {});
    appendRecordLine(text, "", "seconds", formatNumber(end.seconds), {});
    appendRecordLine(text, "", "real_time", formatNumber(end.realTime), {});
    appendRecordLine(text, "", "least_real_time", formatNumber(end.leastRealTime), {});
    if (end.score) appendRecordLine(text, "", "score", formatNumber(*end.score), {});
    if (!end.verdict.empty()) appendRecordLine(text, "", "verdict", end.verdict, {});
    if (end.redone > 0) appendRecordLine(text, "", "redone", std::to_string(end.redone), {});
    std::array<char, kEndTailBytes> length{};
    ByteWriter(length.data()).u64(kFrameBytes + text.size() + kEndTailBytes);
    return text.append(length.data(), length.size());
}

RecordingEnd readEnd(std::string_view content) {
    require(content.size() >= kEndTailBytes, "the end is too short; expected lines and 8 bytes");
    RecordingEnd end;
    eachLine(content.substr(0, content.size() - kEndTailBytes), [&](std::string_view word, std::string_view rest) {
        if (word == "ended") end.reason = rest;
        if (word == "state_hash") end.stateHash = rest;
        if (word == "steps") end.steps = wholeNumber(rest, "steps is not a whole number; expected 0 or more");
        if (word == "seconds") end.seconds = number(rest, 0, kLongest, "seconds is out of range; expected 0 to 86400");
        if (word == "real_time") end.realTime = number(rest, 0, 1e6, "real_time is not a ratio; expected 0 or more");
        if (word == "least_real_time")
            end.leastRealTime = number(rest, 0, 1e6, "least_real_time is not a ratio; expected 0 or more");
        if (word == "score") end.score = number(rest, 0, 100, "score is out of range; expected 0 to 100");
        if (word == "verdict") end.verdict = rest;
        if (word == "redone") end.redone = wholeNumber(rest, "redone is not a whole number; expected 0 or more");
    });
    return end;
}

std::array<char, kStepBytes> stepContent(const RecordingStep& step) {
    std::array<char, kStepBytes> bytes{};
    ByteWriter writer(bytes.data());
    writer.u64(step.steps);
    writer.f64(step.torch.time);
    putPlace(writer, step.torch.tip);
    putTurn(writer, step.torch.orientation);
    writer.f32(step.torch.trigger);
    writer.u32((step.torch.rod ? kRod : 0) | (step.arc.rodInPool ? kRodInPool : 0));
    writer.f64(step.realTime);
    const RodSample rod = step.torch.rod.value_or(RodSample{});
    putPlace(writer, rod.tip);
    putTurn(writer, rod.orientation);
    writer.f32(rod.feed);
    appendArc(writer, step.arc);
    return bytes;
}

RecordingStep readStep(std::string_view content) {
    require(content.size() >= kStepBytes, "a step is too short; expected 160 bytes");
    ByteReader reader(content);
    RecordingStep step;
    step.steps = reader.u64();
    step.torch.time = reader.f64();
    require(step.torch.time >= 0 && step.torch.time <= kLongest, "a time is out of range; expected 0 to 86400 s");
    step.torch.tip = readPlace(reader);
    step.torch.orientation = readTurn(reader);
    step.torch.trigger = reader.f32();
    require(step.torch.trigger >= 0 && step.torch.trigger <= 1, "a trigger is out of range; expected 0 to 1");
    const std::uint32_t flags = reader.u32();
    step.realTime = reader.f64();
    require(step.realTime >= 0 && step.realTime <= 1e6, "a step's real time is not a ratio; expected 0 or more");
    RodSample rod;
    rod.tip = readPlace(reader);
    rod.orientation = readTurn(reader);
    rod.feed = reader.f32();
    require(rod.feed >= 0 && rod.feed <= 1, "a rod's feed is out of range; expected 0 to 1 m/s");
    if ((flags & kRod) != 0) step.torch.rod = rod;
    step.arc = readArc(reader);
    step.arc.rodInPool = (flags & kRodInPool) != 0;
    return step;
}

std::array<char, kPersonBytes> personContent(const RecordingPerson& person) {
    std::array<char, kPersonBytes> bytes{};
    ByteWriter writer(bytes.data());
    writer.u64(person.steps);
    writer.u32((person.head ? kHead : 0) | (person.left ? kLeft : 0) | (person.right ? kRight : 0));
    writer.f32(person.zoom);
    for (const auto* pose : {&person.head, &person.left, &person.right})
        putPose(writer, *pose);
    return bytes;
}

RecordingPerson readPerson(std::string_view content) {
    require(content.size() >= kPersonBytes, "the person's data is too short; expected 100 bytes");
    ByteReader reader(content);
    RecordingPerson person;
    person.steps = reader.u64();
    const std::uint32_t flags = reader.u32();
    person.zoom = reader.f32();
    require(person.zoom > 0 && person.zoom <= 1000, "a zoom is out of range; expected more than 0, at most 1000");
    person.head = readPose(reader, (flags & kHead) != 0);
    person.left = readPose(reader, (flags & kLeft) != 0);
    person.right = readPose(reader, (flags & kRight) != 0);
    return person;
}

std::array<char, kNoteHeadBytes> noteHead(std::uint64_t steps, std::string_view name) {
    std::array<char, kNoteHeadBytes> bytes{};
    ByteWriter writer(bytes.data());
    writer.u64(steps);
    writer.u32(static_cast<std::uint32_t>(name.size()));
    return bytes;
}

RecordingNote readNote(std::string_view content) {
    require(content.size() >= kNoteHeadBytes, "a change or event is too short; expected 12 bytes and its name");
    ByteReader reader(content);
    RecordingNote note;
    note.steps = reader.u64();
    const std::uint32_t length = reader.u32();
    require(length > 0 && length <= reader.left(), "a change or event has no name; expected a name within its frame");
    note.name = reader.rest().substr(0, length);
    note.value = reader.rest().substr(length);
    return note;
}

std::array<char, kCheckpointHeadBytes> checkpointHead(const CheckpointHead& head) {
    std::array<char, kCheckpointHeadBytes> bytes{};
    ByteWriter writer(bytes.data());
    writer.u64(head.steps);
    writer.u32(head.redone);
    return bytes;
}

CheckpointHead readCheckpointHead(std::string_view content) {
    require(content.size() >= kCheckpointHeadBytes, "a checkpoint is too short; expected 12 bytes or more");
    ByteReader reader(content);
    CheckpointHead head;
    head.steps = reader.u64();
    head.redone = reader.u32();
    return head;
}

} // namespace meltpool
