// Comments start with a noun or a verb and use the field's words.
#include "core/base/text.hpp"
#include "tests/house/source_scan.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/places.hpp"

#include <regex>
#include <string>
#include <string_view>

namespace meltpool {

namespace {

/// The part of a line behind "//"; empty without one. A "//" of an address, as in "https://", begins none.
std::string_view commentOf(std::string_view line) {
    for (size_t at = line.find("//"); at != std::string_view::npos; at = line.find("//", at + 2))
        if (at == 0 || line[at - 1] != ':') return line.substr(at);
    return {};
}

/// Returns the first words of a line's comment that a reader stumbled over; empty if there are none. The list
/// may grow.
std::string refusedWords(std::string_view line) {
    static const std::regex begins(R"(^//[/!]?<? *(What|Where|Whether|The same|That)(?: |$))");
    static const std::regex holds(R"(\b(stands in|stands for|is told|nobody|whoever|anew|dearest)\b)",
                                  std::regex::icase);
    const std::string comment(commentOf(line));
    std::smatch found;
    const bool refused = std::regex_search(comment, found, begins) || std::regex_search(comment, found, holds);
    return refused ? found[1].str() : std::string();
}

} // namespace

TEST_CASE("comments with words that stop a reader are found", "[house]") {
    CHECK(refusedWords("/// Whether the metal is finite.") == "Whether");
    CHECK(refusedWords("int a; ///< Where it lies") == "Where");
    CHECK(refusedWords("// The queue is drawn anew.") == "anew");
    CHECK(refusedWords("/// True if the metal is finite, whether it flows or not.").empty());
    CHECK(refusedWords("const char* text = \"nobody\";").empty());
    CHECK(refusedWords("open(\"https://example.org/anew\");").empty());
}

TEST_CASE("comments start with a noun or a verb and use the field's words", "[house]") {
    const auto files = test::readSources(test::sourceFolder(), {"core", "xr", "app", "shaders", "tests"},
                                         {".cpp", ".hpp", ".comp", ".vert", ".frag", ".geom", ".glsl", ".h"});
    REQUIRE(files.size() > 1000);
    for (const test::SourceFile& file : files) {
        if (file.path == "tests/house/comments_test.cpp") continue;
        int number = 0;
        for (const std::string_view line : splitText(file.text, '\n')) {
            ++number;
            const std::string words = refusedWords(line);
            if (words.empty()) continue;
            FAIL_CHECK(file.path.generic_string() << ":" << number << ": say it without \"" << words << "\"");
        }
    }
}

} // namespace meltpool
