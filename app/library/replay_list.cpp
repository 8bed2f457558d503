#include "app/library/replay_list.hpp"

#include "app/library/kept_attempts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace meltpool {

namespace {

/// "2026-11-23 08:10 · 12.3 s · score 84, accepted".
std::string detailOf(const KeptAttempt& kept) {
    const std::string dot = " \xC2\xB7 ";
    std::string text = kept.when + dot + lengthText(kept.seconds);
    if (kept.score) text += dot + "score " + std::to_string(*kept.score);
    if (!kept.verdict.empty()) text += (kept.score ? ", " : dot) + kept.verdict;
    return kept.practice ? text + dot + "practice" : text;
}

} // namespace

void ReplayList::show() {
    std::vector<std::string> faults;
    std::vector<ReplayEntry> entries;
    for (const KeptAttempt& kept : keptRecordings(recordingsFolder(), &faults))
        entries.push_back({kept.file, kept.lesson, detailOf(kept)});
    show(std::move(entries));
    if (!faults.empty()) fault_ = faults.front();
    if (faults.size() > 1) fault_ += " And " + std::to_string(faults.size() - 1) + " more files.";
}

void ReplayList::show(std::vector<ReplayEntry> entries) {
    entries_ = std::move(entries);
    fault_.clear();
    marked_.reset();
    page = 0;
    shown_ = true;
}

bool ReplayList::mark(size_t index) {
    if (marked_ == index) {
        marked_.reset();
        return false;
    }
    if (!marked_ || entries_[*marked_].lesson != entries_[index].lesson) {
        marked_ = index;
        return false;
    }
    pair_ = {entries_[std::max(*marked_, index)], entries_[std::min(*marked_, index)]};
    marked_.reset();
    return true;
}

std::string lengthText(double seconds) {
    char text[40];
    if (seconds < 59.95)
        std::snprintf(text, sizeof text, "%.1f s", seconds);
    else
        std::snprintf(text, sizeof text, "%d:%02d min", static_cast<int>(std::lround(seconds)) / 60,
                      static_cast<int>(std::lround(seconds)) % 60);
    return text;
}

} // namespace meltpool
