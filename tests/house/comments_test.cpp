// Comments of sources, scripts and CMake files start with a noun or a verb and use the field's words.
#include "core/base/text.hpp"
#include "tests/house/source_scan.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/places.hpp"

#include <filesystem>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

namespace {

/// The part of a line behind "//"; empty without one. A "//" of an address, as in "https://", begins none.
std::string_view commentOf(std::string_view line) {
    for (size_t at = line.find("//"); at != std::string_view::npos; at = line.find("//", at + 2))
        if (at == 0 || line[at - 1] != ':') return line.substr(at);
    return {};
}

/// The part of a script's line behind a "#" at its start or after a blank; empty without one, and for a "#!" line.
std::string_view hashCommentOf(std::string_view line) {
    for (size_t at = line.find('#'); at != std::string_view::npos; at = line.find('#', at + 1)) {
        const bool begins = at == 0 || line[at - 1] == ' ' || line[at - 1] == '\t';
        if (begins && !line.substr(at).starts_with("#!")) return line.substr(at);
    }
    return {};
}

/// Returns the first words of a comment that a reader stumbled over; empty if there are none. The list may grow.
std::string refusedWords(std::string_view text) {
    static const std::regex begins(R"(^(?://[/!]?<?|#) *(What|Where|Whether|The same|That)(?: |$))");
    static const std::regex holds(R"(\b(stands in|stands for|is told|nobody|whoever|anew|dearest)\b)",
                                  std::regex::icase);
    const std::string comment(text);
    std::smatch found;
    const bool refused = std::regex_search(comment, found, begins) || std::regex_search(comment, found, holds);
    return refused ? found[1].str() : std::string();
}

/// Finds the comment of a line.
using CommentFinder = std::string_view (*)(std::string_view);

/// Reports each line whose comment has refused words.
void checkComments(const std::vector<test::SourceFile>& files, CommentFinder find) {
    for (const test::SourceFile& file : files) {
        if (file.path == "tests/house/comments_test.cpp") continue;
        int number = 0;
        for (const std::string_view line : splitText(file.text, '\n')) {
            ++number;
            const std::string words = refusedWords(find(line));
            if (words.empty()) continue;
            FAIL_CHECK(file.path.generic_string() << ":" << number << ": say it without \"" << words << "\"");
        }
    }
}

/// Returns the shell scripts and CMakeLists.txt files, with paths relative to the root of the tree.
std::vector<test::SourceFile> scripts() {
    const std::filesystem::path root = test::sourceFolder();
    std::vector<test::SourceFile> files = test::readSources(root, {"app", "tests"}, {".sh", ".txt"});
    std::erase_if(files, [](const test::SourceFile& file) {
        return file.path.extension() == ".txt" && file.path.filename() != "CMakeLists.txt";
    });
    for (const char* name : {"run.sh", "test.sh", "CMakeLists.txt", ".ci/run"})
        files.push_back({name, readTextFile(root / name)});
    return files;
}

} // namespace

TEST_CASE("comments with words that stop a reader are found", "[house]") {
    const auto refused = [](std::string_view line) { return refusedWords(commentOf(line)); };
    CHECK(refused("/// Whether the metal is finite.") == "Whether");
    CHECK(refused("int a; ///< Where it lies") == "Where");
    CHECK(refused("// The queue is drawn anew.") == "anew");
    CHECK(refused("/// True if the metal is finite, whether it flows or not.").empty());
    CHECK(refused("const char* text = \"nobody\";").empty());
    CHECK(refused("open(\"https://example.org/anew\");").empty());
}

TEST_CASE("comments of scripts with words that stop a reader are found", "[house]") {
    const auto refused = [](std::string_view line) { return refusedWords(hashCommentOf(line)); };
    CHECK(refused("# What the build server runs.") == "What");
    CHECK(refused("    # The manifest is written anew.") == "anew");
    CHECK(refused("set(a) # That which views need") == "That");
    CHECK(refused("# Runs the tests, whether they are new or not.").empty());
    CHECK(refused("#!/usr/bin/env nobody").empty());
    CHECK(refused("echo \"${#rows[@]} anew\"").empty());
    CHECK(refused("sed 's#nobody##' file").empty());
}

TEST_CASE("comments start with a noun or a verb and use the field's words", "[house]") {
    const auto files = test::readSources(test::sourceFolder(), {"core", "xr", "app", "shaders", "tests"},
                                         {".cpp", ".hpp", ".comp", ".vert", ".frag", ".geom", ".glsl", ".h"});
    REQUIRE(files.size() > 1000);
    checkComments(files, commentOf);
}

TEST_CASE("comments of scripts and CMake files start with a noun or a verb and use the field's words", "[house]") {
    const std::vector<test::SourceFile> files = scripts();
    REQUIRE(files.size() > 20);
    checkComments(files, hashCommentOf);
}

} // namespace meltpool
