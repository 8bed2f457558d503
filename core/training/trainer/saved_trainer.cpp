// Saves and restores a running lesson: Trainer's own part of a checkpoint, and the order of all parts.
#include "core/base/error.hpp"
#include "core/base/hash.hpp"
#include "core/training/trainer/trainer.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <type_traits>
#include <variant>

namespace meltpool {

namespace {

constexpr size_t kAnyNumber = std::numeric_limits<size_t>::max();

void transferRod(gl::StateArchive& archive, std::optional<RodSample>& rod) {
    bool held = rod.has_value();
    archive.values(held);
    if (archive.restores()) rod = held ? std::optional(RodSample()) : std::nullopt;
    if (rod) archive.values(rod->tip, rod->orientation, rod->feed);
}

void transferTorch(gl::StateArchive& archive, TorchSample& torch) {
    archive.values(torch.time, torch.tip, torch.orientation, torch.trigger);
    transferRod(archive, torch.rod);
}

/// Index of the first note after so many steps or more.
template <class Notes>
size_t firstFrom(const Notes& notes, size_t steps) {
    const auto first =
        std::partition_point(notes.begin(), notes.end(), [&](const auto& note) { return note.steps < steps; });
    return static_cast<size_t>(first - notes.begin());
}

} // namespace

void RealTimeCount::transfer(gl::StateArchive& archive) {
    archive.count(steps_, kAnyNumber);
    archive.values(realSteps_, least_);
}

/// Hash of the lesson's key and of all choices before the metal is made; values that may change during the weld are in
/// the checkpoint itself.
std::uint64_t Trainer::identityOf(Lesson& lesson) {
    std::string text = lesson.key;
    for (const Parameter& parameter : lesson.metalParameters())
        if (parameter.onlyAtStart) text += "\n" + std::string(parameter.key) + "=" + parameterText(parameter);
    return hashOfBytes(std::as_bytes(std::span(text)));
}

ParameterList Trainer::liveParameters(Lesson& lesson) {
    ParameterList list = lesson.metalParameters();
    std::erase_if(list, [](const Parameter& parameter) { return parameter.onlyAtStart; });
    return list;
}

void Trainer::transferLesson(gl::StateArchive& archive) {
    for (Parameter& parameter : live_)
        std::visit(
            [&](auto* value) {
                if constexpr (std::is_same_v<decltype(value), std::string*>)
                    archive.text(*value);
                else
                    archive.values(*value);
            },
            parameter.value);
}

/// Pending readings of the metal are not saved: figures are read again from the restored metal.
void Trainer::transfer(gl::StateArchive& archive) {
    transferLesson(archive);
    if (archive.restores()) applyValues();
    const auto transferMetal = [&](MetalModel& metal) { metal.transfer(archive); };
    archive.restores() ? metal_.change(transferMetal) : metal_.run(transferMetal);
    archive.values(time_, tracked_);
    figures_.transfer(archive);
    recorder_.transfer(archive);
    for (size_t* each : {&steps_, &nextChange_, &nextEvent_})
        archive.count(*each, kAnyNumber);
    archive.values(account_.seconds, account_.charge, account_.energy);
    archive.values(surfaceDistance_.ahead, surfaceDistance_.nearest, surfaceDistance_.liquid, surfaceDistance_.normal);
    arc_.transfer(archive);
    transferTorch(archive, torch_);
    sound_.transfer(archive);
    if (technique_) technique_->transfer(archive);
}

/// Two calls leave the particles unchanged.
void Trainer::xorOutDerivedState() {
    metal_.run([](MetalModel& metal) { metal.xorOutDerivedState(); });
}

void Trainer::capture(CheckpointCapture& capture, size_t historyFrom) const {
    auto& self = const_cast<Trainer&>(*this); // saving changes no value: one set of functions saves and restores
    Checkpoint& head = capture.begin();
    head.step = steps_;
    head.time = time_;
    head.identity = identity_;
    const size_t known = technique_ ? technique_->steps().size() : 0;
    head.historyFrom = std::min(historyFrom, known);
    head.historyTo = known;
    head.historyTime = head.historyFrom > 0 ? technique_->steps()[head.historyFrom - 1].time : 0;
    gl::StateArchive history(head.history);
    if (technique_) self.technique_->transferSteps(history, head.historyFrom, known);
    gl::StateArchive archive(capture.state());
    self.transfer(archive);
    self.xorOutDerivedState();
    capture.request();
    self.xorOutDerivedState();
}

Checkpoint Trainer::save(size_t historyFrom) const {
    CheckpointCapture capture;
    this->capture(capture, historyFrom);
    capture.wait();
    Checkpoint checkpoint;
    capture.take(checkpoint);
    return checkpoint;
}

/// Throws InputError if the checkpoint cannot be restored here.
void Trainer::requireFit(const Checkpoint& checkpoint) const {
    requireWhole(checkpoint);
    if (checkpoint.identity != identity_)
        throw InputError("the checkpoint belongs to another lesson or workpiece; expected one of " + lesson_.key +
                         " with its start values");
    if (checkpoint.historyFrom > checkpoint.historyTo ||
        checkpoint.history.size() != (checkpoint.historyTo - checkpoint.historyFrom) * kTechniqueStepBytes)
        throw InputError("the checkpoint of step " + std::to_string(checkpoint.step) +
                         " holds fewer or more torch steps than it says; expected a complete checkpoint");
    if (!technique_ || checkpoint.historyFrom == 0) return;
    const auto& steps = technique_->steps();
    if (steps.size() < checkpoint.historyFrom || steps[checkpoint.historyFrom - 1].time != checkpoint.historyTime)
        throw InputError("the checkpoint continues after torch step " + std::to_string(checkpoint.historyFrom) +
                         ", which is missing here; expected the attempt that saved it");
}

void Trainer::restore(const Checkpoint& checkpoint) {
    requireFit(checkpoint);
    figures_.finish(); // waiting rows belong to the earlier metal
    if (technique_) {
        gl::StateArchive history(std::span<const std::byte>(checkpoint.history));
        technique_->transferSteps(history, checkpoint.historyFrom, checkpoint.historyTo);
    }
    gl::StateArchive archive(std::span<const std::byte>(checkpoint.bytes));
    transfer(archive);
    if (!archive.atEnd())
        throw InputError("the checkpoint of step " + std::to_string(checkpoint.step) +
                         " has more bytes than this lesson's state; expected one that this program saved");
    xorOutDerivedState();
    if (watcher_ != nullptr) watcher_->restored();
    figures_.readAgain();
    if (!lesson_.recorded) return;
    // A checkpoint may be of the attempt itself, which repeated no change; changes at this very step may come again.
    nextChange_ = firstFrom(lesson_.recorded->changes, steps_);
    nextEvent_ = firstFrom(lesson_.recorded->events, steps_);
}

void Trainer::redo(const Checkpoint& checkpoint) {
    restore(checkpoint);
    event("redo", std::to_string(steps_));
    for (const Parameter& parameter : live_)
        recorder_.change(steps_, parameter.key, parameterText(parameter));
    event("torch", tracked_ ? "seen" : "lost");
}

} // namespace meltpool
