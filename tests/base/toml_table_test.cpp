// TOML files with typical faults of hand editing are refused with specific messages.
#include "core/base/toml_table.hpp"

#include "core/base/error.hpp"
#include "tests/support/catch.hpp"

using namespace meltpool;
using meltpool::test::containsText;

namespace {

std::string refusalOf(std::string_view text) {
    try {
        parseToml(text, "l.toml");
    } catch (const InputError& error) {
        return error.what();
    }
    return "taken";
}

} // namespace

TEST_CASE("typographic quotes, a decimal comma and other encodings have a sentence of their own", "[base]") {
    CHECK_THAT(refusalOf("a = 1\ntitle = \u201EKehlnaht\u201C\n"),
               containsText("l.toml:2: has the typographic quote \u201E; expected straight ones"));
    CHECK_THAT(refusalOf("title = \u2018x\u2019 # \"\n"), containsText("l.toml:1: has the typographic quote \u2018"));
    CHECK_THAT(refusalOf("a = 1\nspeed_mm_s = 5,5 # fast\n"),
               containsText("l.toml:2: has the number '5,5'; expected a decimal point"));
    CHECK_THAT(refusalOf("a = -0,25\n"), containsText("has the number '-0,25'"));
    CHECK_THAT(refusalOf("a = 1\ntitle = \"gr\xFCn\"\n"),
               containsText("l.toml:2: has a character that is not UTF-8, such as one of Latin-1"));
    CHECK_THAT(refusalOf(std::string_view("\xFF\xFE"
                                          "a\0",
                                          4)),
               containsText("l.toml:1: is UTF-16; expected"));
    CHECK(refusalOf("title = \"\u201EKehlnaht\u201C\"\na = [1, 2]\n") == "taken");
    CHECK_THAT(refusalOf("a = \"\u201E\" b\n"), !containsText("typographic")); // correct inside a string
    CHECK_THAT(refusalOf("a = 5,x\n"), !containsText("decimal"));
}
