#include "app/library/replay_list.hpp"

#include "app/library/attempt_title.hpp"
#include "app/library/attempts_csv.hpp"
#include "app/library/deleted_attempts.hpp"
#include "app/library/kept_attempts.hpp"
#include "core/base/error.hpp"
#include "core/base/files.hpp"
#include "core/base/moment.hpp"
#include "core/base/output_file.hpp"
#include "core/base/text.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace meltpool {

namespace fs = std::filesystem;

namespace {

/// Details of an attempt: "2026-11-23 08:10 · Anna · 12.3 s · score 84, accepted · test".
std::string detailOf(const KeptAttempt& kept) {
    const std::string dot = " \xC2\xB7 ";
    std::string text =
        kept.when + (kept.person.empty() ? "" : dot + printable(kept.person, 200)) + dot + lengthText(kept.seconds);
    if (kept.score) text += dot + phrase("library.attempt.score", {{"score", std::to_string(*kept.score)}});
    if (!kept.verdict.empty()) text += (kept.score ? phrase("list.separator") : dot) + verdictText(kept.verdict);
    if (kept.test) text += dot + phrase("library.attempt.test");
    if (kept.practice) text += dot + phrase("library.attempt.practice");
    return kept.title.empty() ? text : text + dot + kept.title;
}

ReplayEntry entryOf(const KeptAttempt& kept) {
    ReplayEntry entry{kept.file, kept.lesson, detailOf(kept)};
    entry.title = kept.title;
    entry.when = kept.when;
    entry.seconds = kept.seconds;
    entry.score = kept.score;
    entry.verdict = kept.verdict;
    entry.practice = kept.practice;
    entry.test = kept.test;
    return entry;
}

/// Name of a table that no file has yet: "attempts 2026-11-23 08.10.csv".
fs::path tableName(const fs::path& folder) {
    std::string moment = isoDate(std::chrono::system_clock::to_time_t(momentNow()));
    std::replace(moment.begin(), moment.end(), ':', '.');
    std::replace(moment.begin(), moment.end(), 'T', ' ');
    const std::string stem = "attempts " + moment.substr(0, 16);
    fs::path file = folder / (stem + ".csv");
    std::error_code missing;
    for (int number = 2; fs::exists(fs::symlink_status(file, missing)); ++number)
        file = folder / (stem + " (" + std::to_string(number) + ").csv");
    return file;
}

} // namespace

std::string verdictText(const std::string& verdict) {
    if (verdict == "accepted") return phrase("library.attempt.accepted");
    return verdict == "not accepted" ? phrase("library.attempt.not_accepted") : verdict;
}

std::string scoreText(const ReplayEntry& entry) {
    std::string text = entry.score ? std::to_string(*entry.score) : std::string();
    const std::string why = entry.practice ? phrase("library.attempt.practice") : verdictText(entry.verdict);
    if (!why.empty()) text += (text.empty() ? "" : phrase("list.separator")) + why;
    return text.empty() ? phrase("attempts.not_judged") : text;
}

void ReplayList::show() {
    show(recordingsFolder());
}

void ReplayList::show(const fs::path& folder) {
    std::vector<std::string> faults;
    std::vector<ReplayEntry> entries;
    for (const KeptAttempt& kept : keptRecordings(folder, &faults))
        entries.push_back(entryOf(kept));
    show(std::move(entries));
    folder_ = folder;
    if (!faults.empty()) fault_ = faults.front();
    if (faults.size() < 2) return;
    const size_t more = faults.size() - 1;
    fault_ += " " + phraseOfCount("library.attempt.more_faults", static_cast<long long>(more),
                                  {{"count", std::to_string(more)}});
}

void ReplayList::show(std::vector<ReplayEntry> entries) {
    // An attempt made since is the one that the person comes to see.
    const bool newer = !entries_.empty() && !entries.empty() && entries.front().file != entries_.front().file;
    if (newer) selected_.clear();
    entries_ = std::move(entries);
    arranged_ = false;
    fault_.clear();
    notice_.clear();
    marked_.reset();
    asking = Asking::nothing;
    page = 0;
    opened = true;
    shown_ = true;
}

void ReplayList::hide() {
    shown_ = false;
    asking = Asking::nothing;
    removed_ = {};
}

void ReplayList::arrange(TitleOf titleOf) {
    if (arranged_) return;
    for (ReplayEntry& entry : entries_)
        entry.lessonTitle = titleOf(entry.lesson);
    rows_ = orderedAttempts(entries_, filter_, order_);
    arranged_ = true;
    const bool there = std::any_of(rows_.begin(), rows_.end(), [&](size_t i) { return entries_[i].file == selected_; });
    if (!there) selected_ = rows_.empty() ? fs::path() : entries_[rows_.front()].file;
}

const std::vector<size_t>& ReplayList::rows(TitleOf titleOf) {
    arrange(titleOf);
    return rows_;
}

void ReplayList::setFilter(AttemptFilter filter) {
    if (filter == filter_) return;
    filter_ = std::move(filter);
    arranged_ = false;
}

void ReplayList::press(AttemptColumn column) {
    order_ = pressedColumn(order_, column);
    arranged_ = false;
}

std::vector<std::pair<std::string, std::string>> ReplayList::lessons(TitleOf titleOf) {
    arrange(titleOf);
    std::vector<std::pair<std::string, std::string>> all;
    for (const ReplayEntry& entry : entries_)
        if (std::pair each{entry.lesson, entry.lessonTitle}; std::find(all.begin(), all.end(), each) == all.end())
            all.push_back(std::move(each));
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    return all;
}

std::optional<size_t> ReplayList::selected() const {
    for (size_t i = 0; i < entries_.size(); ++i)
        if (entries_[i].file == selected_) return i;
    return std::nullopt;
}

void ReplayList::select(size_t index) {
    if (entries_[index].file == selected_) return;
    selected_ = entries_[index].file;
    asking = Asking::nothing;
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

void ReplayList::rename(size_t index, std::string_view title) {
    ReplayEntry& entry = entries_[index];
    try {
        entry.title = writeTitle(entry.file, title);
        notice_.clear();
        arranged_ = false;
    } catch (const std::exception& fault) {
        notice_ = phrase("attempts.not_named", {{"reason", fault.what()}});
    }
}

void ReplayList::remove(size_t index) {
    const fs::path file = entries_[index].file;
    try {
        removed_ = {deleteAttempt(file), file};
    } catch (const std::exception& fault) {
        notice_ = phrase("attempts.not_deleted", {{"reason", fault.what()}});
        return;
    }
    notice_ = phrase("attempts.deleted", {{"file", removed_.first.string()}});
    const auto row = std::find(rows_.begin(), rows_.end(), index);
    if (row != rows_.end() && rows_.size() > 1) // the neighbour is next
        selected_ = entries_[row + 1 == rows_.end() ? row[-1] : row[1]].file;
    entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(index));
    marked_.reset();
    arranged_ = false;
}

void ReplayList::bringBack() {
    if (!canBringBack()) return;
    const auto [from, to] = removed_;
    try {
        bringBackAttempt(from, to);
    } catch (const std::exception& fault) {
        notice_ = phrase("attempts.not_brought_back", {{"reason", fault.what()}});
        return;
    }
    removed_ = {};
    selected_ = to;
    show(to.parent_path());
    notice_ = phrase("attempts.brought_back");
}

fs::path ReplayList::exportRows(const fs::path& folder) {
    try {
        std::error_code failure;
        fs::create_directories(folder, failure);
        const fs::path file = tableName(folder);
        std::vector<KeptAttempt> attempts;
        for (const size_t index : rows_)
            attempts.push_back(readKeptAttempt(entries_[index].file));
        writeFile(file, attemptsCsv(attempts));
        notice_ = phraseOfCount("attempts.exported", static_cast<long long>(attempts.size()),
                                {{"attempts", std::to_string(attempts.size())}, {"file", file.string()}});
        return file;
    } catch (const std::exception& fault) {
        notice_ = phrase("attempts.not_exported", {{"reason", fault.what()}});
        return {};
    }
}

std::string lengthText(double seconds) {
    if (seconds < 59.95) return std::string(PhraseNumber(seconds, 1)) + " s";
    const long whole = std::lround(seconds);
    return std::to_string(whole / 60) + (whole % 60 < 10 ? ":0" : ":") + std::to_string(whole % 60) + " min";
}

} // namespace meltpool
