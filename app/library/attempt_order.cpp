#include "app/library/attempt_order.hpp"

#include "core/base/text.hpp"

#include <algorithm>
#include <string_view>

namespace meltpool {

namespace {

bool passes(const ReplayEntry& entry, const AttemptFilter& filter, const std::vector<std::string_view>& words) {
    if (filter.testsOnly && !entry.test) return false;
    if (!filter.lesson.empty() && entry.lesson != filter.lesson) return false;
    if (words.empty()) return true;
    const std::string text =
        lowerCase(entry.lessonTitle + "\n" + entry.lesson + "\n" + entry.title + "\n" + entry.when);
    return std::all_of(words.begin(), words.end(),
                       [&](std::string_view word) { return text.find(word) != std::string::npos; });
}

/// Negative if `a` comes before `b` in ascending order, 0 if the column does not tell them apart.
int compared(const ReplayEntry& a, const ReplayEntry& b, AttemptColumn column) {
    const auto sign = [](auto&& x, auto&& y) { return x < y ? -1 : y < x ? 1 : 0; };
    switch (column) {
    case AttemptColumn::lesson:
        return sign(lowerCase(a.lessonTitle), lowerCase(b.lessonTitle));
    case AttemptColumn::title:
        return sign(lowerCase(a.title), lowerCase(b.title));
    case AttemptColumn::length:
        return sign(a.seconds, b.seconds);
    case AttemptColumn::score:
        return sign(a.score.value_or(0), b.score.value_or(0));
    case AttemptColumn::test:
        return sign(a.test, b.test);
    case AttemptColumn::date: // the entries have this order already
        break;
    }
    return 0;
}

/// True if the column says nothing of the entry.
bool isBlank(const ReplayEntry& entry, AttemptColumn column) {
    return (column == AttemptColumn::score && !entry.score) || (column == AttemptColumn::title && entry.title.empty());
}

} // namespace

AttemptOrder pressedColumn(AttemptOrder order, AttemptColumn column) {
    if (order.column == column) return {column, !order.ascending};
    return {column, column == AttemptColumn::lesson || column == AttemptColumn::title};
}

std::vector<size_t> orderedAttempts(std::span<const ReplayEntry> entries, const AttemptFilter& filter,
                                    AttemptOrder order) {
    const std::string wanted = lowerCase(filter.text);
    std::vector<std::string_view> words = splitText(wanted, ' ');
    std::erase(words, std::string_view());
    std::vector<size_t> rows;
    for (size_t i = 0; i < entries.size(); ++i)
        if (passes(entries[i], filter, words)) rows.push_back(i);
    if (order.column == AttemptColumn::date) {
        if (order.ascending) std::reverse(rows.begin(), rows.end());
        return rows;
    }
    std::stable_sort(rows.begin(), rows.end(), [&](size_t a, size_t b) {
        const bool blankA = isBlank(entries[a], order.column), blankB = isBlank(entries[b], order.column);
        if (blankA || blankB) return !blankA && blankB;
        const int sign = compared(entries[a], entries[b], order.column);
        return order.ascending ? sign < 0 : sign > 0;
    });
    return rows;
}

} // namespace meltpool
