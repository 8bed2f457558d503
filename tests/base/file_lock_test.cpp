// Locks of files: one holder at a time, and no file left behind.
#include "core/base/error.hpp"
#include "core/base/file_lock.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <cerrno>
#include <chrono>
#include <fstream>
#include <optional>
#include <thread>

#ifdef __linux__
#include <dlfcn.h>

namespace {

int refusedLock = 0; ///< errno of every flock(); 0 for the system's own result

} // namespace

/// Replaces the C library's function.
extern "C" int flock(int descriptor, int operation) noexcept {
    if (refusedLock != 0) {
        errno = refusedLock;
        return -1;
    }
    static const auto real = reinterpret_cast<int (*)(int, int)>(dlsym(RTLD_NEXT, "flock"));
    return real(descriptor, operation);
}
#endif

using namespace meltpool;
using meltpool::test::containsText;

TEST_CASE("a lock has one holder at a time and leaves no file", "[base]") {
    const std::filesystem::path folder = test::scratchFolder("lock");
    const std::filesystem::path file = folder / "a.lock";
    std::optional<FileLock> first(std::in_place, file, folder / "a");
    CHECK_THROWS_AS(FileLock(file, folder / "a"), InputError);
    CHECK_THROWS_WITH(FileLock(file, folder / "a"), containsText("another program is writing here"));
    first.reset();
    CHECK_FALSE(std::filesystem::exists(file));
    CHECK_NOTHROW(FileLock(file, folder / "a"));
    CHECK_THROWS_AS(FileLock("/proc/a.lock", "/proc/a"), InputError);
}

TEST_CASE("a turn at a file comes when the other program has had its own; what each adds is in the file", "[base]") {
    const std::filesystem::path file = test::scratchFolder("turn") / "new" / "list.txt";
    const auto add = [&file](int from) {
        for (int i = from; i < from + 20; ++i) {
            const FileTurn turn(file);
            std::string text;
            std::getline(std::ifstream(file), text);
            std::this_thread::sleep_for(std::chrono::milliseconds(1)); // time in which another process could read
            std::ofstream(file) << text << 'x';
        }
    };
    std::thread other(add, 100);
    add(200);
    other.join();
    std::string text;
    std::getline(std::ifstream(file), text);
    CHECK(text.size() == 40);
    CHECK_FALSE(std::filesystem::exists(file.string() + ".lock"));
    CHECK_THROWS_AS(FileTurn("/proc/nowhere/list.txt"), InputError);
}

#ifdef __linux__
TEST_CASE("a file system without locks is told, and no reason to refuse", "[base]") {
    const std::filesystem::path folder = test::scratchFolder("lock-none");
    CHECK(FileLock(folder / "a.lock", folder).warning().empty());
    for (const int code : {ENOLCK, EOPNOTSUPP, ENOSYS}) {
        refusedLock = code;
        const FileLock lock(folder / "a.lock", folder);
        const FileTurn turn(folder / "a.txt");
        refusedLock = 0;
        CHECK_THAT(lock.warning(), containsText(folder.string()) && containsText("cannot be locked"));
        CHECK_FALSE(turn.warning().empty());
    }
    refusedLock = EACCES; // errno of some shares for a lock that another process holds
    CHECK_THROWS_WITH(FileLock(folder / "a.lock", folder), containsText("another program is writing here"));
    refusedLock = 0;
}
#endif
