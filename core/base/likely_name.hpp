// The name that a user probably meant by one that does not exist.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

/// The fewest letters to insert, remove, change or exchange with their neighbour that turn `a` into `b`: the optimal
/// string alignment distance (Damerau 1964), over bytes.
std::size_t editDistance(std::string_view a, std::string_view b);

/// The known name that `given` misspells, ignoring case: at most one letter in three is wrong, and no other name is as
/// near. Otherwise the only known name that begins with `given`. Empty if there is none.
std::string likelyName(std::string_view given, std::span<const std::string> known);

/// The middle of a refusal: "; did you mean 'speed'? Expected one of speed, count"; without a suggestion from
/// likelyName(): "; expected one of speed, count". `introduction`: the small words before the list.
std::string expectedNames(std::string_view given, std::span<const std::string> known,
                          std::string_view introduction = "expected one of ");

} // namespace meltpool
