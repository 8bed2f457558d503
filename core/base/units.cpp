#include "core/base/units.hpp"

#include "core/base/words.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>

namespace meltpool {

namespace {

constexpr double kInch = 25.4; // mm, by definition

struct Conversion {
    std::string_view metric;
    ShownUnit inches;
};

/// Digits so that a length keeps about its fineness: 0.1 mm is 0.004 in.
constexpr std::array<Conversion, 6> kConversions{{{"mm", {"in", 1 / kInch, 2, 3}},
                                                  {"mm2", {"in\xC2\xB2", 1 / (kInch * kInch), 3, 4}},
                                                  {"mm\xC2\xB2", {"in\xC2\xB2", 1 / (kInch * kInch), 3, 4}},
                                                  {"mm/s", {"in/min", 60 / kInch, 0, 1}},
                                                  {"m/min", {"in/min", 1000 / kInch, -1, 0}},
                                                  {"kJ/mm", {"kJ/in", kInch, -1, 1}}}};

std::atomic<UnitSystem> chosen = UnitSystem::metric;

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

/// A number's beginning in a text: its digits, with one mark between digits.
struct FoundNumber {
    size_t length = 0;
    int decimals = 0;
    double value = 0;
};

FoundNumber numberAt(std::string_view text) {
    FoundNumber found;
    std::array<char, 32> plain{};
    bool marked = false;
    for (; found.length < std::min(text.size(), plain.size()); ++found.length) {
        const char c = text[found.length];
        const bool mark = !marked && found.length > 0 && (c == '.' || c == ',') && found.length + 1 < text.size() &&
                          isDigit(text[found.length + 1]);
        if (!isDigit(c) && !mark) break;
        if (marked) ++found.decimals;
        marked = marked || mark;
        plain[found.length] = mark ? '.' : c;
    }
    std::from_chars(plain.data(), plain.data() + found.length, found.value);
    return found;
}

} // namespace

void chooseUnits(UnitSystem system) {
    chosen.store(system, std::memory_order_relaxed);
}

UnitSystem chosenUnits() {
    return chosen.load(std::memory_order_relaxed);
}

ShownUnit inchUnit(std::string_view metric) {
    for (const Conversion& each : kConversions)
        if (each.metric == metric) return each.inches;
    return {metric};
}

ShownUnit shownUnit(std::string_view metric) {
    return chosenUnits() == UnitSystem::inches ? inchUnit(metric) : ShownUnit{metric};
}

ShortText inShownUnit(std::string_view numbers, std::string_view metric) {
    const ShownUnit unit = shownUnit(metric);
    if (!unit.converts()) return numbers;
    ShortText text;
    while (!numbers.empty()) {
        if (!isDigit(numbers.front())) {
            text += numbers.substr(0, 1);
            numbers.remove_prefix(1);
            continue;
        }
        const FoundNumber found = numberAt(numbers);
        text +=
            PhraseNumber(found.value * unit.perMetric, std::clamp(found.decimals + unit.digits, 0, unit.mostDigits));
        numbers.remove_prefix(found.length);
    }
    return text;
}

} // namespace meltpool
