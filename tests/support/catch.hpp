// Provides Catch2, version 2 or 3, under one name.
#pragma once

#include <string>

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
namespace meltpool::test {
inline auto containsText(const std::string& text) {
    return Catch::Matchers::ContainsSubstring(text);
}
} // namespace meltpool::test
#else
#include <catch2/catch.hpp>
namespace meltpool::test {
inline auto containsText(const std::string& text) {
    return Catch::Matchers::Contains(text);
}
} // namespace meltpool::test
#endif
