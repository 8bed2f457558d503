// Keeps a recording of each attempt of a session, without being asked, and tells where it cannot.
#pragma once

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

    /// From the next attempt on each has a recording in `folder`, which is made where it is not there. `program` and
    /// `driver` stand in each.
    void use(const std::filesystem::path& folder, std::string program, std::string driver);

    /// An attempt begins. What prevents its recording stands in fault(): the attempt goes on without. Makes room within
    /// the limit.
    void begin(Trainer& trainer, int attempt);
    /// Score (0..100) and verdict of the attempt as far as it was judged, for the end of its recording.
    void judged(std::optional<double> score, std::string verdict);
    /// The attempt is over: its trainer has ended the recording, or is lost. Does not wait for the disk.
    void close();

    /// Where head and hands are before the next step. Never waits, allocates nothing; nothing without a recording.
    void person(const RecordingPerson& person) {
        if (current_) current_->person(person);
    }

    /// Looks after each frame whether something failed. Allocates nothing while nothing does.
    void update();
    /// What the person must be told while it lasts: this attempt, or the end of the one before, is not recorded. A
    /// sentence; empty while all is well.
    const std::string& fault() const { return fault_; }
    /// What is told once, as a sentence: that recordings were removed, or soon are; empty: nothing.
    std::string takeNotice() { return std::exchange(notice_, {}); }

    /// Waits until everything is on the disk.
    void finish();
    /// The fault of the first attempt that is not recorded to its end; empty: all are.
    const std::string& lost() const { return lost_; }

    /// The recording of the running attempt; null: it has none.
    RecordingWriter* current() { return current_.get(); }
    const std::shared_ptr<RecordingWriter>& writer() const { return current_; }
    /// Of the newest attempt that has one.
    const std::filesystem::path& file() const { return newest_; }

  private:
    /// Of an attempt that is over, until everything is on the disk.
    struct Closing {
        std::shared_ptr<RecordingWriter> writer;
        bool told = false; ///< its fault, while the attempt ran
    };

    void open(Trainer& trainer, int attempt);
    void makeRoom();
    void tell(std::string_view key, std::string_view reason);

    std::filesystem::path folder_;
    std::string program_, driver_;
    std::filesystem::path newest_;
    std::vector<std::filesystem::path> made_; ///< in this run of the program: the limit never removes these
    std::shared_ptr<RecordingWriter> current_;
    std::vector<Closing> closing_;
    bool told_ = false; ///< the fault of current_
    bool nearLimitTold_ = false;
    std::string fault_;
    std::string notice_;
    std::string lost_;
};

/// The desk's camera as the person's head. `turn`: from the workpiece's frame to the room's. `unit`: m of a unit of the
/// view's world.
RecordingPerson deskPerson(const View& view, const glm::mat3& turn, float unit, std::uint64_t steps);

} // namespace meltpool
