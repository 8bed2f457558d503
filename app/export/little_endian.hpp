// Numbers as bytes, lowest first, independent of the machine's own order.
#pragma once

#include <glm/vec3.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>

namespace meltpool {

/// Appends the lowest `count` bytes of a number.
inline void appendBytes(std::string& bytes, std::uint32_t value, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        bytes += static_cast<char>(value >> 8 * i & 255U);
}

inline void appendFloats(std::string& bytes, const glm::vec3& v) {
    for (int axis = 0; axis < 3; ++axis)
        appendBytes(bytes, std::bit_cast<std::uint32_t>(v[axis]), 4);
}

/// Share of 0 to 1, clamped and rounded, as a whole number from 0 to `most`; 0 for NaN.
inline std::uint32_t shareOf(float share, float most) {
    if (!(share > 0)) return 0;
    return static_cast<std::uint32_t>(share < 1 ? share * most + 0.5F : most);
}

} // namespace meltpool
