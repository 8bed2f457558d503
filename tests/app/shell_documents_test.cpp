// Shell completion of commands, options, values and lesson names, and the manual page against --help.
#include "core/base/text.hpp"
#include "tests/app/program.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/places.hpp"

#include <cstdlib>
#include <regex>
#include <set>

using namespace meltpool;
using meltpool::test::containsText;
using meltpool::test::runMeltpool;

namespace {

namespace fs = std::filesystem;

const std::vector<std::string>& commands() {
    static const std::vector<std::string> names{"run",      "replay",     "compare", "demonstration", "bench",
                                                "validate", "check",      "report",  "recordings",    "doctor",
                                                "lessons",  "completion", "manual",  "history"};
    return names;
}

std::set<std::string> optionsIn(const std::string& text) {
    static const std::regex option("--[a-z][a-z-]+");
    std::set<std::string> found;
    for (std::sregex_iterator each(text.begin(), text.end(), option), end; each != end; ++each)
        found.insert(each->str());
    return found;
}

bool succeeds(const std::string& command) {
    return std::system((command + " >/dev/null 2>&1").c_str()) == 0;
}

/// Writes a shell's script into a new folder.
fs::path scriptOf(const std::string& shell) {
    const fs::path file = test::scratchFolder("completion-" + shell) / "meltpool";
    const test::Outcome outcome = runMeltpool("completion " + shell);
    CHECK(outcome.code == 0);
    writeTextFileAtomically(file, outcome.output);
    return file;
}

/// Returns bash's completions of the last of these words, each between two slashes; the person has this data folder.
std::string offered(const fs::path& script, const std::vector<std::string>& words, const fs::path& data) {
    const fs::path program = test::buildFolder() / "bin" / "meltpool";
    const fs::path output = script.parent_path() / "offered", asked = script.parent_path() / "asked.bash";
    std::string text = "source '" + script.string() + "'\ncompopt() { :; }\nCOMP_WORDS=('" + program.string() + "'";
    for (const std::string& word : words)
        text += " '" + word + "'";
    const std::string before = words.size() > 1 ? words[words.size() - 2] : program.string();
    text += ")\nCOMP_CWORD=" + std::to_string(words.size()) + "\n_meltpool '" + program.string() + "' '" +
            (words.back() == "=" ? "" : words.back()) + "' '" + before + "'\nprintf '/%s' \"${COMPREPLY[@]}\"\n";
    writeTextFileAtomically(asked, text);
    REQUIRE(std::system(("cd '" + data.string() + "' && XDG_DATA_HOME='" + data.string() + "' bash '" + asked.string() +
                         "' > '" + output.string() + "'")
                            .c_str()) == 0);
    return readTextFile(output) + "/";
}

} // namespace

TEST_CASE("bash completes commands, options, files and lessons", "[app]") {
    const fs::path script = scriptOf("bash");
    const fs::path data = test::scratchFolder("completion-data");
    fs::create_directories(data / "meltpool" / "lessons");
    fs::create_directories(data / "folder");
    writeTextFileAtomically(data / "meltpool" / "lessons" / "tee of $(touch expanded) mine.toml", "title = 'Mine'\n");
    writeTextFileAtomically(data / "some path.csv", "t\n");
    writeTextFileAtomically(data / "lesson.toml", "title = 'L'\n");
    CHECK(offered(script, {"r"}, data) == "/run/replay/report/recordings/");
    CHECK(offered(script, {"--he"}, data) == "/--help/--headset/");
    const std::string lessons = offered(script, {"run", "tee"}, data);
    CHECK_THAT(lessons, containsText("/tee-fillet/") && containsText("/tee of $(touch expanded) mine/"));
    CHECK_FALSE(fs::exists(data / "expanded")); // the file's name is not executed
    CHECK_THAT(offered(script, {"run", "l"}, data), containsText("/lap-2f/") && containsText("/lesson.toml/"));
    CHECK(offered(script, {"lessons", "gmaw"}, data) == "/gmaw-bead/");
    CHECK(offered(script, {"--lesson", "gmaw"}, data) == "/gmaw-bead/");
    CHECK(offered(script, {"run", "x", "--vid"}, data) == "/--video/--video-rate/--video-speed/");
    CHECK(offered(script, {"run", "x", "--torch", "so"}, data) == "/some path.csv/");
    CHECK(offered(script, {"run", "x", "--torch", "=", "so"}, data) == "/some path.csv/");
    CHECK(offered(script, {"run", "x", "--out", "fo"}, data) == "/folder/");
    CHECK(offered(script, {"run", "x", "--seconds", ""}, data) == "//");
    CHECK_THAT(offered(script, {"bench", ""}, data), containsText("/weld/"));
    CHECK(offered(script, {"completion", ""}, data) == "/bash/zsh/fish/");
    // Keys belong to the lesson that the line names at any place.
    CHECK(offered(script, {"run", "gmaw-bead", "--set", "volt"}, data) == "/voltage=/");
    CHECK_THAT(offered(script, {"run", "--video", "classic", "--set", ""}, data),
               containsText("/particles=/") && !containsText("/voltage=/"));
    CHECK(offered(script, {"run", "x", "--set", "volt"}, data) == "//");
}

TEST_CASE("every shell's script and the manual page have every option of --help", "[app]") {
    std::vector<std::pair<std::string, std::string>> texts;
    for (const char* shell : {"bash", "zsh", "fish"}) {
        const fs::path script = scriptOf(shell);
        if (succeeds("command -v " + std::string(shell))) {
            INFO(shell);
            CHECK(succeeds(std::string(shell) + " -n '" + script.string() + "'"));
        }
        texts.emplace_back(shell, readTextFile(script));
    }
    const fs::path folder = test::scratchFolder("manual");
    writeTextFileAtomically(folder / "meltpool.1", runMeltpool("manual").output);
    texts.emplace_back("manual", std::regex_replace(readTextFile(folder / "meltpool.1"), std::regex(R"(\\-)"), "-"));
    for (const std::string& command : commands()) {
        const std::set<std::string> options = optionsIn(runMeltpool(command + " --help").output);
        CHECK(!options.empty());
        for (const auto& [name, text] : texts)
            for (const std::string& option : options) {
                INFO(name << ": " << command << ' ' << option);
                CHECK_THAT(text, containsText(name == "fish" ? "-l " + option.substr(2) : option));
            }
    }
    const std::string& manual = texts.back().second;
    CHECK_THAT(manual, containsText(".SS meltpool run [OPTIONS] LESSON\nRun a lesson's demonstration"));
    CHECK_THAT(manual,
               containsText("\\fB--torch\\fR \\fIFILE\\fR\nTorch path, .csv or .toml, instead of the lesson's"));
    CHECK_THAT(manual, containsText("MELTPOOL_LESSONS"));
    CHECK_THAT(manual, containsText("\n.SH EXAMPLES\n.TP\n\\fBmeltpool --lesson gmaw-bead\\fR\n"));
    CHECK(manual.substr(0, manual.find('\n')).find("\"\"") == std::string::npos); // no empty field
    if (succeeds("command -v groff")) {
        // Groff warns of requests and escapes that roff does not know.
        CHECK(succeeds("test -z \"$(groff -man -Tutf8 -ww '" + (folder / "meltpool.1").string() +
                       "' 2>&1 >/dev/null)\""));
    }
    const test::Outcome unknown = runMeltpool("completion tcsh");
    CHECK(unknown.code == 2);
    CHECK_THAT(unknown.errors, containsText("'tcsh'") && containsText("bash, zsh, fish"));
}
