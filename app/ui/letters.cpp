#include "app/ui/letters.hpp"

#include "core/base/words.hpp"

#include <array>
#include <cstdio>

namespace meltpool::ui {

namespace {

constexpr auto kTextLetters = std::to_array<ImWchar>({
    0x0020, 0x024F, // Latin
    0x02B0, 0x02DD, // modifiers
    0x0300, 0x036F, // accents that follow their letter
    0x0370, 0x03FF, // Greek
    0x0400, 0x052F, // Cyrillic
    0x1E00, 0x1EFF, // Latin with two accents: Vietnamese
    0x2010, 0x205E, // punctuation
    0x2070, 0x209F, // raised and lowered figures
    0x20A0, 0x20BF, // currencies
    0x2100, 0x2127, // letter-like signs
    0x2150, 0x215E, // fractions
    0x2190, 0x2199, // arrows
    0x21D0, 0x21D5, // double arrows
    0x2200, 0x22C5, // mathematics
    0x2300, 0x2307, // diameter and other technical signs
    0x25A0, 0x25CF, // squares, triangles, circles
    0x2605, 0x2612, // stars and boxes
    0x2713, 0x2718, // ticks and crosses
    0xFFFD, 0xFFFD, // replacement of a missing letter
    0,
});

constexpr auto kTitleLetters =
    std::to_array<ImWchar>({0x0020, 0x024F, 0x1E00, 0x1EFF, 0x2010, 0x2044, 0xFFFD, 0xFFFD, 0});

/// Returns true for a letter that draws nothing.
bool drawsNothing(char32_t letter) {
    return letter < 0x20 || (letter >= 0x7F && letter < 0xA0) || (letter >= 0x200B && letter <= 0x200F) ||
           (letter >= 0x2028 && letter <= 0x202F) || letter == 0xFEFF;
}

bool has(ImFont& font, char32_t letter) {
    if (letter > static_cast<ImWchar>(-1)) return false;
#if IMGUI_VERSION_NUM >= 19200
    return font.IsGlyphInFont(static_cast<ImWchar>(letter));
#else
    return font.FindGlyphNoFallback(static_cast<ImWchar>(letter)) != nullptr;
#endif
}

} // namespace

const ImWchar* textLetters() {
    return kTextLetters.data();
}

const ImWchar* titleLetters() {
    return kTitleLetters.data();
}

DecodedLetter decodeLetter(std::string_view text) {
    const auto byte = [&](size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    if (first < 0x80) return {first, 1};
    const size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    if (first < 0xC2 || first > 0xF4 || text.size() < length) return {};
    char32_t letter = first & (0xFFu >> (length + 1));
    for (size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0) != 0x80) return {};
        letter = letter << 6 | (byte(i) & 0x3Fu);
    }
    return {letter, length};
}

void MissingLetters::look(ImFont& font, std::string_view text) {
    constexpr size_t kMostNumbers = 6;
    while (!text.empty()) {
        const auto [letter, bytes] = decodeLetter(text);
        if (letter >= 0x80 && !drawsNothing(letter) && !has(font, letter) && told_.insert(letter).second) {
            letters_ += ' ';
            letters_ += text.substr(0, bytes);
            char number[16];
            std::snprintf(number, sizeof number, " U+%04X", static_cast<unsigned>(letter));
            if (++count_ <= kMostNumbers) numbers_ += number;
            if (count_ == kMostNumbers + 1) numbers_ += " ..";
        }
        text.remove_prefix(bytes);
    }
}

std::optional<MissingLetters::Sentences> MissingLetters::take() {
    if (count_ == 0) return std::nullopt;
    const Sentences both{
        phrase("letters.missing", {{"letters", std::string_view(letters_).substr(1)}}),
        phraseOfCount("letters.missing_here", count_,
                      {{"count", std::to_string(count_)}, {"numbers", std::string_view(numbers_).substr(1)}})};
    letters_.clear();
    numbers_.clear();
    count_ = 0;
    return both;
}

} // namespace meltpool::ui
