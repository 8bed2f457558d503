// Sentences for the user: each is written whole, under a key, in data/words/LANGUAGE.toml.
#pragma once

#include "core/base/short_text.hpp"

#include <array>
#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

/// A named place in a sentence and the text that fills it. Refers to the caller's text.
struct PhrasePlace {
    std::string_view name; ///< "speed" fills {speed}
    std::string_view text;
};
using PhrasePlaces = std::initializer_list<PhrasePlace>;

/// The sentences of one language.
class Words {
  public:
    /// Reads FOLDER/LANGUAGE.toml. Points join keys of nested tables: [result] again = "Again" is "result.again".
    /// Throws InputError for a file that cannot be read, a value that is no text, and a sentence with an unmatched
    /// brace.
    Words(const std::filesystem::path& folder, std::string_view language);

    /// The sentence of a key; null if the file lacks it.
    const std::string* find(std::string_view key) const;
    const std::map<std::string, std::string, std::less<>>& sentences() const { return sentences_; }

    /// The decimal mark, `language.decimal_mark` of the file; a point if it names none.
    std::string_view decimalMark() const { return decimalMark_; }
    /// See meltpool::withDecimalMark().
    std::string withDecimalMark(std::string_view number) const;

  private:
    std::map<std::string, std::string, std::less<>> sentences_;
    std::string decimalMark_ = ".";
};

/// Names of the places in a sentence, in order: "{mean} of {asked:mm} {:mm}" has "mean" and "asked".
std::vector<std::string_view> placesOf(std::string_view sentence);

/// The languages that have a file: "en", "de".
std::vector<std::string> languages();
/// The language's name in itself, `language.name` of its file: "Deutsch"; its key for a file that has no name or cannot
/// be read.
std::string languageName(std::string_view language);

/// Sets the language of all sentences from now on, such as "de". English fills gaps in its file. Earlier sentences stay
/// valid. Throws InputError for a language without a file, listing those that have one.
void chooseLanguage(std::string_view language);
/// $MELTPOOL_LANGUAGE if it is set, else the first of the user's languages that has a file, else English.
std::string usersLanguage();
/// Chooses usersLanguage(). Throws as chooseLanguage().
void chooseUsersLanguage();
/// The chosen language; "en" before the first choice. Stays valid. Safe on any thread.
std::string_view language();

/// The sentence of a key without places. A key that no file has is its own sentence, so that the gap is visible. Safe
/// on any thread. Throws InputError on the first call if data/words/en.toml cannot be read.
const std::string& phrase(std::string_view key);
/// The sentence of a key, or null if no file has it: for words that exist only in some cases.
const std::string* findPhrase(std::string_view key);
/// The sentence with its places filled. A place that is not given stays as it is written.
///
/// Lengths are given in millimetres and shown in the chosen units (core/base/units.hpp): {length:mm} is the number of
/// the place `length`, {:mm} the unit's name. In the place of a unit there may be another place that names it:
/// "{value:unit}
/// {:unit}". {3 mm} is a fixed length with its unit.
std::string phrase(std::string_view key, PhrasePlaces places);
/// A sentence of a file, such as a lesson's text, with its lengths in the chosen units: see phrase().
std::string inChosenUnits(std::string_view sentence);
/// Calls phrase() with KEY.one for a count of 1, else with KEY.other.
std::string phraseOfCount(std::string_view key, long long count, PhrasePlaces places = {});
/// The sentence, or `english` if the chosen language's file has none: for texts in the program's own tables.
std::string_view phraseOr(std::string_view key, std::string_view english);
/// The sentence of GROUP.NAME.
const std::string& phraseOf(std::string_view group, std::string_view name);

/// Appends the filled sentence to a text with +=; allocates no more than `text` does.
template <typename Text>
void appendPhrase(Text& text, std::string_view key, PhrasePlaces places);

/// A number in a sentence, with the language's decimal mark. Allocates nothing.
class PhraseNumber {
  public:
    /// `digits`: fixed number of digits behind the mark; `sign`: a plus before numbers above 0.
    explicit PhraseNumber(double value, int digits = 0, bool sign = false);
    operator std::string_view() const { return {text_.data(), length_}; }

  private:
    void leaveZeroPlain(); ///< removes the sign of a number that is shown as 0

    std::array<char, 48> text_{};
    std::size_t length_ = 0;
};

/// A number that formatNumber() or printf wrote with a point, with the language's decimal mark instead: for readers.
/// Files and fields that are parsed again use the point.
std::string withDecimalMark(std::string_view number);
/// The chosen language's decimal mark.
std::string_view decimalMark();

namespace detail {
/// A piece of a sentence: literal text, or the name of a place.
struct PhrasePiece {
    std::string_view text; ///< {length:mm}: "length"
    bool isPlace = false;
    std::string_view unit = {};    ///< {length:mm}: "mm"
    bool isFixed = false;          ///< {3 mm}: text "3", unit "mm"
    std::string_view written = {}; ///< with its braces
};
/// Removes and returns the first piece of the rest of a sentence.
PhrasePiece nextPiece(std::string_view& rest);
/// The text for a place: a number in the chosen units, a unit's name, or the place's text itself. Empty pointer for a
/// place that is not given.
struct FilledPlace {
    bool given = false;
    std::string_view plain; ///< the text, unless it is `converted`
    ShortText converted;
    bool isConverted = false;
};
FilledPlace fillPlace(const PhrasePiece& piece, PhrasePlaces places);

/// Appends a sentence with its places filled.
template <typename Text>
void appendFilled(Text& text, std::string_view rest, PhrasePlaces places) {
    while (!rest.empty()) {
        const PhrasePiece piece = nextPiece(rest);
        if (!piece.isPlace) {
            text += piece.text;
            continue;
        }
        const FilledPlace filled = fillPlace(piece, places);
        if (filled.given) {
            text += filled.isConverted ? std::string_view(filled.converted) : filled.plain;
            continue;
        }
        text += piece.written;
    }
}
} // namespace detail

template <typename Text>
void appendPhrase(Text& text, std::string_view key, PhrasePlaces places) {
    detail::appendFilled(text, phrase(key), places);
}

} // namespace meltpool
