#include "core/base/last_facts.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <mutex>

namespace meltpool {

namespace {

constexpr std::size_t kBytes = 128;

std::array<std::array<char, kBytes>, static_cast<std::size_t>(LastFact::count)> facts{};
std::mutex writing; ///< serialises writers; a reader takes the present bytes, even half of a new text

} // namespace

void noteFact(LastFact kind, std::string_view text) {
    const std::lock_guard lock(writing);
    auto& fact = facts[static_cast<std::size_t>(kind)];
    const std::size_t bytes = std::min(text.size(), kBytes - 1);
    std::copy_n(text.begin(), bytes, fact.begin());
    std::fill(fact.begin() + static_cast<std::ptrdiff_t>(bytes), fact.end(), '\0');
}

const char* lastFact(LastFact kind) {
    const auto& fact = facts[static_cast<std::size_t>(kind)];
    return fact.front() == '\0' ? "none yet" : fact.data();
}

} // namespace meltpool
