// Numbers as text, independent of the user's locale, and text files.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

/// The number that the whole text spells, or nothing. Accepts what C++ from_chars accepts and a leading '+'.
std::optional<double> parseDouble(std::string_view text);
std::optional<long long> parseInteger(std::string_view text);

/// Shortest text that reads back to the same value.
std::string formatNumber(float value);
std::string formatNumber(double value);
/// Appends that text; allocates nothing when the capacity of `text` suffices.
void appendNumber(std::string& text, float value);
void appendNumber(std::string& text, double value);
void appendNumber(std::string& text, std::uint64_t value);
/// 64 bits as 16 hexadecimal digits: JSON readers keep only 53 bits of a number.
std::string formatHexadecimal(std::uint64_t value);

/// "2026-11-23 08:30", in the user's time zone.
std::string formatDate(std::chrono::system_clock::time_point moment);

/// `text` as a terminal may show it, in at most about `mostBytes`: control characters, bytes that are no UTF-8 and
/// characters that turn the direction of writing are escaped, ends of line are blanks, and the middle of a longer text
/// is left out. A text that has been through this comes out unchanged.
std::string printable(std::string_view text, std::size_t mostBytes);

/// What a person wrote, for messages: printable(), short, in single quotes.
std::string quote(std::string_view text);

/// Parts between separators; an empty text gives one empty part. The views point into `text`.
std::vector<std::string_view> splitText(std::string_view text, char separator);
std::string_view trimText(std::string_view text);
/// With the letters A to Z made small.
std::string lowerCase(std::string_view text);
/// With a capital at the beginning: a to z and the small letters of Latin-1, in UTF-8.
std::string capitalised(std::string_view text);
/// The ending of a file's name in small letters, such as ".csv"; empty where it has none.
std::string lowerExtension(const std::filesystem::path& file);

/// More than any file that the program reads should have: three hours of a torch recording.
inline constexpr std::size_t kLargestTextFile = std::size_t(256) << 20;

/// The whole file, pipes and devices too. Throws InputError when it cannot be read to its end, or has more than
/// `mostBytes`, which are all that is read of it.
std::string readTextFile(const std::filesystem::path& file, std::size_t mostBytes = kLargestTextFile);

/// writeFile() of a text.
void writeTextFileAtomically(const std::filesystem::path& file, std::string_view text);

} // namespace meltpool
