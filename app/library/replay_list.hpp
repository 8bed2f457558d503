// The stored attempts in the home page's list: their order, names, deletion, replay and comparison.
#pragma once

#include "app/library/attempt_order.hpp"
#include "core/base/function_ref.hpp"

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meltpool {

class ReplayList {
  public:
    /// Title of the lesson with this key.
    using TitleOf = FunctionRef<std::string(const std::string&)>;

    /// Shows the list and reads the attempts of `folder`, or of recordingsFolder(). Files that have a recording's name
    /// and are none are reported in fault(). Filter and order stay, and the chosen row if its attempt is there.
    void show();
    void show(const std::filesystem::path& folder);
    void hide();
    bool shown() const { return shown_; }

    /// Shows the list with these, newest first.
    void show(std::vector<ReplayEntry> entries);

    /// Entries, newest first.
    const std::vector<ReplayEntry>& entries() const { return entries_; }
    /// Sentence that says why entries are missing; empty if all are there.
    const std::string& fault() const { return fault_; }

    /// Rows of the list: indices of entries(), filtered and in order.
    const std::vector<size_t>& rows(TitleOf titleOf);
    const AttemptFilter& filter() const { return filter_; }
    void setFilter(AttemptFilter filter);
    AttemptOrder order() const { return order_; }
    /// Sorts by the column whose heading was pressed, see pressedColumn().
    void press(AttemptColumn column);
    /// Keys of the lessons in the list, by their titles, each with its title.
    std::vector<std::pair<std::string, std::string>> lessons(TitleOf titleOf);

    /// Index of the entry that the buttons act on; nothing if no row is shown.
    std::optional<size_t> selected() const;
    void select(size_t index);

    void choose(size_t index) { chosen_ = entries_[index].file; }
    const std::filesystem::path& chosen() const { return chosen_; }

    /// Marks an attempt for comparison, or removes its mark. Returns true if another one of its lesson was marked: then
    /// pair() has both. A new mark replaces one of another lesson.
    bool mark(size_t index);
    bool marked(size_t index) const { return marked_ == index; }
    bool marks() const { return marked_.has_value(); }
    /// Pair, the older one first.
    const std::array<ReplayEntry, 2>& pair() const { return pair_; }

    // Each of these says in notice() what it did, or why it could not.
    /// Gives the attempt a name, or takes it away with an empty one.
    void rename(size_t index, std::string_view title);
    /// Moves the attempt to the folder of deleted ones.
    void remove(size_t index);
    /// Brings the last removed attempt back; no-op without one.
    void bringBack();
    bool canBringBack() const { return !removed_.first.empty(); }
    /// Writes the shown rows as a table into `folder`, which it creates. Returns the file; empty if it could not.
    std::filesystem::path exportRows(const std::filesystem::path& folder);
    const std::string& notice() const { return notice_; }

    /// Part of the list that waits for the person's answer.
    enum class Asking { nothing, title, removal };
    Asking asking = Asking::nothing;
    std::string typed;       ///< name so far, while `asking` is title
    bool fresh = false;      ///< true: its line has not been drawn yet
    bool opened = false;     ///< true: the list has not been drawn since it was opened
    bool choosing = false;   ///< true: the lessons to choose from are open
    bool rowFocused = false; ///< true: the keyboard is at a row
    size_t page = 0;         ///< page of the headset's list as last drawn

  private:
    void arrange(TitleOf titleOf);

    std::filesystem::path folder_;
    std::vector<ReplayEntry> entries_;
    std::vector<size_t> rows_;
    bool arranged_ = false; ///< false: rows_ are out of date
    AttemptFilter filter_;
    AttemptOrder order_;
    std::filesystem::path selected_;
    std::optional<size_t> marked_;
    std::array<ReplayEntry, 2> pair_;
    std::pair<std::filesystem::path, std::filesystem::path> removed_; ///< its place now, and before
    std::string fault_;
    std::string notice_;
    std::filesystem::path chosen_;
    bool shown_ = false;
};

/// Length of an attempt: "12.3 s", "2:05 min" from a minute on.
std::string lengthText(double seconds);

/// Recorded verdict ("accepted", "not accepted", "" for none), as text for the person.
std::string verdictText(const std::string& verdict);

/// Score of an attempt and its verdict, or that it does not count: "84, accepted", "84, practice", "not judged".
std::string scoreText(const ReplayEntry& entry);

} // namespace meltpool
