// Invalid input ends the real program with exit code 2 and one sentence that names the place and the fault.
#include "core/base/text.hpp"
#include "tests/app/program.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

using namespace meltpool;
using meltpool::test::containsText;
using meltpool::test::runMeltpool;

namespace {

const std::string kHeader = "time_s,x_mm,y_mm,z_mm,qx,qy,qz,qw,trigger\n";

struct Case {
    std::string arguments, place, expectation;
};

void checkRefusal(const Case& bad) {
    INFO(bad.arguments);
    const test::Outcome outcome = runMeltpool(bad.arguments);
    INFO(outcome.errors);
    CHECK(outcome.code == 2);
    CHECK_THAT(outcome.errors, containsText(bad.place));
    CHECK_THAT(outcome.errors, containsText(bad.expectation));
    CHECK_THAT(outcome.errors, containsText("xpected")); // or "Expected", after a likely name
    // The message is one sentence on one line.
    CHECK(std::count(outcome.errors.begin(), outcome.errors.end(), '\n') == 1);
}

} // namespace

TEST_CASE("bad command lines are refused", "[app]") {
    const std::string out = " --out '" + (test::scratchFolder("words") / "out").string() + "' ";
    for (const Case& bad : std::vector<Case>{
             {"fly", "fly", "--help"},
             {"run", "", "required"},
             {"run classic --out", "--out", "expected --out DIR"},
             {"run classic --speed 3" + out, "--speed", "--help"},
             {"run clasic" + out, "'clasic'", "did you mean 'classic'? Expected one of butt-1g, classic"},
             {"run missing.toml" + out, "missing.toml", "expected a readable file"},
             {"run classic --torch missing.csv" + out, "missing.csv", "expected a readable file"},
             {"run classic --torch missing.toml" + out, "missing.toml", "expected a readable file"},
             {"run classic --torch README" + out, "README", "expected a file that ends in .csv"},
             {"run classic --set particels=5" + out, "'particels'", "did you mean 'particles'? Expected one of"},
             {"run classic --set particles" + out, "'particles'", "expected KEY=VALUE"},
             {"run classic --set particles=0" + out, "'particles' is '0'", "expected a whole number from 1"},
             {"run classic --set viscosity=inf" + out, "'viscosity' is 'inf'", "expected a number from"},
             {"run classic --set material=cheese" + out, "'material' is 'cheese'", "expected one of solder"},
             {"run classic --seconds -1" + out, "'seconds' is '-1'", "expected a number from 0"},
             {"run classic --seconds soon" + out, "'seconds' is 'soon'", "expected a number from 0"},
             {"run classic --pictures x" + out, "'pictures_every' is 'x'", "expected a number from 0"},
             {"run classic --size 640" + out, "'640'", "expected WIDTHxHEIGHT"},
             {"run classic --size 0x480" + out, "0x480", "expected a whole number from 16"},
             {"bench nonsense", "'nonsense'", "expected one of classic"},
             {"--headset run classic" + out, "--headset is an option of the trainer's window", "run --help"},
             {"--lesson x bench classic", "--lesson is an option of the trainer's window", "bench --help"},
             {"--record x lessons", "--record is an option of the trainer's window", "lessons --help"},
             {"--person ''", "--person: The name is empty", "expected 1 to 40 letters"},
             {"--person ' ' --desktop", "--person: The name is empty", "expected 1 to 40 letters"},
             {"--person " + std::string(41, 'x'), "--person: The name 'xxx", "has 41 letters; expected 40 at most"},
             {"--person $(printf 'a\\001b')", "--person: The name 'a", "expected letters, digits"},
             {"--person Anna recordings", "--person is an option of the trainer's window", "recordings --help"},
             {"run gmaw-bead --set voltage=30" + out, "'voltage' is '30'", "expected a number from 16 to 26 (V)"},
             {"run gmaw-bead --set metal=cheese" + out, "unknown material 'cheese'", "expected one of 304"},
         })
        checkRefusal(bad);
}

TEST_CASE("bad files are refused with their line", "[app]") {
    const auto folder = test::scratchFolder("files");
    const std::string out = " --out '" + (folder / "out").string() + "'";
    const auto torch = [&](const std::string& name, const std::string& text) {
        writeTextFileAtomically(folder / name, text);
        return "run classic --torch '" + (folder / name).string() + "'" + out;
    };
    const auto lesson = [&](const std::string& name, const std::string& text) {
        writeTextFileAtomically(folder / name, text);
        return "run '" + (folder / name).string() + "'" + out;
    };
    for (const Case& bad : std::vector<Case>{
             {torch("row.csv", kHeader + "0,1,2,3,0,0,0,1,1\n1,1,2\n"), "row.csv:3: ", "expected 9"},
             {torch("word.csv", kHeader + "0,1,two,3,0,0,0,1,1\n"), "word.csv:2: ", "expected a position"},
             {torch("back.csv", kHeader + "2,1,2,3,0,0,0,1,1\n1,1,2,3,0,0,0,1,1\n"), "back.csv:3: ", "at least 2"},
             {torch("quat.csv", kHeader + "0,1,2,3,0,0,0,0,1\n"), "quat.csv:2: ", "expected 1"},
             {torch("head.csv", "time_s,x_mm\n"), "head.csv:1: ", "y_mm"},
             {torch("key.toml", "start_mm = [0,0,0]\nspeed = 3\n"), "key.toml:2: ", "unknown key"},
             {lesson("key2.toml", "title = 'x'\n[metal]\nthickness = 3\n"), "key2.toml:3: ", "unknown key"},
             {lesson("range.toml", "title = 'x'\n[metal]\nviscosity = -3\n"), "range.toml:3: ", "from 0 to"},
             {lesson("syntax.toml", "title = 'x'\n[metal\n"), "syntax.toml:2: ", ""},
         }) {
        INFO(bad.arguments);
        const test::Outcome outcome = runMeltpool(bad.arguments);
        INFO(outcome.errors);
        CHECK(outcome.code == 2);
        CHECK_THAT(outcome.errors, containsText(bad.place));
        CHECK_THAT(outcome.errors, containsText(bad.expectation));
        CHECK(std::count(outcome.errors.begin(), outcome.errors.end(), '\n') == 1);
    }
}

TEST_CASE("a folder that cannot be written is refused before anything is computed", "[app]") {
    const auto folder = test::scratchFolder("unwritable");
    writeTextFileAtomically(folder / "file", "not a folder");
    checkRefusal(
        {"run classic --out '" + (folder / "file" / "out").string() + "'", "file/out", "expected a parent folder"});
    checkRefusal({"run classic --out '" + (folder / "file").string() + "'", "file", "expected a parent folder"});
    checkRefusal({"run classic --seconds 0.1 --set particles=64 --out /proc", "/proc", "expected"});
}

TEST_CASE("a fault in a file that a lesson names is told with the lines of both", "[app]") {
    const auto folder = test::scratchFolder("named");
    const std::string file = "'" + (folder / "mine.toml").string() + "'";
    const std::string out = " --out '" + (folder / "out").string() + "'";
    const auto lesson = [&](const std::string& text) { writeTextFileAtomically(folder / "mine.toml", text); };
    writeTextFileAtomically(folder / "bad.csv", kHeader + "0,1,two,3,0,0,0,1,1\n");
    writeTextFileAtomically(folder / "bad-metal.toml", "name = 'x'\n[melting]\n");

    lesson("title = 'x'\ntorch = 'bad.csv'\n");
    for (const std::string& command : {"run " + file + out, "lessons " + file}) {
        checkRefusal({command, "mine.toml:2: torch: ", "bad.csv:2: y_mm is 'two'"});
    }
    lesson("title = 'x'\ntorch = 'none.csv'\n");
    checkRefusal({"lessons " + file, "mine.toml:2: torch: ", "none.csv: cannot be opened"});
    lesson("model = 'weld'\n[workpiece]\nmetal = 'bad-metal.toml'\n");
    checkRefusal({"lessons " + file, "mine.toml:3: [workpiece] metal: ", "bad-metal.toml:2: "});
    lesson("model = 'weld'\n[workpiece]\nmetal = 'cheese'\n");
    checkRefusal(
        {"lessons " + file, "mine.toml:3: [workpiece] metal: unknown material 'cheese'", "expected one of 304"});
}

TEST_CASE("a lesson's own metal lies beside the lesson, wherever the program is started", "[app]") {
    const auto folder = test::scratchFolder("own-metal");
    std::filesystem::copy_file(test::testFolder().parent_path() / "app/data/materials/s235.toml", folder / "mine.toml");
    writeTextFileAtomically(folder / "lesson.toml", "model = 'weld'\n[workpiece]\nmetal = 'mine.toml'\n");
    const test::Outcome outcome = runMeltpool("lessons '" + (folder / "lesson.toml").string() + "'", "cd / &&");
    INFO(outcome.errors);
    CHECK(outcome.code == 0);
    CHECK_THAT(outcome.output, containsText((folder / "mine.toml").string()));
}

TEST_CASE("no control character of a file or argument reaches the terminal, and no message is endless", "[app]") {
    const auto folder = test::scratchFolder("controls");
    const std::string escape = "\x1b[31m\xff";
    const std::string file = "'" + (folder / "l.toml").string() + "'";
    writeTextFileAtomically(folder / "l.toml", "model = \"\\u001b[31m" + std::string(5000, 'x') + "\"\n");
    writeTextFileAtomically(folder / "k.toml", std::string(5000, 'k') + " = 1\n");
    const std::string out = " --out '" + (folder / "out").string() + "'";
    for (const std::string& arguments :
         {"run " + file + out, "lessons " + file, "lessons '" + (folder / "k.toml").string() + "'",
          "run '" + escape + "'" + out, "run classic --set '" + escape + std::string(5000, 'x') + "=1'" + out,
          "run classic --set 'material=" + escape + "'" + out, "'" + escape + std::string(5000, 'x') + "'",
          "run classic --torch '" + escape + ".csv'" + out}) {
        const test::Outcome outcome = runMeltpool(arguments);
        INFO(outcome.errors);
        CHECK(outcome.code == 2);
        CHECK(outcome.errors.find('\x1b') == std::string::npos);
        CHECK(outcome.errors.find('\xff') == std::string::npos);
        CHECK(outcome.errors.size() < 1500);
    }
    writeTextFileAtomically(folder / "good.toml", "model = 'weld'\n[workpiece]\nmetal = \"s\\u001b235\"\n");
    CHECK(runMeltpool("lessons '" + (folder / "good.toml").string() + "'").output.find('\x1b') == std::string::npos);
}

TEST_CASE("output that cannot be written is a fault with a sentence", "[app]") {
    if (!std::filesystem::exists("/dev/full")) return;
    for (const char* arguments : {"lessons", "lessons classic", "--help", "--version", "run --help"}) {
        INFO(arguments);
        const test::Outcome outcome = runMeltpool(arguments, "sh -c '\"$@\" >/dev/full' sh");
        CHECK(outcome.code == 1);
        CHECK_THAT(outcome.errors, containsText("standard output cannot be written to its end"));
    }
}
