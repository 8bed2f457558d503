#include "app/library/replay_list.hpp"

#include "app/library/kept_attempts.hpp"
#include "core/base/text.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace meltpool {

namespace {

/// Details of an attempt: "2026-11-23 08:10 · Anna · 12.3 s · score 84, accepted".
std::string detailOf(const KeptAttempt& kept) {
    const std::string dot = " \xC2\xB7 ";
    std::string text =
        kept.when + (kept.person.empty() ? "" : dot + printable(kept.person, 200)) + dot + lengthText(kept.seconds);
    if (kept.score) text += dot + phrase("library.attempt.score", {{"score", std::to_string(*kept.score)}});
    if (!kept.verdict.empty()) text += (kept.score ? phrase("list.separator") : dot) + verdictText(kept.verdict);
    return kept.practice ? text + dot + phrase("library.attempt.practice") : text;
}

} // namespace

std::string verdictText(const std::string& verdict) {
    if (verdict == "accepted") return phrase("library.attempt.accepted");
    return verdict == "not accepted" ? phrase("library.attempt.not_accepted") : verdict;
}

void ReplayList::show() {
    std::vector<std::string> faults;
    std::vector<ReplayEntry> entries;
    for (const KeptAttempt& kept : keptRecordings(recordingsFolder(), &faults))
        entries.push_back({kept.file, kept.lesson, detailOf(kept)});
    show(std::move(entries));
    if (!faults.empty()) fault_ = faults.front();
    if (faults.size() < 2) return;
    const size_t more = faults.size() - 1;
    fault_ += " " + phraseOfCount("library.attempt.more_faults", static_cast<long long>(more),
                                  {{"count", std::to_string(more)}});
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
    if (seconds < 59.95) return std::string(PhraseNumber(seconds, 1)) + " s";
    const long whole = std::lround(seconds);
    return std::to_string(whole / 60) + (whole % 60 < 10 ? ":0" : ":") + std::to_string(whole % 60) + " min";
}

} // namespace meltpool
