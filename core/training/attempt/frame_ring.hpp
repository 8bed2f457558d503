// Passes frames from the thread that welds to the thread that writes.
#pragma once

#include <atomic>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

/// A ring buffer of fixed size. One thread puts, another takes; neither waits for the other, and put() neither
/// allocates nor calls the system.
class FrameRing {
  public:
    explicit FrameRing(size_t bytes) : ring_(bytes) {}

    /// Puts a frame of this kind; its content is all parts in order. False if the ring has no room for it.
    bool put(std::uint32_t kind, std::initializer_list<std::string_view> parts);
    /// Takes the oldest frame; false if the ring is empty.
    bool take(std::uint32_t& kind, std::string& content);

  private:
    static constexpr size_t kHeadBytes = 8; ///< bytes of kind and length

    void write(size_t at, const char* bytes, size_t count);
    void read(size_t at, char* bytes, size_t count) const;

    std::vector<char> ring_;
    std::atomic<size_t> put_{0};   ///< bytes ever put
    std::atomic<size_t> taken_{0}; ///< bytes ever taken
};

} // namespace meltpool
