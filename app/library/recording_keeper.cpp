#include "app/library/recording_keeper.hpp"

#include "core/base/error.hpp"
#include "core/base/files.hpp"
#include "core/base/moment.hpp"
#include "core/base/resources.hpp"
#include "core/base/words.hpp"
#include "core/training/attempt/recording_reader.hpp"

#include <glm/matrix.hpp>

#include <chrono>
#include <utility>

namespace meltpool {

namespace fs = std::filesystem;

namespace {

/// File of a lesson outside the catalogue; those inside are found by their key.
std::string fileOutsideCatalogue(const Lesson& lesson) {
    std::error_code failure;
    const bool shipped = fs::equivalent(lesson.file.parent_path(), resourceFolder() / "data" / "lessons", failure);
    return shipped ? std::string() : fs::absolute(lesson.file, failure).string();
}

} // namespace

void RecordingKeeper::use(const fs::path& folder, std::string program, std::string driver) {
    folder_ = folder;
    program_ = std::move(program);
    driver_ = std::move(driver);
}

void RecordingKeeper::begin(Trainer& trainer, int attempt) {
    close();
    fault_.clear();
    if (folder_.empty() || !parameters.keep || welder_.kind == AttemptOwner::Kind::guest) return;
    try {
        AttemptHead head = headOf(trainer);
        head.attempt = attempt;
        open(trainer, std::move(head));
    } catch (const std::exception& failure) {
        tell("library.recording.not_begun", failure.what());
    }
}

void RecordingKeeper::fork(Trainer& trainer, int attempt) {
    if (!current_) return;
    const fs::path from = current_->file();
    current_->wait();
    close();
    fault_.clear();
    try {
        AttemptHead head =
            readRecordingSummary(from).head; // the values at the start, which may differ from the present
        head.attempt = attempt;
        open(trainer, std::move(head), from);
    } catch (const std::exception& failure) {
        tell("library.recording.not_begun", failure.what());
    }
}

AttemptHead RecordingKeeper::headOf(Trainer& trainer) const {
    AttemptHead head = trainer.attemptHead();
    head.lessonFile = fileOutsideCatalogue(trainer.lesson());
    head.lessonHash = fileHash(trainer.lesson().file);
    head.person = welder_.person.name;
    head.personId = welder_.person.id;
    head.program = program_;
    head.driver = driver_;
    return head;
}

/// `from`: see RecordingWriter.
void RecordingKeeper::open(Trainer& trainer, AttemptHead head, const fs::path& from) {
    std::error_code failure;
    fs::create_directories(folder_, failure);
    if (failure)
        throw InputError(folder_, 0,
                         "the folder of recordings cannot be created: " + failure.message() +
                             "; expected a parent folder with write permission");
    freeSpace();
    const Moment now = momentNow();
    head.date = isoDate(std::chrono::system_clock::to_time_t(now));
    head.utc = utcText(now);
    const fs::path file = recordingName(folder_, head.date, head.lesson, head.attempt);
    current_ = std::make_shared<RecordingWriter>(file, head, from);
    newest_ = file;
    made_.push_back(file);
    told_ = false;
    trainer.recordInto(current_);
}

void RecordingKeeper::freeSpace() {
    const std::uint64_t limit = static_cast<std::uint64_t>(parameters.limitMb) * 1'000'000;
    notice_ = keepWithinLimit(folder_, limit, made_);
    if (!notice_.empty() || nearLimitTold_) return;
    notice_ = nearLimit(folder_, limit, made_);
    nearLimitTold_ = !notice_.empty();
}

void RecordingKeeper::judged(std::optional<double> score, std::string verdict) {
    if (current_) current_->judged(score, std::move(verdict));
}

void RecordingKeeper::close() {
    if (!current_) return;
    current_->close();
    closing_.push_back({std::move(current_), told_});
    current_ = nullptr;
}

void RecordingKeeper::tell(std::string_view key, std::string_view reason) {
    fault_ = phrase(key, {{"reason", reason}});
    if (lost_.empty()) lost_ = fault_;
}

void RecordingKeeper::update() {
    if (current_ && !told_ && !current_->fault().empty()) {
        told_ = true;
        tell("library.recording.stopped", current_->fault());
    }
    std::erase_if(closing_, [this](const Closing& each) {
        if (!each.writer->finished()) return false;
        if (!each.told && !each.writer->fault().empty()) tell("library.recording.not_ended", each.writer->fault());
        return true;
    });
}

void RecordingKeeper::finish() {
    close();
    for (const Closing& each : closing_)
        each.writer->wait();
    update();
}

RecordingPerson deskPerson(const View& view, const glm::mat3& turn, float unit, std::uint64_t steps) {
    const glm::mat3 toWorkpiece = glm::transpose(turn);
    RecordingPerson person;
    person.steps = steps;
    person.head =
        RecordingPose{toWorkpiece * (view.eye * unit),
                      glm::normalize(glm::quat_cast(toWorkpiece * glm::transpose(glm::mat3(view.worldToEye))))};
    return person;
}

} // namespace meltpool
