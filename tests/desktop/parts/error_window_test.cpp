// Tests the message of a failed start, and the choice of its program without an X display.
#include "app/desktop/error_window.hpp"
#include "app/platform/watched_run.hpp"
#include "tests/support/catch.hpp"

#include <array>

namespace meltpool::test {

TEST_CASE("the person reads the program's sentences, of a crash the signal, and of an end without words the code") {
    CHECK(endSentence({0, "meltpool: a warning of a start that went well\n"}).empty());
    CHECK(endSentence({2, "meltpool: there is no lesson 'knitting'\n"}) == "There is no lesson 'knitting'");
    CHECK(endSentence({1, "driver: slow\nmeltpool: the settings were not saved\n"}) ==
          "Driver: slow\nthe settings were not saved");
    CHECK_THAT(endSentence({1, ""}), containsText("code 1"));
    const std::string crash = endSentence({128 + 11, "driver: out of memory\n"});
    CHECK_THAT(crash, containsText("Driver: out of memory\n"));
    CHECK_THAT(crash, containsText("signal 11"));
}

TEST_CASE("the option of the menu entry is taken out of the words, wherever it is among them") {
    const std::array<const char*, 4> words{"meltpool", "--desktop", "--error-window", "--no-recording"};
    CHECK(withoutOption(4, words.data(), "--error-window") == std::vector<std::string>{"--desktop", "--no-recording"});
    CHECK_FALSE(withoutOption(2, words.data(), "--error-window"));
}

TEST_CASE("the desktop's own dialog program comes first, and takes the sentence as it is") {
    const std::string sentence = "<b> is no tag & $HOME no variable";
    const auto elsewhere = dialogCommands(sentence, "ubuntu:GNOME");
    REQUIRE(elsewhere.size() == 2);
    CHECK(elsewhere[0].program == "zenity");
    CHECK(elsewhere[0].words.back() == "--text=" + sentence);
    const auto kde = dialogCommands(sentence, "KDE");
    CHECK(kde[0].program == "kdialog");
    CHECK(kde[0].words.back() == sentence);
}

} // namespace meltpool::test
