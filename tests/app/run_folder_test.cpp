// The folder of a run: which of its files belong to the run, which are removed, and which are refused.
#include "app/commands/run_folder.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <vector>

#ifdef __linux__
#include <cerrno>
#include <dlfcn.h>

namespace {

bool locksRefused = false; ///< simulates a share without locks

} // namespace

/// Replaces the C library's function.
extern "C" int flock(int descriptor, int operation) noexcept {
    if (locksRefused) {
        errno = ENOLCK;
        return -1;
    }
    static const auto real = reinterpret_cast<int (*)(int, int)>(dlsym(RTLD_NEXT, "flock"));
    return real(descriptor, operation);
}

TEST_CASE("a share without locks takes a run's folder", "[app]") {
    const std::filesystem::path folder = meltpool::test::scratchFolder("run-folder-share");
    locksRefused = true;
    CHECK_NOTHROW(meltpool::RunFolder(folder, {}));
    locksRefused = false;
}
#endif

using namespace meltpool;

namespace fs = std::filesystem;

TEST_CASE("only names that a run gives are a run's files", "[app]") {
    for (const char* name :
         {"result.json", "telemetry.csv", "technique.csv", "weld.csv", "001.500s-metal.png", "1234.000s-my_look.png",
          "result.json.312.tmp", "000.000s-a.png.7.tmp", "video-000000.png", "turntable-011.png", "video.mp4"})
        CHECK(isRunFile(name));
    for (const char* name : {"result.json.tmp", "my-result.json", "telemetry.csv.bak", "01.500s-metal.png",
                             "001.50s-x.png", "001.500-metal.png", "video-00.png", "my-video.mp4", "001.500s-metal.jpg",
                             "photo.png", "", ".tmp", "001.", "notes.7.tmp"})
        CHECK_FALSE(isRunFile(name));
}

TEST_CASE("an earlier run's files are removed, nobody else's", "[app]") {
    const fs::path folder = test::scratchFolder("run-folder");
    for (const char* name : {"result.json", "telemetry.csv", "000.500s-metal.png", "notes.txt"})
        writeTextFileAtomically(folder / name, "x");
    fs::create_directories(folder / "001.000s-metal.png");
    {
        RunFolder run(folder, {});
        CHECK(run.clear() == 3);
        CHECK(run.clear() == 0);
        CHECK_THROWS_AS(RunFolder(folder, {}), InputError);
    }
    CHECK(fs::exists(folder / "notes.txt"));
    CHECK(fs::is_directory(folder / "001.000s-metal.png"));
    CHECK_NOTHROW(RunFolder(folder, {}));
}

TEST_CASE("a link in the folder to a file that the run reads is found out", "[app]") {
    const fs::path folder = test::scratchFolder("linked");
    const fs::path source = folder / "lesson.toml";
    writeTextFileAtomically(source, "x");
    const std::vector<fs::path> sources{source};
    CHECK_NOTHROW(RunFolder(folder / "out", sources));
    fs::create_symlink(source, folder / "out" / "000.000s-metal.png");
    CHECK_THROWS_AS(RunFolder(folder / "out", sources), InputError);
}

TEST_CASE("a run without a folder gets a new one, named for its lesson", "[app]") {
    const fs::path here = test::scratchFolder("new-run-folder");
    CHECK(newRunFolder(here, "classic") == here / "meltpool-classic");
    fs::create_directories(here / "meltpool-classic");
    CHECK(newRunFolder(here, "classic") == here / "meltpool-classic-2");
    fs::create_directories(here / "meltpool-classic-2");
    CHECK(newRunFolder(here, "classic") == here / "meltpool-classic-3");
    CHECK(newRunFolder(here, "tee") == here / "meltpool-tee");
}
