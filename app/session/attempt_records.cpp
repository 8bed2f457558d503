#include "app/session/attempt_records.hpp"

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

void AttemptRecords::begin(Trainer& trainer) {
    ++attempt_;
    if (!wanted()) return;
    const std::filesystem::path name = freeName();
    trainer.record(name, {attempt_, program_, driver_, true, false});
    newest_ = name;
}

} // namespace meltpool
