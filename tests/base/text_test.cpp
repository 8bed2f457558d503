// Texts of files and messages: accepted and refused input, and text made safe for a terminal.
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/base/toml_table.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <cstdlib>

#ifndef _WIN32
#include <sys/stat.h>
#endif

using namespace meltpool;
using meltpool::test::containsText;

namespace {

std::string repeated(const std::string& part, size_t count) {
    std::string text;
    for (size_t i = 0; i < count; ++i)
        text += part;
    return text;
}

} // namespace

TEST_CASE("a text begins with a capital, with an umlaut too") {
    CHECK(capitalised("wire feed") == "Wire feed");
    CHECK(capitalised("\u00FCberhitzt") == "\u00DCberhitzt");
    CHECK(capitalised("\u00DCberhitzt") == "\u00DCberhitzt");
    CHECK(capitalised("\u00F7") == "\u00F7"); // not a letter
    CHECK(capitalised("3 mm") == "3 mm");
    CHECK(capitalised("").empty());
}

TEST_CASE("nothing of a file moves a terminal's cursor or breaks its text", "[base]") {
    CHECK(printable("plain, grüß Gott – 2 °C", 100) == "plain, grüß Gott – 2 °C");
    CHECK(printable("a\x1b[2Jb\x07", 100) == "a\\x1b[2Jb\\x07");
    CHECK(printable("two\nlines\tand\rmore", 100) == "two lines and more");
    CHECK(printable("\xff\xc3", 100) == "\\xff\\xc3");
    CHECK(printable("\xc0\x80 \xed\xa0\x80 \xf5\x80\x80\x80", 100) ==
          "\\xc0\\x80 \\xed\\xa0\\x80 \\xf5\\x80\\x80\\x80"); // overlong, half of a surrogate pair, beyond U+10FFFF
    CHECK(printable("\xc2\x9b"
                    "1m",
                    100) == "\\xc2\\x9b"
                            "1m"); // control character in two bytes
    CHECK(printable("\xe2\x80\xae"
                    "txt",
                    100) == "\\xe2\\x80\\xae"
                            "txt"); // changes the writing direction
    CHECK(printable(std::string("nul\0l", 5), 100) == "nul\\x00l");
    CHECK(quote("x") == "'x'");
}

TEST_CASE("a long text is cut in its middle, and what is printable stays as it is", "[base]") {
    const std::string text = "begin" + repeated("\xc3\xa4", 100000) + "end";
    const std::string cut = printable(text, 100);
    CHECK(cut.size() <= 100);
    CHECK(cut.size() > 90);
    CHECK_THAT(cut, containsText("begin") && containsText("\xe2\x80\xa6") && containsText("end"));
    CHECK(printable(cut, 100) == cut);
    for (size_t most = 0; most < 30; ++most) {
        CHECK(printable(text, most).size() <= std::max<size_t>(most, 5));
        CHECK(printable("\xff\xff\x1b" + text, most).size() <= std::max<size_t>(most, 5));
    }
    CHECK(std::string(InputError(repeated("x", 5000)).what()).size() <= 2000);
    CHECK(std::string(RuntimeFault("a\x1b"
                                   "b")
                          .what()) == "a\\x1b"
                                      "b");
}

TEST_CASE("what cannot be read is never taken for an empty file", "[base]") {
    const auto folder = test::scratchFolder("read");
    CHECK_THROWS_WITH(readTextFile(folder), containsText("this is a folder"));
    CHECK_THROWS_WITH(readTextFile(folder / "none"), containsText("cannot be opened"));
    writeTextFileAtomically(folder / "long", std::string(5000, 'x'));
    CHECK(readTextFile(folder / "long", 5000).size() == 5000);
    CHECK_THROWS_WITH(readTextFile(folder / "long", 4096),
                      containsText("is too long; expected a file of at most 4 KiB"));
#ifdef __linux__
    CHECK_THROWS_WITH(readTextFile("/proc/self/mem"),
                      containsText("cannot be read to its end") && containsText("expected"));
    CHECK_THROWS_WITH(readTextFile("/dev/zero", 1 << 20), containsText("expected a file of at most 1024 KiB"));
#endif
}

#ifndef _WIN32
TEST_CASE("a pipe that never ends is refused at the limit", "[base]") {
    const auto pipe = test::scratchFolder("endless") / "pipe.toml";
    REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    REQUIRE(std::system(("yes 'a = 1' > '" + pipe.string() + "' 2>/dev/null &").c_str()) == 0);
    CHECK_THROWS_WITH(parseTomlFile(pipe), containsText("pipe.toml: is too long; expected a file of at most 1024 KiB"));
}
#endif

TEST_CASE("TOML that is nested without end is refused with its line before it is parsed", "[base]") {
    const auto parse = [](const std::string& text) { return parseToml(text, "deep.toml"); };
    for (const std::string& deep :
         {"x = 1\n" + repeated("a.", 40000) + "b = 1", "x = 1\n[" + repeated("a . ", 40000) + "b]",
          "x = 1\na = { " + repeated("a.", 40000) + "b = 1 }", "x = 1\n" + repeated("'a'.\"b\".", 20000) + "c = 1"})
        CHECK_THROWS_WITH(parse(deep), containsText("deep.toml:2: the key has too many parts; expected at most 16"));
    for (const std::string& deep : {"x = 1\na = " + repeated("[", 40000), "x = 1\na = " + repeated("{a=", 40000),
                                    "x = 1\na = " + repeated("[{a=", 20000)})
        CHECK_THROWS_WITH(parse(deep), containsText("deep.toml:2: the brackets are nested too deeply"));
    // Strings and comments may have any number of dots and brackets and hide no fault behind them.
    const std::string dots = repeated(".", 100) + repeated("[", 100);
    CHECK_NOTHROW(parse("a = \"" + dots + "\\\"" + dots + "\" # " + dots + "\nb = '" + dots + "\\'\nc = 1.5\n"));
    CHECK_NOTHROW(
        parse("a = \"\"\"" + dots + "\n\"" + dots + "\\\"\"\"\"\"\nb = '''" + dots + "''\n'" + dots + "'''\n"));
    CHECK_THROWS_WITH(parse("a = '''x'''\nb = \"\"\n" + repeated("a.", 40000) + "b = 1"),
                      containsText("deep.toml:3: "));
    CHECK_NOTHROW(parse("a.b.c.d.e = [[1.5, 2.5], [3.5]]\n[x.y]\nz = { w = 1.25 }"));
}
