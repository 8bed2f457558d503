// The attempts that were kept, as the home page lists them to be seen again.
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
    std::string detail; ///< when, how long, what score
};

class ReplayList {
  public:
    /// Reads which attempts there are. Files that are none though they are called so are told in fault().
    void show();
    void hide() { shown_ = false; }
    bool shown() const { return shown_; }

    /// The same with these, newest first.
    void show(std::vector<ReplayEntry> entries);

    /// Newest first.
    const std::vector<ReplayEntry>& entries() const { return entries_; }
    /// Why they are not all, as a sentence; empty while they are.
    const std::string& fault() const { return fault_; }

    void choose(size_t index) { chosen_ = entries_[index].file; }
    const std::filesystem::path& chosen() const { return chosen_; }

    /// Marks an attempt to be compared, or takes its mark away. True when another one of its lesson was marked: then
    /// pair() has both. A mark of another lesson is given up for the new one.
    bool mark(size_t index);
    bool marked(size_t index) const { return marked_ == index; }
    bool marks() const { return marked_.has_value(); }
    /// The older one first.
    const std::array<ReplayEntry, 2>& pair() const { return pair_; }
    size_t page = 0; ///< of the list as last drawn

  private:
    std::vector<ReplayEntry> entries_;
    std::optional<size_t> marked_;
    std::array<ReplayEntry, 2> pair_;
    std::string fault_;
    std::filesystem::path chosen_;
    bool shown_ = false;
};

/// "12.3 s": the length of an attempt, "2:05 min" from a minute on.
std::string lengthText(double seconds);

/// A recorded verdict ("accepted", "not accepted", "" for none), as the person reads it.
std::string verdictText(const std::string& verdict);

} // namespace meltpool
