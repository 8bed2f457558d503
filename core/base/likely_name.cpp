#include "core/base/likely_name.hpp"

#include "core/base/text.hpp"

#include <algorithm>
#include <utility>

namespace meltpool {

namespace {

constexpr std::size_t kLongestName = 60; ///< bytes; a longer text is no misspelled name

} // namespace

std::size_t editDistance(std::string_view a, std::string_view b) {
    // Three rows of the table: only an exchange of neighbours looks two rows back.
    std::vector<std::size_t> twoBack(b.size() + 1), oneBack(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
        row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::swap(twoBack, oneBack);
        std::swap(oneBack, row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t changed = oneBack[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({oneBack[j] + 1, row[j - 1] + 1, changed});
            const bool exchanged = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (exchanged) row[j] = std::min(row[j], twoBack[j - 2] + 1);
        }
    }
    return row[b.size()];
}

std::string likelyName(std::string_view given, std::span<const std::string> known) {
    if (given.empty() || given.size() > kLongestName) return {};
    const std::string wanted = lowerCase(given);
    std::size_t least = given.size() / 3 + 1;
    std::vector<std::string> nearest, longer;
    for (const std::string& name : known) {
        const std::string small = lowerCase(name);
        if (small.starts_with(wanted)) longer.push_back(name);
        const std::size_t distance = editDistance(wanted, small);
        if (distance > least || (distance == least && nearest.empty())) continue;
        if (distance < least) nearest.clear();
        least = distance;
        nearest.push_back(name);
    }
    if (nearest.size() == 1) return nearest.front();
    return longer.size() == 1 ? longer.front() : std::string();
}

std::string expectedNames(std::string_view given, std::span<const std::string> known, std::string_view introduction) {
    std::string list;
    for (const std::string& name : known)
        list += (list.empty() ? "" : ", ") + name;
    const std::string likely = likelyName(given, known);
    std::string text(introduction);
    if (!likely.empty() && !text.empty() && text[0] >= 'a' && text[0] <= 'z')
        text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return (likely.empty() ? "; " : "; did you mean " + quote(likely) + "? ") + text + list;
}

} // namespace meltpool
