// Lists the letters that the interface draws, and finds those of a text that no font on this machine has.
#pragma once

#include "app/ui/imgui_headers.hpp"

#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace meltpool::ui {

/// Returns pairs of first and last letter, ended by 0: Latin with Romanian, Turkish and Vietnamese, Greek, Cyrillic,
/// currencies and the signs of technical texts.
const ImWchar* textLetters();
/// Returns the pairs for large titles, which need few: Latin and its punctuation.
const ImWchar* titleLetters();

struct DecodedLetter {
    char32_t letter = 0xFFFD;
    size_t bytes = 1;
};
/// Returns the first letter of `text` (UTF-8), which is not empty; U+FFFD for an invalid byte.
DecodedLetter decodeLetter(std::string_view text);

/// Collects the letters missing in a font, each once in the life of this object.
class MissingLetters {
  public:
    /// Looks through `text` (UTF-8). Allocates nothing if `font` has all of it.
    void look(ImFont& font, std::string_view text);

    struct Sentences {
        std::string terminal; ///< sentence with the letters themselves
        std::string window;   ///< sentence with their numbers in Unicode: the window cannot draw them
    };
    /// Returns sentences about the letters found since the last call; empty if there are none.
    std::optional<Sentences> take();

  private:
    std::set<char32_t> told_;
    std::string letters_; ///< unreported letters, with spaces between
    std::string numbers_; ///< numbers of the first of them
    size_t count_ = 0;
};

} // namespace meltpool::ui
