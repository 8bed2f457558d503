// Reads and writes numbers as bytes, the lowest byte first on every machine.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace meltpool {

/// Writes into a buffer that must be large enough.
class ByteWriter {
  public:
    explicit ByteWriter(char* room) : next_(room) {}

    void u32(std::uint32_t value) { put(value, 4); }
    void u64(std::uint64_t value) { put(value, 8); }
    void f32(float value) { u32(std::bit_cast<std::uint32_t>(value)); }
    void f64(double value) { u64(std::bit_cast<std::uint64_t>(value)); }

  private:
    void put(std::uint64_t value, int bytes) {
        for (int i = 0; i < bytes; ++i)
            *next_++ = static_cast<char>(value >> (8 * i) & 0xFF);
    }

    char* next_;
};

/// Reads from a buffer that must be long enough; see left().
class ByteReader {
  public:
    explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

    std::size_t left() const { return rest_.size(); }
    std::uint32_t u32() { return static_cast<std::uint32_t>(take(4)); }
    std::uint64_t u64() { return take(8); }
    float f32() { return std::bit_cast<float>(u32()); }
    double f64() { return std::bit_cast<double>(u64()); }
    /// The unread bytes.
    std::string_view rest() const { return rest_; }

  private:
    std::uint64_t take(std::size_t bytes) {
        std::uint64_t value = 0;
        for (std::size_t i = bytes; i-- > 0;)
            value = value << 8 | static_cast<unsigned char>(rest_[i]);
        rest_.remove_prefix(bytes);
        return value;
    }

    std::string_view rest_;
};

} // namespace meltpool
