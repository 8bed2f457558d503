// Log of a session's attempts: their records, their recordings, and the moments to go back to.
#pragma once

#include "app/activities/redo.hpp"
#include "app/library/recording_keeper.hpp"
#include "core/training/trainer/trainer.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace meltpool {

/// Each attempt has a file of its own, and none replaces another.
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
    /// file() where it is whole and an ordinary file, so that others can stand beside it; else empty.
    std::filesystem::path wholeFile() const;
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

class AttemptLog {
  public:
    AttemptRecords& records() { return records_; }
    const AttemptRecords& records() const { return records_; }
    /// Kept of every attempt, without being asked for.
    RecordingKeeper& recordings() { return recordings_; }
    const RecordingKeeper& recordings() const { return recordings_; }
    /// Earlier moments of the running attempt.
    Redo& moments() { return moments_; }
    const Redo& moments() const { return moments_; }

    /// An attempt begins. `goesBack`: it may go back to earlier moments. Answers why its record cannot be written;
    /// empty: it is, or none is wanted.
    std::string begin(Trainer& trainer, bool goesBack);
    /// After the steps of a frame: keeps this moment where it is time to. `speed`: of making steps alone, over the
    /// clock. Never waits.
    void keepMoment(const Trainer& trainer, double speed);
    /// The attempt is about to end with this judgement, which its recording names; null: the weld is not judged, or
    /// went on after it was.
    void judged(const Judgement* judgement);
    /// Ends the files of the attempt; they name `reason`.
    void stop(Trainer& trainer, std::string_view reason) noexcept;
    /// The attempt's trainer was reset or is gone: its recording takes no more. Does not wait for the disk.
    void close() { recordings_.close(); }

  private:
    AttemptRecords records_;
    RecordingKeeper recordings_;
    Redo moments_;
};

} // namespace meltpool
