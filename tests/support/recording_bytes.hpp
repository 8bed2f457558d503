// Makes recordings in memory, and damaged ones with hashes that fit.
#pragma once

#include "core/training/attempt/content.hpp"
#include "core/training/attempt/frame.hpp"
#include "core/training/attempt/little_endian.hpp"

#include <string>

namespace meltpool::test {

/// Makes step number `i`, from 1, of an attempt in which all values move.
inline RecordingStep recordedStep(int i) {
    const float f = static_cast<float>(i);
    RecordingStep step;
    step.steps = static_cast<std::uint64_t>(i);
    step.torch = {i / 90.0,
                  {0.001f * f, 0.02f / f, -0.003f},
                  glm::normalize(glm::quat(1.0f, 0.1f * f, 0.2f, -0.3f)),
                  static_cast<float>(i % 2)};
    if (i % 3 == 0) step.torch.rod = RodSample{{0.01f * f, 0.1f, 0.2f}, {0.6f, 0.8f, 0, 0}, 0.001f * f};
    step.arc.action = static_cast<ArcAction>(i % 6);
    step.arc.noArc = static_cast<NoArc>(i % 12);
    step.arc.length = 0.002f / f;
    step.arc.power = 1.0 / i;
    step.arc.rodBall = 0.1f / f;
    step.arc.rodInPool = i % 4 == 0;
    step.realTime = 1.0 / (1 + i % 3);
    return step;
}

inline AttemptHead recordedHead(const std::string& lesson) {
    AttemptHead head;
    head.lesson = lesson;
    head.lessonHash = "00000000000000ab";
    head.attempt = 3;
    head.date = "2026-11-23T08:10:43+0100";
    head.program = "1.0 abc";
    head.driver = "a driver\nwith two lines";
    head.values = {{"solidify_rate", "0.25"}, {"gravity", "0,-9.81,0"}};
    head.chosen = {"solidify_rate"};
    head.arc = head.rod = true;
    return head;
}

inline RecordingEnd recordedEnd(int steps) {
    RecordingEnd end;
    end.reason = "start menu";
    end.stateHash = "0123456789abcdef";
    end.steps = static_cast<std::uint64_t>(steps);
    end.seconds = steps / 90.0;
    end.realTime = 0.75;
    end.leastRealTime = 1.0 / 3;
    end.score = 83.5;
    end.verdict = "accepted";
    return end;
}

/// Writes a recording in memory, frame after frame.
class RecordingBytes {
  public:
    RecordingBytes() : bytes_(kRecordingSignature) {}

    RecordingBytes& add(std::uint32_t kind, std::string_view content) {
        appendFrame(bytes_, chain_, kind, content);
        return *this;
    }
    RecordingBytes& add(FrameKind kind, std::string_view content) {
        return add(static_cast<std::uint32_t>(kind), content);
    }
    RecordingBytes& head(const AttemptHead& head) { return add(FrameKind::head, headContent(head)); }
    RecordingBytes& step(const RecordingStep& step) {
        const auto content = stepContent(step);
        return add(FrameKind::step, {content.data(), content.size()});
    }
    RecordingBytes& note(FrameKind kind, int steps, const std::string& name, const std::string& value) {
        const auto start = noteHead(static_cast<std::uint64_t>(steps), name);
        return add(kind, std::string(start.data(), start.size()) + name + value);
    }
    RecordingBytes& checkpoint(const CheckpointHead& head, const std::string& state) {
        const auto start = checkpointHead(head);
        return add(FrameKind::checkpoint, std::string(start.data(), start.size()) + state);
    }
    RecordingBytes& end(const RecordingEnd& end) { return add(FrameKind::end, endContent(end)); }

    const std::string& bytes() const { return bytes_; }

  private:
    std::string bytes_;
    FrameChain chain_;
};

/// Makes an attempt of so many steps with a bit of everything.
inline std::string recordingOf(const std::string& lesson, int steps) {
    RecordingBytes recording;
    recording.head(recordedHead(lesson)).note(FrameKind::event, 0, "zoom", "2");
    for (int i = 1; i <= steps; ++i) {
        recording.step(recordedStep(i));
        if (i == 1) recording.note(FrameKind::change, 1, "solidify_rate", "0.5");
        if (i == 2) recording.note(FrameKind::event, 2, "torch", "lost").add(frameKind("LATE"), "of a later version");
    }
    return recording.end(recordedEnd(steps)).bytes();
}

/// Returns these bytes with checks and hashes that fit them, as far as the frames' lengths lead.
inline std::string resealed(std::string bytes) {
    if (!std::string_view(bytes).starts_with(kRecordingSignature)) return bytes;
    std::string sealed(kRecordingSignature);
    FrameChain chain;
    size_t at = kRecordingSignature.size();
    while (at + kFrameBytes <= bytes.size()) {
        ByteReader head(std::string_view(bytes).substr(at, kFrameHeadBytes));
        const std::uint32_t kind = head.u32(), length = head.u32();
        if (length > bytes.size() - at - kFrameBytes) break;
        appendFrame(sealed, chain, kind, std::string_view(bytes).substr(at + kFrameHeadBytes, length));
        at += kFrameBytes + length;
    }
    return sealed + bytes.substr(at);
}

} // namespace meltpool::test
