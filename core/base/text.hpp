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

/// The number that the whole text spells, or nothing. Accepts the forms of C++ from_chars and a leading '+'.
std::optional<double> parseDouble(std::string_view text);
std::optional<long long> parseInteger(std::string_view text);

/// The shortest text that reads back to the same value.
std::string formatNumber(float value);
std::string formatNumber(double value);
/// Appends formatNumber()'s text; allocates nothing if the capacity of `text` suffices.
void appendNumber(std::string& text, float value);
void appendNumber(std::string& text, double value);
void appendNumber(std::string& text, std::uint64_t value);
/// 64 bits as 16 hexadecimal digits: JSON readers store only 53 bits of a number.
std::string formatHexadecimal(std::uint64_t value);

/// "2026-11-23 08:30", in the user's time zone.
std::string formatDate(std::chrono::system_clock::time_point moment);

/// `text` made safe for a terminal, in at most about `mostBytes`: escapes control characters, bytes that are not UTF-8
/// and characters that turn the direction of writing; replaces ends of line by blanks, and leaves out the middle of a
/// longer text. Applying it twice changes nothing more.
std::string printable(std::string_view text, std::size_t mostBytes);

/// A user's text for messages: printable(), short, in single quotes.
std::string quote(std::string_view text);

/// The parts between separators; an empty text gives one empty part. The views point into `text`.
std::vector<std::string_view> splitText(std::string_view text, char separator);
std::string_view trimText(std::string_view text);
/// The text with the letters A to Z in lower case.
std::string lowerCase(std::string_view text);
/// The text with an initial capital: for a to z and the small letters of Latin-1, in UTF-8.
std::string capitalised(std::string_view text);
/// The ending of a file's name in lower case, such as ".csv"; empty if it has none.
std::string lowerExtension(const std::filesystem::path& file);

/// A limit above any file that the program reads: three hours of a torch recording.
inline constexpr std::size_t kLargestTextFile = std::size_t(256) << 20;

/// Reads the whole file, also from pipes and devices. Throws InputError if it cannot be read to its end, or has more
/// than `mostBytes`; then only these are read.
std::string readTextFile(const std::filesystem::path& file, std::size_t mostBytes = kLargestTextFile);

/// Writes a text with writeFile().
void writeTextFileAtomically(const std::filesystem::path& file, std::string_view text);

} // namespace meltpool
