// Log of a session's attempts: their records, their recordings, and the checkpoints to go back to.
#pragma once

#include "app/activities/redo.hpp"
#include "app/library/recording_keeper.hpp"
#include "core/training/trainer/trainer.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace meltpool {

/// Records of attempts. Each attempt has a file of its own, and none replaces another.
class AttemptRecords {
  public:
    /// Gives each attempt from the next one on a record: `file` for the first, `file`-2 next to it and so on for later
    /// ones. Names that exist already are skipped. `program` and `driver` are written to each.
    void use(const std::filesystem::path& file, std::string program, std::string driver);
    /// Writes this welder to each record from the next attempt on; a guest has no name.
    void weldedBy(const AttemptOwner& welder) { welder_ = welder; }
    const AttemptOwner& welder() const { return welder_; }
    bool wanted() const { return !file_.empty(); }

    /// Counts another attempt and begins its record, if one is wanted, with the rows of the record `from`, if that is
    /// not empty. Throws InputError when it cannot be written.
    void begin(Trainer& trainer, const std::filesystem::path& from = {});
    /// Continues the attempt without a record, as the person agreed.
    void renounce() { lost_ = true; }
    /// Checks if the running record was cut short.
    void check(const Trainer& trainer) { lost_ = lost_ || !trainer.recordFault().empty(); }

    int attempt() const { return attempt_; }
    /// Record of the newest attempt that has one.
    const std::filesystem::path& file() const { return newest_; }
    /// Returns file() if it is whole and an ordinary file, so that other files can be placed next to it; else an empty
    /// path.
    std::filesystem::path wholeFile() const;
    /// True if an attempt has no complete record although one was wanted.
    bool lost() const { return lost_; }

  private:
    std::filesystem::path freeName() const;

    std::filesystem::path file_;
    std::filesystem::path newest_;
    std::string program_, driver_;
    AttemptOwner welder_;
    int attempt_ = 0;
    bool lost_ = false;
};

class AttemptLog {
  public:
    AttemptRecords& records() { return records_; }
    const AttemptRecords& records() const { return records_; }
    /// Recordings, made of every attempt automatically.
    RecordingKeeper& recordings() { return recordings_; }
    const RecordingKeeper& recordings() const { return recordings_; }
    /// Checkpoints of the running attempt.
    Redo& redo() { return redo_; }
    const Redo& redo() const { return redo_; }

    /// Takes the welder of all attempts from the next one on.
    void weldedBy(const AttemptOwner& welder);

    /// Begins an attempt. `goesBack`: it may return to checkpoints. Returns the reason why its record cannot be
    /// written; empty: it is written, or none is wanted.
    std::string begin(Trainer& trainer, bool goesBack);
    /// Ends the files of the attempt, and goes on in others, of another attempt with the same beginning. Returns as
    /// begin() does. Waits for GPU and disk.
    std::string fork(Trainer& trainer);
    /// Takes a checkpoint when one is due; call it after the steps of a frame. `speed`: of making steps alone, over the
    /// clock. Never waits.
    void keepCheckpoint(const Trainer& trainer, double speed);
    /// Passes the judgement of an attempt that is about to end to its recording; null: the weld is not judged, or went
    /// on after its judgement.
    void judged(const Judgement* judgement);
    /// Ends the files of the attempt and writes `reason` to them.
    void stop(Trainer& trainer, std::string_view reason) noexcept;
    /// Closes the recording, because the attempt's trainer was reset or is gone. Does not wait for the disk.
    void close() { recordings_.close(); }

  private:
    AttemptRecords records_;
    RecordingKeeper recordings_;
    Redo redo_;
};

} // namespace meltpool
