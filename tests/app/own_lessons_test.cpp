// Lessons of a school and of a person on the command line: listed, run and checked by name, with messages about their
// faults.
#include "core/base/text.hpp"
#include "tests/app/program.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

using namespace meltpool;
using meltpool::test::containsText;
using meltpool::test::runMeltpool;

namespace {

namespace fs = std::filesystem;

/// Writes a short bead with path, metal and limits in files next to it; `more` is added to the lesson.
void writeBead(const fs::path& folder, const std::string& name, const std::string& more = "") {
    const fs::path data = test::testFolder().parent_path() / "app" / "data";
    fs::create_directories(folder / "paths");
    fs::copy_file(data / "materials" / "s235.toml", folder / "our-steel.toml", fs::copy_options::overwrite_existing);
    fs::copy_file(data / "acceptance" / "iso5817-d.toml", folder / "our-limits.toml",
                  fs::copy_options::overwrite_existing);
    writeTextFileAtomically(folder / "paths" / "bead.toml",
                            "start_mm = [-4, 3, 0]\nwork_angle_deg = 90\ntravel_angle_deg = 10\n"
                            "[[move]]\nkind = 'arc_on'\n[[move]]\nkind = 'line'\nto_mm = [4, 3, 0]\nspeed_mm_s = 16\n"
                            "[[move]]\nkind = 'arc_off'\n");
    writeTextFileAtomically(
        folder / (name + ".toml"),
        "title = 'Our bead'\nmodel = 'weld'\nnext = 'classic'\ntorch = 'paths/bead.toml'\n[run]\nseconds = 0.6\n"
        "width = 64\nheight = 48\n"
        "[workpiece]\nworkpiece = 'plate'\nmetal = 'our-steel.toml'\nlength_mm = 16\nwidth_mm = 12\nthickness_mm = 4\n"
        "[process]\nprocess = 'gmaw'\nvoltage = 21\nwire_feed_m_min = 4.5\n"
        "[technique]\nlength_from_mm = -4\nlength_to_mm = 4\naim = { ideal = 0, inner = 0.5, outer = 2 }\n"
        "[acceptance]\nuse = 'our-limits.toml'\n" +
            more);
}

struct Folders {
    fs::path school, own, out;
    std::string before; ///< environment variables that lead the program to both folders
};

Folders makeFolders(const std::string& name) {
    const fs::path base = test::scratchFolder(name);
    Folders folders{base / "school lessons", base / "data" / "meltpool" / "lessons", base / "out", {}};
    fs::create_directories(folders.school);
    fs::create_directories(folders.own);
    folders.before =
        "env MELTPOOL_LESSONS='" + folders.school.string() + "' XDG_DATA_HOME='" + (base / "data").string() + "'";
    return folders;
}

} // namespace

TEST_CASE("a school's and a person's lessons are listed in groups; faults are told and change the exit code", "[app]") {
    const Folders folders = makeFolders("own-listed");
    writeBead(folders.school, "year-one");
    writeBead(folders.own, "my-bead");
    const test::Outcome sound = runMeltpool("lessons", folders.before);
    INFO(sound.output << sound.errors);
    CHECK(sound.code == 0);
    CHECK(sound.errors.empty());
    const size_t shipped = sound.output.find("\ntee-fillet ");
    const size_t school = sound.output.find("School lessons (" + folders.school.string() + "):\nyear-one ");
    const size_t own = sound.output.find("Own lessons (" + folders.own.string() + "):\nmy-bead ");
    CHECK((shipped < school && school < own && own != std::string::npos));
    CHECK(sound.output.find("our-steel") == std::string::npos);
    CHECK(sound.output.find("our-limits") == std::string::npos);

    writeTextFileAtomically(folders.own / "wrong.toml", "title = 'Wrong'\nlevel = 9\n");
    writeBead(folders.own, "tee-fillet");
    const test::Outcome faulty = runMeltpool("lessons", folders.before);
    CHECK(faulty.code == 2);
    CHECK_THAT(faulty.output, containsText("\nmy-bead ") && containsText("\nwrong "));
    CHECK_THAT(faulty.errors, containsText((folders.own / "wrong.toml").string() + ":2: level"));
    CHECK_THAT(faulty.errors,
               containsText((folders.own / "tee-fillet.toml").string() + ": has the name of a shipped lesson"));

    fs::remove_all(folders.school);
    const test::Outcome missing = runMeltpool("lessons", folders.before);
    CHECK(missing.code == 2);
    CHECK_THAT(missing.output, containsText("\nmy-bead "));
    CHECK_THAT(missing.errors, containsText("expected a folder with lessons (MELTPOOL_LESSONS names it)"));
}

TEST_CASE("own lessons run and are checked by name, with path, metal and limits beside them", "[app]") {
    const Folders folders = makeFolders("own-run");
    writeBead(folders.own, "my-bead", "[expect]\nscored = true\n");
    const std::string out = " --out '" + folders.out.string() + "'";
    const test::Outcome run = runMeltpool("run my-bead" + out, folders.before);
    INFO(run.output << run.errors);
    CHECK(run.code == 0);
    CHECK_THAT(readTextFile(folders.out / "result.json"), containsText("\"lesson\": \"my-bead\""));
    CHECK(runMeltpool("lessons my-bead", folders.before).code == 0);

    // The lesson is found by its record.
    const test::Outcome again =
        runMeltpool("report '" + (folders.out / "telemetry.csv").string() + "'", folders.before);
    INFO(again.errors);
    CHECK(again.code == 0);

    const test::Outcome check = runMeltpool("check my-bead", folders.before);
    CHECK_THAT(check.output, containsText("my-bead") && containsText("of 1 checks as expected"));
    CHECK(check.code != 2);
    const test::Outcome none = runMeltpool("check classic", folders.before);
    CHECK(none.code == 2);
    CHECK_THAT(none.errors, containsText("classic.toml") && containsText("expect"));
    CHECK(runMeltpool("check knitting", folders.before).code == 2);
}

TEST_CASE("a shipped lesson's name means that lesson, and the file that is left out is told", "[app]") {
    const Folders folders = makeFolders("own-namesake");
    writeTextFileAtomically(folders.own / "classic.toml", "title = 'Mine'\n");
    const test::Outcome run = runMeltpool(
        "run classic --seconds 0.05 --pictures 0 --size 64x64 --set particles=64 --out '" + folders.out.string() + "'",
        folders.before);
    CHECK(run.code == 0);
    CHECK_THAT(run.errors, containsText("left out: " + (folders.own / "classic.toml").string() +
                                        ": has the name of a shipped lesson"));
    CHECK_THAT(runMeltpool("lessons classic", folders.before).errors, containsText("left out: "));
}
