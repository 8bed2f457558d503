// The installed program and the Debian package, run from anywhere without the source tree.
#include "core/base/text.hpp"
#include "tests/app/handbook.hpp"
#include "tests/app/program.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/places.hpp"

#include <cstdlib>

using namespace meltpool;
using meltpool::test::containsText;
using meltpool::test::runMeltpool;

namespace {

namespace fs = std::filesystem;

/// Returns true if the shell command succeeds; its output is hidden.
bool succeeds(const std::string& command) {
    return std::system((command + " >/dev/null 2>&1").c_str()) == 0;
}

void checkRuns(const fs::path& program) {
    REQUIRE(fs::exists(program));
    const std::string elsewhere = "cd / && env -u MELTPOOL_DATA";
    const test::Outcome lessons = runMeltpool("lessons", elsewhere, program);
    INFO(lessons.errors);
    CHECK(lessons.code == 0);
    CHECK_THAT(lessons.output, containsText("classic"));
    const test::Outcome doctor = runMeltpool("doctor", elsewhere, program);
    INFO(doctor.output);
    CHECK(doctor.code == 0);
    const fs::path folder = test::scratchFolder("installed-run");
    const test::Outcome run = runMeltpool(
        "run classic --seconds 0.1 --pictures 0 --size 64x64 --set particles=64 --out '" + folder.string() + "'",
        elsewhere, program);
    INFO(run.errors);
    CHECK(run.code == 0);
    CHECK(fs::exists(folder / "result.json"));
}

/// Checks that the manual page and the completion scripts are where man and the shells look for them.
void checkDocuments(const fs::path& share) {
    CHECK(succeeds("man -l '" + share.string() + "'/man/man1/meltpool.1* | grep -q 'meltpool run'"));
    for (const char* script : {"bash-completion/completions/meltpool", "fish/vendor_completions.d/meltpool.fish"}) {
        INFO(script);
        CHECK_THAT(readTextFile(share / script), containsText("completion lessons"));
    }
    CHECK((fs::exists(share / "zsh" / "vendor-completions" / "_meltpool") ||
           fs::exists(share / "zsh" / "site-functions" / "_meltpool")));
}

/// Checks that the installed README and handbook have their pages and pictures.
void checkHandbook(const fs::path& documents) {
    const auto pages = test::readPages(documents);
    CHECK(pages.size() >= 8);
    for (const std::string& broken : test::brokenLinks(pages))
        FAIL_CHECK(broken);
}

/// Checks that the menu entry starts the installed program with visible errors, and that its icon exists.
void checkMenuEntry(const fs::path& prefix) {
    const fs::path entry = prefix / "share" / "applications" / "meltpool.desktop";
    const std::string text = readTextFile(entry);
    CHECK_THAT(text, containsText("\nExec=meltpool --error-window\n"));
    CHECK_THAT(text, containsText("\nIcon=meltpool\n"));
    CHECK_THAT(text, containsText("\nExec=env LIBGL_ALWAYS_SOFTWARE=1 meltpool --error-window\n"));
    for (const char* icon : {"scalable/apps/meltpool.svg", "48x48/apps/meltpool.png"})
        CHECK(fs::file_size(prefix / "share" / "icons" / "hicolor" / icon) > 500);
    if (succeeds("command -v desktop-file-validate")) CHECK(succeeds("desktop-file-validate '" + entry.string() + "'"));
    // The option belongs to the program.
    CHECK(runMeltpool("--error-window --version", "cd /", prefix / "bin" / "meltpool").code == 0);
}

} // namespace

TEST_CASE("the installed program runs from anywhere", "[app]") {
    const fs::path prefix = test::scratchFolder("installed");
    REQUIRE(succeeds("cmake --install '" + test::buildFolder().string() + "' --prefix '" + prefix.string() + "'"));
    checkRuns(prefix / "bin" / "meltpool");
    checkHandbook(prefix / "share" / "doc" / "meltpool");
    checkMenuEntry(prefix);
    checkDocuments(prefix / "share");
}

TEST_CASE("the Debian package holds a program that runs", "[app]") {
    if (!succeeds("command -v dpkg-deb")) return; // not a Debian system
    const fs::path folder = test::scratchFolder("package");
    REQUIRE(succeeds("cpack -G DEB --config '" + test::buildFolder().string() + "/CPackConfig.cmake' -B '" +
                     folder.string() + "'"));
    REQUIRE(succeeds("dpkg-deb -x '" + folder.string() + "'/meltpool_*.deb '" + (folder / "root").string() + "'"));
    checkRuns(folder / "root" / "usr" / "bin" / "meltpool");
    checkMenuEntry(folder / "root" / "usr");
    CHECK(succeeds("dpkg-deb -f '" + folder.string() + "'/meltpool_*.deb Recommends | grep fonts-dejavu-core"));
    const fs::path documents = folder / "root" / "usr" / "share" / "doc" / "meltpool";
    checkHandbook(documents);
    checkDocuments(folder / "root" / "usr" / "share");
    if (!fs::exists("/usr/share/doc/libimgui-dev/copyright")) return; // some machines do not install them
    const std::string notices = readTextFile(documents / "licences.txt");
    for (const char* linked : {"libimgui-dev", "libglm-dev", "libcli11-dev", "nlohmann-json3-dev"})
        CHECK_THAT(notices, containsText(std::string("======== ") + linked));
}
