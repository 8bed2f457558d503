// The records of a session's attempts: each has a file of its own, and none replaces another.
#pragma once

#include "core/training/trainer/trainer.hpp"

#include <filesystem>
#include <string>

namespace meltpool {

class AttemptRecords {
  public:
    /// From the next attempt on each has a record: `file` for the first, beside it `file`-2 and so on for those that
    /// follow. A name that a file has already is passed over. `program` and `driver` stand in each.
    void use(const std::filesystem::path& file, std::string program, std::string driver);
    bool wanted() const { return !file_.empty(); }

    /// Counts another attempt and begins its record, where one is wanted. Throws InputError when it cannot be written.
    void begin(Trainer& trainer);
    /// The attempt goes on without a record, as the person agreed.
    void renounce() { lost_ = true; }
    /// Looks whether the running record was cut short.
    void check(const Trainer& trainer) { lost_ = lost_ || !trainer.recordFault().empty(); }

    int attempt() const { return attempt_; }
    /// Of the newest attempt that has one.
    const std::filesystem::path& file() const { return newest_; }
    /// An attempt has no record, or none to its end, though one was wanted.
    bool lost() const { return lost_; }

  private:
    std::filesystem::path freeName() const;

    std::filesystem::path file_;
    std::filesystem::path newest_;
    std::string program_, driver_;
    int attempt_ = 0;
    bool lost_ = false;
};

} // namespace meltpool
