// Sentences that a person reads: each stands whole, under a key, in data/words/LANGUAGE.toml.
#pragma once

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

/// A named place of a sentence and the text that fills it. Refers to the text of the caller.
struct PhrasePlace {
    std::string_view name; ///< "speed" fills {speed}
    std::string_view text;
};
using PhrasePlaces = std::initializer_list<PhrasePlace>;

/// The sentences of one language.
class Words {
  public:
    /// Reads FOLDER/LANGUAGE.toml. Keys of nested tables are joined by points: [result] again = "Again" is
    /// "result.again". Throws InputError for a file that cannot be read, a value that is no text, and a sentence with a
    /// brace that has no partner.
    Words(const std::filesystem::path& folder, std::string_view language);

    /// The sentence of a key; null for one that the file lacks.
    const std::string* find(std::string_view key) const;
    const std::map<std::string, std::string, std::less<>>& sentences() const { return sentences_; }

    /// The mark before the decimals, `language.decimal_mark` of the file; a point where it names none.
    std::string_view decimalMark() const { return decimalMark_; }
    /// See meltpool::withDecimalMark().
    std::string withDecimalMark(std::string_view number) const;

  private:
    std::map<std::string, std::string, std::less<>> sentences_;
    std::string decimalMark_ = ".";
};

/// Names of the places of a sentence, in their order: "{mean} of {asked}" has "mean" and "asked".
std::vector<std::string_view> placesOf(std::string_view sentence);

/// The languages that have a file: "en", "de".
std::vector<std::string> languages();

/// The language of all sentences from now on, such as "de". English answers for what its file lacks. Sentences that
/// were asked for before stay valid. Throws InputError for a language without a file, listing those that have one.
void chooseLanguage(std::string_view language);
/// Chooses $MELTPOOL_LANGUAGE where it is set, else the first of the person's languages that has a file, else English.
/// Throws as chooseLanguage().
void chooseUsersLanguage();
/// The chosen language; "en" before the first choice.
std::string_view language();

/// The sentence of a key without places. A key that no file has answers for itself, so that a person sees which.
/// Any thread may ask. Throws InputError at the first question when data/words/en.toml cannot be read.
const std::string& phrase(std::string_view key);
/// The same; null for a key that no file has: for what has words only in some cases.
const std::string* findPhrase(std::string_view key);
/// The sentence with its places filled. A place that is not given stays as it is written.
std::string phrase(std::string_view key, PhrasePlaces places);
/// As phrase() of KEY.one for a count of 1, else of KEY.other.
std::string phraseOfCount(std::string_view key, long long count, PhrasePlaces places = {});
/// The sentence, or `english` where the chosen language's file has none: for texts that stand in the program's tables.
std::string_view phraseOr(std::string_view key, std::string_view english);
/// The sentence of GROUP.NAME.
const std::string& phraseOf(std::string_view group, std::string_view name);

/// Appends the filled sentence to what takes pieces of text by +=; allocates no more than `text` does.
template <typename Text>
void appendPhrase(Text& text, std::string_view key, PhrasePlaces places);

/// A number of a sentence, with the language's decimal mark. Allocates nothing.
class PhraseNumber {
  public:
    /// `digits` behind the mark, always; `sign`: a plus before numbers above 0.
    explicit PhraseNumber(double value, int digits = 0, bool sign = false);
    operator std::string_view() const { return {text_.data(), length_}; }

  private:
    void leaveZeroPlain(); ///< no sign before a number that is shown as 0

    std::array<char, 48> text_{};
    std::size_t length_ = 0;
};

/// A number that formatNumber() or printf wrote with a point, with the language's decimal mark instead: where people
/// read it. Files and fields that are parsed again keep the point.
std::string withDecimalMark(std::string_view number);
/// The chosen language's mark before the decimals.
std::string_view decimalMark();

namespace detail {
/// A piece of a sentence: text as it stands, or the name of a place.
struct PhrasePiece {
    std::string_view text;
    bool isPlace = false;
};
/// Takes the first piece off the rest of a sentence.
PhrasePiece nextPiece(std::string_view& rest);
} // namespace detail

template <typename Text>
void appendPhrase(Text& text, std::string_view key, PhrasePlaces places) {
    std::string_view rest = phrase(key);
    while (!rest.empty()) {
        const detail::PhrasePiece piece = detail::nextPiece(rest);
        if (!piece.isPlace) {
            text += piece.text;
            continue;
        }
        const PhrasePlace* found = nullptr;
        for (const PhrasePlace& place : places)
            if (place.name == piece.text) found = &place;
        if (found != nullptr) {
            text += found->text;
            continue;
        }
        text += std::string_view("{");
        text += piece.text;
        text += std::string_view("}");
    }
}

} // namespace meltpool
