#include "core/base/text.hpp"

#include "core/base/error.hpp"
#include "core/base/files.hpp"
#include "core/base/output_file.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <memory>
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

/// The first character of a text. Bytes that are not UTF-8 are characters of one byte without a code.
struct Character {
    size_t bytes = 1;
    std::optional<std::uint32_t> code;
};

/// Decodes by RFC 3629: refuses overlong forms, UTF-16 surrogates and codes beyond U+10FFFF.
Character characterAt(std::string_view text) {
    const auto byte = [text](size_t at) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[at])); };
    const std::uint32_t lead = byte(0);
    if (lead < 0x80) return {1, lead};
    const size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || text.size() < bytes) return {};
    std::uint32_t code = lead & (0xFFu >> (bytes + 1));
    for (size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xC0) != 0x80) return {};
        code = code << 6 | (byte(i) & 0x3F);
    }
    constexpr std::array<std::uint32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};
    const bool half = code >= 0xD800 && code <= 0xDFFF;
    if (code < kLeast[bytes] || code > 0x10FFFF || half) return {};
    return {bytes, code};
}

/// True for characters that move or hide others on a terminal.
bool isControl(std::uint32_t code) {
    const bool direction = code == 0x200E || code == 0x200F || (code >= 0x202A && code <= 0x202E) ||
                           (code >= 0x2066 && code <= 0x2069) || code == 0x061C;
    return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x2028 || code == 0x2029 || direction;
}

/// A character, or its bytes as \xNN.
std::string shown(std::string_view bytes, std::optional<std::uint32_t> code) {
    if (code && (*code == '\n' || *code == '\t' || *code == '\r')) return " ";
    if (code && !isControl(*code)) return std::string(bytes);
    std::string escaped;
    for (const char c : bytes) {
        std::array<char, 8> text{};
        std::snprintf(text.data(), text.size(), "\\x%02x", static_cast<unsigned>(static_cast<unsigned char>(c)));
        escaped += text.data();
    }
    return escaped;
}

constexpr std::string_view kLeftOut = " \xE2\x80\xA6 "; // an ellipsis

std::string joined(const std::vector<std::string>& parts, size_t from, size_t to) {
    std::string text;
    for (size_t i = from; i < to; ++i)
        text += parts[i];
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

std::string formatDate(std::chrono::system_clock::time_point moment) {
    const std::time_t seconds = std::chrono::system_clock::to_time_t(moment);
    char text[32];
    const std::tm* local = std::localtime(&seconds);
    return local != nullptr && std::strftime(text, sizeof text, "%Y-%m-%d %H:%M", local) > 0 ? text : std::string();
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

std::string lowerCase(std::string_view text) {
    std::string lower(text);
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return lower;
}

std::string capitalised(std::string_view text) {
    std::string whole(text);
    const auto byte = [&](size_t i) { return i < whole.size() ? static_cast<unsigned char>(whole[i]) : 0U; };
    if (byte(0) >= 'a' && byte(0) <= 'z') {
        whole[0] = static_cast<char>(whole[0] - 'a' + 'A');
    } else if (byte(0) == 0xC3 && byte(1) >= 0xA0 && byte(1) <= 0xBE && byte(1) != 0xB7) { // U+00E0 to U+00FE
        whole[1] = static_cast<char>(byte(1) - 0x20);
    }
    return whole;
}

std::string lowerExtension(const std::filesystem::path& file) {
    return lowerCase(file.extension().string());
}

std::string printable(std::string_view text, std::size_t mostBytes) {
    std::vector<std::string> characters;
    for (size_t at = 0; at < text.size();) {
        const Character next = characterAt(text.substr(at));
        characters.push_back(shown(text.substr(at, next.bytes), next.code));
        at += next.bytes;
        // A long text shows only its two ends.
        if (characters.size() > 2 * mostBytes && at + mostBytes < text.size()) {
            characters.resize(mostBytes);
            at = text.size() - mostBytes;
        }
    }
    size_t bytes = 0;
    for (const std::string& character : characters)
        bytes += character.size();
    if (bytes <= mostBytes) return joined(characters, 0, characters.size());
    const size_t room = mostBytes - std::min(mostBytes, kLeftOut.size());
    size_t first = 0, last = characters.size();
    for (size_t used = 0; first < last && (used += characters[first].size()) <= room * 3 / 4;)
        ++first;
    for (size_t used = 0; last > first && (used += characters[last - 1].size()) <= room / 4;)
        --last;
    return joined(characters, 0, first) + std::string(kLeftOut) + joined(characters, last, characters.size());
}

std::string quote(std::string_view text) {
    constexpr size_t kMostBytes = 60;
    return "'" + printable(text, kMostBytes) + "'";
}

std::string readTextFile(const std::filesystem::path& file, std::size_t mostBytes) {
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored))
        throw InputError(file, 0, "this is a folder; expected a readable file");
    const auto close = [](std::FILE* open) { std::fclose(open); };
    const std::unique_ptr<std::FILE, decltype(close)> stream(openFile(file, "rb"), close);
    if (!stream) throw InputError(file, 0, "cannot be opened; expected a readable file");
    std::string text;
    std::array<char, 65536> part{};
    while (const size_t count = std::fread(part.data(), 1, part.size(), stream.get())) {
        if (text.size() + count > mostBytes)
            throw InputError(file, 0,
                             "is too long; expected a file of at most " + std::to_string(mostBytes >> 10) + " KiB");
        text.append(part.data(), count);
    }
    if (std::ferror(stream.get()) != 0)
        throw InputError(
            file, 0, std::string("cannot be read to its end: ") + std::strerror(errno) + "; expected a readable file");
    return text;
}

void writeTextFileAtomically(const std::filesystem::path& file, std::string_view text) {
    writeFile(file, text);
}

} // namespace meltpool
