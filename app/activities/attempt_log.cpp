#include "app/activities/attempt_log.hpp"

#include "core/base/output_file.hpp"

namespace meltpool {

void AttemptRecords::use(const std::filesystem::path& file, std::string program, std::string driver) {
    file_ = file;
    program_ = std::move(program);
    driver_ = std::move(driver);
}

std::filesystem::path AttemptRecords::freeName() const {
    std::error_code failure;
    if (!std::filesystem::is_regular_file(file_, failure)) return file_; // devices and pipes take every attempt
    for (int number = 2;; ++number) {
        std::filesystem::path name = file_;
        name.replace_filename(file_.stem().string() + "-" + std::to_string(number) + file_.extension().string());
        if (!std::filesystem::exists(std::filesystem::symlink_status(name, failure))) return name;
    }
}

std::filesystem::path AttemptRecords::wholeFile() const {
    return !lost_ && !newest_.empty() && isPlainFile(newest_) ? newest_ : std::filesystem::path();
}

void AttemptRecords::begin(Trainer& trainer, const std::filesystem::path& from) {
    ++attempt_;
    if (!wanted()) return;
    const std::filesystem::path name = freeName();
    trainer.record(name, {attempt_, program_, driver_, true, false, welder_.person.name, welder_.person.id, from});
    newest_ = name;
}

void AttemptLog::weldedBy(const AttemptOwner& welder) {
    records_.weldedBy(welder);
    recordings_.weldedBy(welder);
}

std::string AttemptLog::begin(Trainer& trainer, bool goesBack) {
    recordings_.begin(trainer, records_.attempt() + 1);
    redo_.begin(recordings_.writer(), goesBack);
    try {
        records_.begin(trainer);
    } catch (const std::runtime_error& fault) { // no such place, or no room even for its head
        return fault.what();
    }
    return {};
}

std::string AttemptLog::fork(Trainer& trainer) {
    // A record on a device or a pipe cannot be read again: it goes on with the new rows alone.
    const std::filesystem::path before = trainer.writesCsvRecord() ? records_.wholeFile() : std::filesystem::path();
    trainer.stopRecord("another attempt began");
    records_.check(trainer);
    recordings_.fork(trainer, records_.attempt() + 1);
    redo_.recordInto(recordings_.writer());
    try {
        records_.begin(trainer, before);
    } catch (const std::runtime_error& fault) {
        return fault.what();
    }
    return {};
}

void AttemptLog::keepCheckpoint(const Trainer& trainer, double speed) {
    if (redo_.goes() || recordings_.current() != nullptr) redo_.update(trainer, speed);
}

void AttemptLog::judged(const Judgement* judgement) {
    if (judgement == nullptr) return recordings_.judged({}, {});
    const bool scored = judgement->score && judgement->score->scored;
    const char* verdict = !judgement->verdict ? "" : judgement->verdict->accepted ? "accepted" : "not accepted";
    recordings_.judged(scored ? std::optional(judgement->score->total) : std::nullopt, verdict);
}

void AttemptLog::stop(Trainer& trainer, std::string_view reason) noexcept {
    try {
        trainer.stopRecord(reason);
        records_.check(trainer);
    } catch (const std::exception&) {
        records_.renounce(); // the metal itself cannot be read any more
    }
}

} // namespace meltpool
