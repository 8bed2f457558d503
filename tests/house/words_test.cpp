// Keys of sentences: the English file has exactly those that the program uses, and other languages have equal keys and
// places.
#include "core/base/words.hpp"
#include "tests/house/source_scan.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/places.hpp"

#include <algorithm>
#include <map>
#include <regex>
#include <set>

namespace meltpool {

namespace {

std::filesystem::path wordsFolder() {
    return test::sourceFolder() / "app" / "data" / "words";
}

const Words& english() {
    static const Words words(wordsFolder(), "en");
    return words;
}

/// Returns the string literals of the program's sources, each with the first file that contains it.
const std::map<std::string, std::string>& literals() {
    static const std::map<std::string, std::string> found = [] {
        static const std::regex literal(R"re("((?:[^"\\\n]|\\.)*)")re");
        std::map<std::string, std::string> all;
        for (const test::SourceFile& file :
             test::readSources(test::sourceFolder(), {"core", "xr", "app"}, {".cpp", ".hpp"}))
            for (std::sregex_iterator each(file.text.begin(), file.text.end(), literal), end; each != end; ++each)
                all.emplace((*each)[1].str(), file.path.generic_string());
        return all;
    }();
    return found;
}

/// Returns keys used by name, with the file: phrase("KEY"), appendPhrase(text, "KEY") and counted ones.
std::map<std::string, std::string> askedKeys() {
    static const std::regex asked(
        R"re(\b(phrase|phraseOfCount|findPhrase|appendPhrase)\(\s*(?:[\w.\->\[\]]+\s*,\s*)?"([a-z0-9_.]+)")re");
    std::map<std::string, std::string> keys;
    for (const test::SourceFile& file :
         test::readSources(test::sourceFolder(), {"core", "xr", "app"}, {".cpp", ".hpp"}))
        for (std::sregex_iterator each(file.text.begin(), file.text.end(), asked), end; each != end; ++each) {
            const std::string key = (*each)[2];
            if (key.back() == '.') continue; // a key's stem before a name
            if ((*each)[1] == "phraseOfCount") {
                keys.emplace(key + ".one", file.path.generic_string());
                keys.emplace(key + ".other", file.path.generic_string());
            } else {
                keys.emplace(key, file.path.generic_string());
            }
        }
    return keys;
}

/// True if some literal is this key or its beginning up to one of its points.
bool isAsked(const std::string& key) {
    const auto& all = literals();
    if (all.count(key) > 0) return true;
    for (size_t point = key.find('.'); point != std::string::npos; point = key.find('.', point + 1))
        if (all.count(key.substr(0, point)) > 0 || all.count(key.substr(0, point + 1)) > 0) return true;
    return false;
}

std::set<std::string> namesIn(std::string_view sentence) {
    std::set<std::string> names;
    for (const std::string_view name : placesOf(sentence))
        names.emplace(name);
    return names;
}

} // namespace

TEST_CASE("every sentence that is asked for by name stands in the English file", "[house][words]") {
    const std::map<std::string, std::string> keys = askedKeys();
    CHECK(keys.size() > 100); // proves that the search works
    for (const auto& [key, file] : keys) {
        INFO(key << " of " << file);
        CHECK(english().find(key) != nullptr);
    }
}

TEST_CASE("every sentence of the English file is asked for", "[house][words]") {
    for (const auto& [key, sentence] : english().sentences()) {
        INFO(key << ": " << sentence);
        CHECK(isAsked(key));
        CHECK_FALSE(sentence.empty());
    }
}

TEST_CASE("sentences and literals of the program avoid words that stop a reader", "[house][words]") {
    static const std::regex stops(
        R"re(^(what|whose|whether|that which) |\b(is told|are told|stands? in|nobody|whoever|anew|dearest|otherwise than)\b)re",
        std::regex::icase);
    std::map<std::string, std::string> all = literals();
    for (const auto& [key, sentence] : english().sentences())
        all.emplace(sentence, key);
    for (const auto& [sentence, place] : all) {
        INFO(place << ": " << sentence);
        // Names of a benchmark's rows keep their history.
        if (sentence.find(' ') == std::string::npos || sentence.starts_with("what if") ||
            place.starts_with("app/bench"))
            continue;
        CHECK_FALSE(std::regex_search(sentence, stops));
    }
}

TEST_CASE("sentences for trainees and teachers are in the words file", "[house][words]") {
    // Statements of faults in files, rows of values (whose labels have keys of their own) and names for the driver.
    static const std::regex other(
        R"re(\b(InputError|RuntimeFault|throw|fprintf|printf|Scope|Buffer|Texture)\b|\{"[a-z_0-9]+",\s*")re");
    static const std::regex literal(R"re("((?:[^"\\\n]|\\.)*)")re"), twoWords("[A-Za-z]{2,},? [A-Za-z]{2,}");
    std::set<std::string> known;
    for (const auto& [key, sentence] : english().sentences())
        known.insert(sentence);
    static const std::regex comment("//[^\n]*"), endOfStatement(R"re([;{}]\s*\n)re");
    std::set<std::string> left;
    for (const test::SourceFile& file : test::readSources(
             test::sourceFolder(), {"app/ui", "app/headset", "app/activities", "app/session"}, {".cpp"})) {
        const std::string code = std::regex_replace(file.text, comment, "");
        for (std::sregex_token_iterator part(code.begin(), code.end(), endOfStatement, -1), last; part != last;
             ++part) {
            const std::string text = part->str();
            if (std::regex_search(text, other)) continue;
            for (std::sregex_iterator each(text.begin(), text.end(), literal), end; each != end; ++each)
                if (const std::string found = (*each)[1]; std::regex_search(found, twoWords) && known.count(found) == 0)
                    left.insert(found);
        }
    }
    // Names of panels and fonts, reasons in records, and faults of the settings file: in English for every language.
    static const std::set<std::string> allowed{
        R"(# Settings of the Meltpool desktop trainer. The program saves them when the window closes.\n)",
        "/System/Library/Fonts/Apple Symbols.ttf",
        "/System/Library/Fonts/Supplemental/Arial Bold.ttf",
        ": unknown entry ",
        "; expected a table of ",
        "; the program uses its defaults instead",
        "an offered value",
        "another lesson was opened",
        "bar menu",
        "headset panel",
        "help columns",
        "machine menu",
        "start menu",
        "status bar",
        "the menu",
        "two attempts are compared",
        "view menu"};
    for (const std::string& each : left) {
        INFO(each);
        CHECK(allowed.count(each) == 1);
    }
    CHECK(left.size() == allowed.size()); // a name that is gone leaves the list too
}

TEST_CASE("headings of settings are handed over in English, and have their words", "[house][words]") {
    static const std::regex heading(R"re(\b(group|groupHeading)\(context, [\w.>"-]+, "([^"]*)")re");
    int found = 0;
    for (const test::SourceFile& file : test::readSources(test::sourceFolder(), {"app"}, {".cpp"}))
        for (std::sregex_iterator each(file.text.begin(), file.text.end(), heading), end; each != end; ++each) {
            ++found;
            const std::string title = (*each)[2];
            INFO(title << " of " << file.path.generic_string());
            bool known = false;
            for (const auto& [key, sentence] : english().sentences())
                known = known || (key.starts_with("group.") && sentence == title);
            CHECK(known);
        }
    CHECK(found >= 8);
}

TEST_CASE("other languages have keys and places of the English file", "[house][words]") {
    for (const std::filesystem::directory_entry& entry : std::filesystem::directory_iterator(wordsFolder())) {
        const Words words(wordsFolder(), entry.path().stem().string());
        for (const auto& [key, sentence] : words.sentences()) {
            INFO(entry.path().filename().string() << ", " << key);
            const std::string* original = english().find(key);
            const bool ofTables =
                key.starts_with("parameter.") || key.starts_with("group.") || key == "language.decimal_mark";
            CHECK((original != nullptr || ofTables));
            if (original != nullptr) CHECK(namesIn(sentence) == namesIn(*original));
        }
    }
}

} // namespace meltpool
