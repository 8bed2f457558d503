// A hash over the bits of a simulation state.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>

namespace meltpool {

/// FNV-1a over the bytes of values: equal bits give equal numbers, on every machine.
class StateHash {
  public:
    template <class T>
    void add(std::span<const T> values) {
        for (const T& value : values)
            addBytes(&value, sizeof(T));
    }

    std::uint64_t value() const { return hash_; }

  private:
    void addBytes(const void* data, size_t size) {
        const auto* bytes = static_cast<const unsigned char*>(data);
        for (size_t i = 0; i < size; ++i)
            hash_ = (hash_ ^ bytes[i]) * 0x100000001B3U;
    }

    std::uint64_t hash_ = 0xCBF29CE484222325U;
};

} // namespace meltpool
