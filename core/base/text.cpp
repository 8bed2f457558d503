#include "core/base/text.hpp"

#include "core/base/error.hpp"
#include "core/base/output_file.hpp"

#include <array>
#include <charconv>
#include <fstream>
#include <sstream>
#include <system_error>

namespace meltpool {

namespace {

template <class Number>
std::optional<Number> parseWhole(std::string_view text) {
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    Number value{};
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc{} || result.ptr != text.data() + text.size()) return std::nullopt;
    return value;
}

template <class Number>
void appendShortest(std::string& text, Number value) {
    std::array<char, 64> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    text.append(buffer.data(), result.ptr);
}

template <class Number>
std::string formatShortest(Number value) {
    std::string text;
    appendShortest(text, value);
    return text;
}

} // namespace

std::optional<double> parseDouble(std::string_view text) {
    return parseWhole<double>(text);
}
std::optional<long long> parseInteger(std::string_view text) {
    return parseWhole<long long>(text);
}
std::string formatNumber(float value) {
    return formatShortest(value);
}
std::string formatNumber(double value) {
    return formatShortest(value);
}

void appendNumber(std::string& text, float value) {
    appendShortest(text, value);
}
void appendNumber(std::string& text, double value) {
    appendShortest(text, value);
}
void appendNumber(std::string& text, std::uint64_t value) {
    appendShortest(text, value);
}

std::string formatHexadecimal(std::uint64_t value) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text;
    for (int shift = 60; shift >= 0; shift -= 4)
        text += kDigits[(value >> shift) & 15U];
    return text;
}

std::vector<std::string_view> splitText(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    size_t start = 0;
    for (size_t end; (end = text.find(separator, start)) != std::string_view::npos; start = end + 1)
        parts.push_back(text.substr(start, end - start));
    parts.push_back(text.substr(start));
    return parts;
}

std::string_view trimText(std::string_view text) {
    constexpr std::string_view kBlank = " \t\r\n";
    const size_t first = text.find_first_not_of(kBlank);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::string readTextFile(const std::filesystem::path& file) {
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored))
        throw InputError(file, 0, "this is a folder; expected a readable file");
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw InputError(file, 0, "cannot be opened; expected a readable file");
    std::ostringstream text;
    text << stream.rdbuf();
    if (stream.bad()) throw InputError(file, 0, "cannot be read to its end");
    return std::move(text).str();
}

void writeTextFileAtomically(const std::filesystem::path& file, std::string_view text) {
    writeFile(file, text);
}

} // namespace meltpool
