// The stored attempts in the home page's list, for replay and comparison.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace meltpool {

struct ReplayEntry {
    std::filesystem::path file;
    std::string lesson; ///< key
    std::string detail; ///< date, person, duration and score
};

class ReplayList {
  public:
    /// Shows the list and reads the attempts. Files that have a recording's name and are none are reported in fault().
    void show();
    void hide() { shown_ = false; }
    bool shown() const { return shown_; }

    /// Shows the list with these, newest first.
    void show(std::vector<ReplayEntry> entries);

    /// Entries, newest first.
    const std::vector<ReplayEntry>& entries() const { return entries_; }
    /// Sentence that says why entries are missing; empty if all are there.
    const std::string& fault() const { return fault_; }

    void choose(size_t index) { chosen_ = entries_[index].file; }
    const std::filesystem::path& chosen() const { return chosen_; }

    /// Marks an attempt for comparison, or removes its mark. Returns true if another one of its lesson was marked: then
    /// pair() has both. A new mark replaces one of another lesson.
    bool mark(size_t index);
    bool marked(size_t index) const { return marked_ == index; }
    bool marks() const { return marked_.has_value(); }
    /// Pair, the older one first.
    const std::array<ReplayEntry, 2>& pair() const { return pair_; }
    size_t page = 0; ///< page of the list as last drawn

  private:
    std::vector<ReplayEntry> entries_;
    std::optional<size_t> marked_;
    std::array<ReplayEntry, 2> pair_;
    std::string fault_;
    std::filesystem::path chosen_;
    bool shown_ = false;
};

/// Length of an attempt: "12.3 s", "2:05 min" from a minute on.
std::string lengthText(double seconds);

/// Recorded verdict ("accepted", "not accepted", "" for none), as text for the person.
std::string verdictText(const std::string& verdict);

} // namespace meltpool
