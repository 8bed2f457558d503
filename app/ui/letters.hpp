// The letters that the interface draws, and which of a text's letters no font on this machine has.
#pragma once

#include "app/ui/imgui_headers.hpp"

#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace meltpool::ui {

/// Pairs of first and last letter, ended by 0: Latin with Romanian, Turkish and Vietnamese, Greek, Cyrillic, currencies
/// and the signs that technical texts use.
const ImWchar* textLetters();
/// The same for large titles, which need few: Latin and its punctuation.
const ImWchar* titleLetters();

struct DecodedLetter {
    char32_t letter = 0xFFFD;
    size_t bytes = 1;
};
/// The first letter of `text` (UTF-8), which is not empty; U+FFFD for a byte that is none.
DecodedLetter decodeLetter(std::string_view text);

/// Gathers the letters that a font has not, each once in the life of this object.
class MissingLetters {
  public:
    /// Looks through `text` (UTF-8). Allocates nothing where `font` has all of it.
    void look(ImFont& font, std::string_view text);

    struct Sentences {
        std::string terminal; ///< with the letters themselves
        std::string window;   ///< which cannot draw them: with their numbers in Unicode
    };
    /// About the letters found since the last call; nothing where there are none.
    std::optional<Sentences> take();

  private:
    std::set<char32_t> told_;
    std::string letters_; ///< not told yet, with spaces between
    std::string numbers_; ///< of the first of them
    size_t count_ = 0;
};

} // namespace meltpool::ui
