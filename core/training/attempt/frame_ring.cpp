#include "core/training/attempt/frame_ring.hpp"

#include "core/training/attempt/little_endian.hpp"

#include <algorithm>
#include <array>
#include <cstring>

namespace meltpool {

void FrameRing::write(size_t at, const char* bytes, size_t count) {
    const size_t begin = at % ring_.size();
    const size_t first = std::min(count, ring_.size() - begin);
    std::memcpy(ring_.data() + begin, bytes, first);
    if (count > first) std::memcpy(ring_.data(), bytes + first, count - first);
}

void FrameRing::read(size_t at, char* bytes, size_t count) const {
    const size_t begin = at % ring_.size();
    const size_t first = std::min(count, ring_.size() - begin);
    std::memcpy(bytes, ring_.data() + begin, first);
    if (count > first) std::memcpy(bytes + first, ring_.data(), count - first);
}

bool FrameRing::put(std::uint32_t kind, std::initializer_list<std::string_view> parts) {
    size_t length = 0;
    for (const std::string_view part : parts)
        length += part.size();
    size_t at = put_.load(std::memory_order_relaxed);
    if (kHeadBytes + length > ring_.size() - (at - taken_.load(std::memory_order_acquire))) return false;
    std::array<char, kHeadBytes> head{};
    ByteWriter writer(head.data());
    writer.u32(kind);
    writer.u32(static_cast<std::uint32_t>(length));
    write(at, head.data(), head.size());
    at += head.size();
    for (const std::string_view part : parts) {
        if (!part.empty()) write(at, part.data(), part.size());
        at += part.size();
    }
    put_.store(at, std::memory_order_release);
    return true;
}

bool FrameRing::take(std::uint32_t& kind, std::string& content) {
    size_t at = taken_.load(std::memory_order_relaxed);
    if (at == put_.load(std::memory_order_acquire)) return false;
    std::array<char, kHeadBytes> head{};
    read(at, head.data(), head.size());
    ByteReader reader({head.data(), head.size()});
    kind = reader.u32();
    content.resize(reader.u32());
    at += head.size();
    read(at, content.data(), content.size());
    taken_.store(at + content.size(), std::memory_order_release);
    return true;
}

} // namespace meltpool
