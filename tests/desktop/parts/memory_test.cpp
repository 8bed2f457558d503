// Tests that large blocks of memory go back to the system when they are freed.
#include "app/platform/memory.hpp"
#include "tests/support/catch.hpp"

#include <malloc.h>

#include <cstdlib>

using namespace meltpool;

#ifndef __SANITIZE_ADDRESS__ // the sanitizer does not use the C library's memory
namespace {

/// Returns the bytes of blocks that the C library took from the system one by one.
size_t largeBlocks() {
    return mallinfo2().hblkhd;
}

} // namespace

TEST_CASE("a large block goes back to the system as often as one is freed") {
    giveLargeBlocksBack();
    const size_t before = largeBlocks();
    constexpr size_t kBytes = size_t(3) << 20;
    for (int round = 0; round < 3; ++round) {
        void* block = std::malloc(kBytes);
        REQUIRE(block != nullptr);
        CHECK(largeBlocks() >= before + kBytes);
        std::free(block);
        CHECK(largeBlocks() == before);
    }
}
#endif
