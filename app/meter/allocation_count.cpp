// Counting what C++ asks of the heap: operator new, not what drivers and C libraries take by other ways.
#include "core/base/work_meter.hpp"

#include <cstdlib>
#include <new>

// An address sanitizer checks new against delete by its own pair.
#if !defined(__SANITIZE_ADDRESS__)

namespace {

void* take(std::size_t bytes) {
    ++meltpool::allocationsHere;
    return std::malloc(bytes == 0 ? 1 : bytes);
}

} // namespace

// The array and nothrow forms come here by the standard library's own definitions.
void* operator new(std::size_t bytes) {
    for (;;) {
        if (void* memory = take(bytes)) return memory;
        const std::new_handler handler = std::get_new_handler();
        if (handler == nullptr) throw std::bad_alloc();
        handler();
    }
}

void operator delete(void* memory) noexcept {
    std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

#endif
