// Sentences by key: lookup, named places, and English where a language lacks one.
#include "core/base/words.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "tests/support/catch.hpp"

#include <filesystem>

using namespace meltpool;
using meltpool::test::containsText;

namespace {

/// A file of sentences for a language "xx".
class WrittenLanguage {
  public:
    explicit WrittenLanguage(std::string_view text) {
        std::filesystem::create_directories(folder_);
        writeTextFileAtomically(folder_ / "xx.toml", text);
    }
    ~WrittenLanguage() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    WrittenLanguage(const WrittenLanguage&) = delete;
    WrittenLanguage& operator=(const WrittenLanguage&) = delete;

    Words read() const { return Words(folder_, "xx"); }
    std::string refusal() const {
        try {
            read();
        } catch (const InputError& error) {
            return error.what();
        }
        return "taken";
    }

  private:
    std::filesystem::path folder_ = std::filesystem::temp_directory_path() / "meltpool-words-test";
};

} // namespace

TEST_CASE("a language's file: keys of tables are joined by points, and each place has its braces", "[base][words]") {
    const WrittenLanguage file("[result]\nagain = \"Noch einmal\"\n[result.redo]\nhint = \"{place} mm\"\n");
    const Words words = file.read();
    REQUIRE(words.find("result.again") != nullptr);
    CHECK(*words.find("result.again") == "Noch einmal");
    CHECK(words.find("result.redo.hint") != nullptr);
    CHECK(words.find("result") == nullptr);
    CHECK(words.decimalMark() == ".");
    CHECK(WrittenLanguage("[language]\ndecimal_mark = \",\"\n").read().decimalMark() == ",");
}

TEST_CASE("a language's file with a number or an open brace is refused with its line", "[base][words]") {
    CHECK_THAT(WrittenLanguage("[a]\nb = 3\n").refusal(), containsText("xx.toml:2: a.b: expected a text in quotes"));
    for (const char* sentence : {"{speed", "speed}", "{}", "a {b{c}"})
        CHECK_THAT(WrittenLanguage("x = \"y\"\na = \"" + std::string(sentence) + "\"\n").refusal(),
                   containsText("xx.toml:2: a: expected each place in braces of its own, such as {speed}"));
}

TEST_CASE("places are filled by name, in any order", "[base][words]") {
    CHECK(placesOf("{mean} of {asked} mm") == std::vector<std::string_view>{"mean", "asked"});
    CHECK(placesOf("no place").empty());
    CHECK(phrase("no.such.key") == "no.such.key");
    std::string text = "> ";
    appendPhrase(text, "no {b} or {a}{c}", {{"a", "1"}, {"b", "22"}});
    CHECK(text == "> no 22 or 1{c}");
}

TEST_CASE("numbers of sentences have fixed digits and no negative zero", "[base][words]") {
    const auto shown = [](double value, int digits, bool sign = false) {
        return std::string(std::string_view(PhraseNumber(value, digits, sign)));
    };
    CHECK(shown(7.55, 1) == "7.5"); // printf's rounding
    CHECK(shown(-0.04, 1) == "0.0");
    CHECK(shown(12, 0, true) == "+12");
    CHECK(shown(-12.5, 1, true) == "-12.5");
    CHECK(shown(0, 0, true) == "0");
    CHECK(shown(std::nan(""), 1) == "?");
    CHECK(shown(1e300, 0) == "1000000000000000");
}

TEST_CASE("a number that drops its zeros has the language's decimal mark", "[base][words]") {
    const Words comma = WrittenLanguage("[language]\ndecimal_mark = \",\"\n").read();
    CHECK(comma.withDecimalMark("-0.5") == "-0,5");
    CHECK(comma.withDecimalMark("12") == "12");
    CHECK(WrittenLanguage("a = \"b\"\n").read().withDecimalMark("0.5") == "0.5");
    CHECK(withDecimalMark("1.25") == "1.25"); // English has a point
}

TEST_CASE("a language without a file is refused with those that have one", "[base][words]") {
    CHECK_THROWS_WITH(chooseLanguage("xx"),
                      containsText("no file for the language 'xx'; expected one of: ") && containsText("en"));
    CHECK(language() == "en");
    CHECK(languageName("en") == "English");
    CHECK(languageName("xx") == "xx");
    const std::vector<std::string> all = languages();
    CHECK(std::find(all.begin(), all.end(), "en") != all.end());
}
