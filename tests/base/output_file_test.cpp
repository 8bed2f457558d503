// Whole files or none: effects of a full disk, a size limit, a device, a link and a missing folder.
#include "core/base/error.hpp"
#include "core/base/image.hpp"
#include "core/base/output_file.hpp"
#include "core/base/text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <cerrno>

#ifndef _WIN32
#include <csignal>
#include <dlfcn.h>
#include <sys/resource.h>
#include <sys/stat.h>

namespace {

int failedSync = 0; ///< errno of every fsync(); 0 for the system's own result

} // namespace

/// Replaces the C library's function.
extern "C" int fsync(int descriptor) {
    if (failedSync != 0) {
        errno = failedSync;
        return -1;
    }
    static const auto real = reinterpret_cast<int (*)(int)>(dlsym(RTLD_NEXT, "fsync"));
    return real(descriptor);
}
#endif

using namespace meltpool;
using meltpool::test::containsText;

namespace {

namespace fs = std::filesystem;

size_t filesIn(const fs::path& folder) {
    size_t count = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder))
        ++count;
    return count;
}

#ifndef _WIN32
/// During its lifetime no file of this process may grow beyond `bytes`: a disk that fills midway.
class SizeLimit {
  public:
    explicit SizeLimit(rlim_t bytes) : signal_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~SizeLimit() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, signal_);
    }
    SizeLimit(const SizeLimit&) = delete;
    SizeLimit& operator=(const SizeLimit&) = delete;

  private:
    rlimit before_{};
    void (*signal_)(int);
};

/// A picture that no compression makes small.
Image noise() {
    Image image{200, 100, std::vector<std::uint8_t>(200 * 100 * 3)};
    std::uint32_t state = 1;
    for (std::uint8_t& value : image.rgb) {
        state = state * 1664525u + 1013904223u;
        value = static_cast<std::uint8_t>(state >> 24);
    }
    return image;
}
#endif

} // namespace

TEST_CASE("a file is replaced as a whole, keeps its permissions and leaves nothing beside it", "[base]") {
    const fs::path folder = test::scratchFolder("output");
    const fs::path file = folder / "a.txt";
    writeFile(file, "first");
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
    const fs::perms before = fs::status(file).permissions(); // Windows has fewer permissions
    writeFile(file, std::string("second\0part", 11));
    CHECK(readTextFile(file) == std::string("second\0part", 11));
    CHECK(fs::status(file).permissions() == before);
    CHECK(filesIn(folder) == 1);
}

TEST_CASE("a place that cannot be written is the person's fault and named", "[base]") {
    const fs::path folder = test::scratchFolder("nowhere");
    writeFile(folder / "file", "no folder");
    for (const fs::path& place : {folder / "no" / "such.txt", folder / "file" / "below.txt", folder,
                                  folder / std::string(300, 'x'), fs::path("/proc/nothing")}) {
        INFO(place);
        CHECK_THROWS_AS(writeFile(place, "x"), InputError);
        CHECK_THROWS_AS(requireWritable(place), InputError);
        CHECK_THROWS_WITH(writeFile(place, "x"), containsText(place.string()) && containsText("expected"));
    }
    CHECK(filesIn(folder) == 1);
}

TEST_CASE("asking whether a file can be written changes nothing", "[base]") {
    const fs::path folder = test::scratchFolder("asked");
    requireWritable(folder / "new.txt");
    CHECK(filesIn(folder) == 0);
    writeFile(folder / "old.txt", "old");
    requireWritable(folder / "old.txt");
    CHECK(readTextFile(folder / "old.txt") == "old");
    CHECK(filesIn(folder) == 1);
}

#ifndef _WIN32 // MinGW's library makes no links, and filling a disk is harder there

TEST_CASE("a link stays a link, and what it names is replaced", "[base]") {
    const fs::path folder = test::scratchFolder("link");
    fs::create_directories(folder / "far");
    writeFile(folder / "far" / "real.txt", "old");
    fs::create_symlink("far/real.txt", folder / "link.txt");
    fs::create_symlink("far/fresh.txt", folder / "dangling.txt");
    writeFile(folder / "link.txt", "new");
    writeFile(folder / "dangling.txt", "made");
    CHECK(fs::is_symlink(folder / "link.txt"));
    CHECK(readTextFile(folder / "far" / "real.txt") == "new");
    CHECK(readTextFile(folder / "far" / "fresh.txt") == "made");
}

TEST_CASE("a disk that fills midway leaves the old file whole and nothing else", "[base]") {
    const fs::path folder = test::scratchFolder("filling");
    writeFile(folder / "kept.txt", "old");
    const SizeLimit limit(1000);
    CHECK_THROWS_AS(writeFile(folder / "kept.txt", std::string(5000, 'x')), RuntimeFault);
    CHECK_THROWS_WITH(writeFile(folder / "kept.txt", std::string(5000, 'x')),
                      containsText("kept.txt: cannot be written to its end") && containsText("expected free space"));
    CHECK(readTextFile(folder / "kept.txt") == "old");
    CHECK(filesIn(folder) == 1);
}

TEST_CASE("a picture is never cut in silence", "[base]") {
    const fs::path folder = test::scratchFolder("picture");
    writePng(folder / "whole.png", noise());
    CHECK(readPng(folder / "whole.png").rgb == noise().rgb);
    const SizeLimit limit(1000);
    CHECK_THROWS_AS(writePng(folder / "cut.png", noise()), RuntimeFault);
    CHECK(filesIn(folder) == 1);
}

TEST_CASE("devices and pipes are written directly and stay what they are", "[base]") {
    CHECK_THROWS_AS(writeFile("/dev/full", "x"), RuntimeFault);
    CHECK(fs::is_character_file("/dev/full"));
    CHECK_NOTHROW(writeFile("/dev/null", "x"));
    CHECK(fs::is_character_file("/dev/null"));
    CHECK_FALSE(isPlainFile("/dev/null"));
    CHECK(isPlainFile(test::scratchFolder("plain") / "new"));
}

#endif

#ifndef _WIN32
TEST_CASE("a disk that fails is not told as a full one", "[base]") {
    const fs::path folder = test::scratchFolder("output-eio");
    writeFile(folder / "kept.txt", "old");
    failedSync = EIO;
    CHECK_THROWS_AS(writeFile(folder / "kept.txt", "new"), RuntimeFault);
    CHECK_THROWS_WITH(writeFile(folder / "kept.txt", "new"), containsText("kept.txt: cannot be written to its end") &&
                                                                 containsText("expected a working disk or share") &&
                                                                 !containsText("free space"));
    failedSync = 0;
    CHECK(readTextFile(folder / "kept.txt") == "old");
    CHECK(filesIn(folder) == 1);
    for (const int full : {ENOSPC, EDQUOT, EFBIG})
        CHECK(writeExpectation(full) == "expected free space");
    for (const int other : {EIO, EMFILE, ENFILE, ENOMEM, ESTALE, 0})
        CHECK(writeExpectation(other).find("free space") == std::string::npos);
}
#endif
