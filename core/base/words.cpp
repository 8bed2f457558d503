#include "core/base/words.hpp"

#include "core/base/environment.hpp"
#include "core/base/error.hpp"
#include "core/base/resources.hpp"
#include "core/base/text.hpp"
#include "core/base/toml_table.hpp"
#include "core/base/units.hpp"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cmath>
#include <memory>
#include <mutex>

namespace meltpool {

namespace {

constexpr std::string_view kEnglish = "en";

[[noreturn]] void failAt(const std::filesystem::path& file, const toml::node& node, const std::string& sentence) {
    throw InputError(file, static_cast<int>(node.source().begin.line), sentence);
}

bool hasWholePlaces(std::string_view sentence) {
    while (!sentence.empty()) {
        const detail::PhrasePiece piece = detail::nextPiece(sentence);
        const bool empty = piece.text.empty() && piece.unit.empty();
        if (empty || piece.text.find_first_of("{}") != std::string_view::npos) return false;
    }
    return true;
}

void collect(const toml::table& table, const std::string& before, const std::filesystem::path& file,
             std::map<std::string, std::string, std::less<>>& sentences) {
    for (const auto& [name, node] : table) {
        const std::string key = before + std::string(name.str());
        if (const toml::table* inner = node.as_table()) {
            collect(*inner, key + ".", file, sentences);
            continue;
        }
        const toml::value<std::string>* text = node.as_string();
        if (text == nullptr) failAt(file, node, key + ": expected a text in quotes");
        if (!hasWholePlaces(text->get()))
            failAt(file, node, key + ": expected each place in braces of its own, such as {speed}");
        sentences.emplace(key, text->get());
    }
}

std::filesystem::path wordsFolder() {
    return resourceFolder() / "data" / "words";
}

struct SpokenLanguage {
    explicit SpokenLanguage(std::string_view language) : name(language), words(wordsFolder(), language) {}

    std::string name;
    Words words;
};

/// All languages chosen in this run, so that their sentences stay valid.
struct SpokenLanguages {
    std::mutex mutex;
    std::vector<std::unique_ptr<const SpokenLanguage>> read;
    std::atomic<const SpokenLanguage*> english = nullptr, chosen = nullptr;

    const SpokenLanguage* readOnce(std::string_view language) {
        for (const auto& each : read)
            if (each->name == language) return each.get();
        read.push_back(std::make_unique<const SpokenLanguage>(language));
        return read.back().get();
    }
};

SpokenLanguages& spoken() {
    // Never destroyed: a search for a headset may still ask for a sentence while the program ends.
    static SpokenLanguages& languages = *new SpokenLanguages;
    return languages;
}

const Words& english() {
    SpokenLanguages& languages = spoken();
    if (const SpokenLanguage* read = languages.english.load(std::memory_order_acquire)) return read->words;
    const std::scoped_lock lock(languages.mutex);
    const SpokenLanguage* const read = languages.readOnce(kEnglish);
    languages.english.store(read, std::memory_order_release);
    return read->words;
}

const Words& chosen() {
    const SpokenLanguage* const chosen = spoken().chosen.load(std::memory_order_acquire);
    return chosen != nullptr ? chosen->words : english();
}

/// A key that no file has, stored so that it can be shown.
const std::string& missing(std::string_view key) {
    static std::mutex mutex;
    static std::map<std::string, std::string, std::less<>> keys;
    const std::scoped_lock lock(mutex);
    const auto found = keys.find(key);
    return found != keys.end() ? found->second : keys.emplace(key, key).first->second;
}

} // namespace

Words::Words(const std::filesystem::path& folder, std::string_view language) {
    const std::filesystem::path file = folder / (std::string(language) + ".toml");
    collect(parseTomlFile(file), {}, file, sentences_);
    if (const std::string* mark = find("language.decimal_mark")) decimalMark_ = *mark;
}

const std::string* Words::find(std::string_view key) const {
    const auto found = sentences_.find(key);
    return found == sentences_.end() ? nullptr : &found->second;
}

std::string Words::withDecimalMark(std::string_view number) const {
    std::string text(number);
    if (const std::size_t point = text.find('.'); point != std::string::npos) text.replace(point, 1, decimalMark_);
    return text;
}

std::vector<std::string_view> placesOf(std::string_view sentence) {
    std::vector<std::string_view> names;
    while (!sentence.empty())
        if (const detail::PhrasePiece piece = detail::nextPiece(sentence);
            piece.isPlace && !piece.text.empty() && !piece.isFixed)
            names.push_back(piece.text);
    return names;
}

std::vector<std::string> languages() {
    return tomlFileNames(wordsFolder(), "the folder with a file of sentences for each language");
}

std::string languageName(std::string_view language) {
    try {
        const Words words(wordsFolder(), language);
        if (const std::string* name = words.find("language.name")) return *name;
    } catch (const InputError&) {
        // chooseLanguage() reports the fault
    }
    return std::string(language);
}

void chooseLanguage(std::string_view language) {
    const std::vector<std::string> known = languages();
    if (std::find(known.begin(), known.end(), language) == known.end()) {
        std::string list;
        for (const std::string& each : known)
            list += (list.empty() ? "" : ", ") + each;
        throw InputError(wordsFolder(), 0,
                         "there is no file for the language " + quote(language) + "; expected one of: " + list);
    }
    SpokenLanguages& all = spoken();
    const std::scoped_lock lock(all.mutex);
    all.chosen.store(all.readOnce(language), std::memory_order_release);
}

std::string usersLanguage() {
    if (std::string asked = environmentVariable("MELTPOOL_LANGUAGE"); !asked.empty()) return asked;
    const std::vector<std::string> known = languages();
    for (std::string& each : preferredLanguages())
        if (std::find(known.begin(), known.end(), each) != known.end()) return std::move(each);
    return std::string(kEnglish);
}

void chooseUsersLanguage() {
    try {
        languages();
    } catch (const InputError&) {
        return; // code that needs the program's own files reports that they are missing
    }
    chooseLanguage(usersLanguage());
}

std::string_view language() {
    const SpokenLanguage* const chosen = spoken().chosen.load(std::memory_order_acquire);
    return chosen != nullptr ? std::string_view(chosen->name) : kEnglish;
}

const std::string& phrase(std::string_view key) {
    const std::string* text = findPhrase(key);
    return text != nullptr ? *text : missing(key);
}

const std::string* findPhrase(std::string_view key) {
    const std::string* text = chosen().find(key);
    return text != nullptr ? text : english().find(key);
}

std::string phrase(std::string_view key, PhrasePlaces places) {
    std::string text;
    appendPhrase(text, key, places);
    return text;
}

std::string inChosenUnits(std::string_view sentence) {
    std::string text;
    detail::appendFilled(text, sentence, {});
    return text;
}

std::string phraseOfCount(std::string_view key, long long count, PhrasePlaces places) {
    return phrase(std::string(key) + (count == 1 ? ".one" : ".other"), places);
}

std::string_view phraseOr(std::string_view key, std::string_view english) {
    const std::string* text = chosen().find(key);
    return text != nullptr ? std::string_view(*text) : english;
}

const std::string& phraseOf(std::string_view group, std::string_view name) {
    return phrase(ShortText{group, ".", name});
}

PhraseNumber::PhraseNumber(double value, int digits, bool sign) {
    if (!std::isfinite(value)) {
        text_[length_++] = '?';
        return;
    }
    const double shown = std::clamp(value, -1e15, 1e15);
    if (sign && shown > 0) text_[length_++] = '+';
    char* const end = text_.data() + text_.size();
    char* const from = text_.data() + length_;
    const auto written = std::to_chars(from, end, shown, std::chars_format::fixed, std::clamp(digits, 0, 9));
    length_ = static_cast<std::size_t>(written.ptr - text_.data());
    if (std::string_view(from, written.ptr).find_first_of("123456789") == std::string_view::npos) leaveZeroPlain();
    const std::string_view mark = chosen().decimalMark();
    if (mark.size() == 1) std::replace(text_.data(), text_.data() + length_, '.', mark[0]);
}

std::string_view decimalMark() {
    return chosen().decimalMark();
}

std::string withDecimalMark(std::string_view number) {
    return chosen().withDecimalMark(number);
}

void PhraseNumber::leaveZeroPlain() {
    if (text_[0] != '-' && text_[0] != '+') return;
    std::copy(text_.begin() + 1, text_.begin() + static_cast<std::ptrdiff_t>(length_), text_.begin());
    --length_;
}

namespace detail {

PhrasePiece nextPiece(std::string_view& rest) {
    const std::size_t open = rest.find('{');
    const std::size_t close = open == 0 ? rest.find('}') : std::string_view::npos;
    if (close != std::string_view::npos) {
        const std::string_view written = rest.substr(0, close + 1), inside = rest.substr(1, close - 1);
        const bool fixed = !inside.empty() && inside.front() >= '0' && inside.front() <= '9';
        const std::size_t cut = std::min(inside.find(fixed ? ' ' : ':'), inside.size());
        const std::string_view unit = cut < inside.size() ? inside.substr(cut + 1) : std::string_view();
        rest.remove_prefix(close + 1);
        return {inside.substr(0, cut), true, unit, fixed && !unit.empty(), written};
    }
    const PhrasePiece piece{rest.substr(0, open == 0 ? rest.size() : open), false};
    rest.remove_prefix(piece.text.size());
    return piece;
}

FilledPlace fillPlace(const PhrasePiece& piece, PhrasePlaces places) {
    const auto find = [&](std::string_view name) -> const PhrasePlace* {
        for (const PhrasePlace& place : places)
            if (place.name == name) return &place;
        return nullptr;
    };
    const PhrasePlace* const named = find(piece.unit);
    const std::string_view unit = named != nullptr ? named->text : piece.unit;
    if (piece.text.empty()) return {true, shownUnit(unit).name, {}, false};
    if (piece.isFixed) {
        ShortText length = inShownUnit(piece.text, unit);
        length += " ";
        length += shownUnit(unit).name;
        return {true, {}, length, true};
    }
    const PhrasePlace* const found = find(piece.text);
    if (found == nullptr) return {};
    if (unit.empty() || !shownUnit(unit).converts()) return {true, found->text, {}, false};
    return {true, {}, inShownUnit(found->text, unit), true};
}

} // namespace detail

} // namespace meltpool
