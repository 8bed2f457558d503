// The keeper of a session's recordings: one of each attempt, made automatically, and a fault if it cannot be made.
#pragma once

#include "app/library/persons.hpp"
#include "app/library/recordings_limit.hpp"
#include "core/render/view.hpp"
#include "core/training/attempt/recording_writer.hpp"
#include "core/training/trainer/trainer.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meltpool {

class RecordingKeeper {
  public:
    RecordingParameters parameters;

    /// Gives each attempt from the next one on a recording in `folder`, which is created if missing. `program` and
    /// `driver` are written to each.
    void use(const std::filesystem::path& folder, std::string program, std::string driver);

    /// Writes this welder to each recording from the next attempt on; those of a guest have none.
    void weldedBy(const AttemptOwner& welder) { welder_ = welder; }

    /// Begins an attempt. An obstacle to its recording is in fault(): the attempt goes on without one. Makes room
    /// within the limit.
    void begin(Trainer& trainer, int attempt);
    /// Begins another attempt with the frames of the running one, whose recording has ended; a no-op without one. Waits
    /// for the disk. Otherwise as begin().
    void fork(Trainer& trainer, int attempt);
    /// Score (0..100) and verdict of the attempt so far, for the end of its recording.
    void judged(std::optional<double> score, std::string verdict);
    /// Ends the attempt: its trainer has ended the recording, or is gone. Does not wait for the disk.
    void close();

    /// Records head and hands before the next step. Never waits, allocates nothing; no-op without a recording.
    void person(const RecordingPerson& person) {
        if (current_) current_->person(person);
    }

    /// Checks for failures; call it after each frame. Allocates nothing while nothing fails.
    void update();
    /// Sentence for the person while it holds: this attempt, or the end of the one before, is not recorded. Empty
    /// without a fault.
    const std::string& fault() const { return fault_; }
    /// Sentence to show once: recordings were removed, or soon are; empty: none.
    std::string takeNotice() { return std::exchange(notice_, {}); }

    /// Waits until everything is on the disk.
    void finish();
    /// Fault of the first attempt that is not recorded to its end; empty: all are.
    const std::string& lost() const { return lost_; }

    /// Recording of the running attempt; null: it has none.
    RecordingWriter* current() { return current_.get(); }
    const RecordingWriter* current() const { return current_.get(); }
    const std::shared_ptr<RecordingWriter>& writer() const { return current_; }
    /// Recording of the newest attempt that has one.
    const std::filesystem::path& file() const { return newest_; }

  private:
    /// Recording of an ended attempt, until everything is on the disk.
    struct Closing {
        std::shared_ptr<RecordingWriter> writer;
        bool told = false; ///< true: its fault was reported while the attempt ran
    };

    void open(Trainer& trainer, AttemptHead head, const std::filesystem::path& from = {});
    AttemptHead headOf(Trainer& trainer) const;
    void freeSpace();
    void tell(std::string_view key, std::string_view reason);

    std::filesystem::path folder_;
    std::string program_, driver_;
    AttemptOwner welder_;
    std::filesystem::path newest_;
    std::vector<std::filesystem::path> made_; ///< recordings of this run, which the limit never removes
    std::shared_ptr<RecordingWriter> current_;
    std::vector<Closing> closing_;
    bool told_ = false; ///< true: the fault of current_ was reported
    bool nearLimitTold_ = false;
    std::string fault_;
    std::string notice_;
    std::string lost_;
};

/// Head of the person at the desk, from the camera. `turn`: from the workpiece's frame to the room's. `unit`: m of a
/// unit of the view's world.
RecordingPerson deskPerson(const View& view, const glm::mat3& turn, float unit, std::uint64_t steps);

} // namespace meltpool
