// Locks of files: one holder at a time, nothing left behind.
#include "core/base/error.hpp"
#include "core/base/file_lock.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <optional>

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
