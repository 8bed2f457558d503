#include "core/base/text_encoding.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace meltpool {

namespace {

constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";
constexpr std::uint32_t kReplacement = 0xFFFD;

/// Windows-1252 from 0x80 to 0x9F; elsewhere its bytes are the codes of Unicode. Five bytes have no character.
constexpr std::array<std::uint16_t, 32> kWindows{0x20AC, 0xFFFD, 0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,
                                                 0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0xFFFD, 0x017D, 0xFFFD,
                                                 0xFFFD, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
                                                 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0xFFFD, 0x017E, 0x0178};

std::uint32_t byteAt(std::string_view text, size_t at) {
    return static_cast<unsigned char>(text[at]);
}

void append(std::string& text, std::uint32_t code) {
    const auto put = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
    if (code < 0x80) return put(code);
    if (code < 0x800) {
        put(0xC0 | code >> 6);
    } else {
        if (code < 0x10000) {
            put(0xE0 | code >> 12);
        } else {
            put(0xF0 | code >> 18);
            put(0x80 | (code >> 12 & 0x3F));
        }
        put(0x80 | (code >> 6 & 0x3F));
    }
    put(0x80 | (code & 0x3F));
}

/// Bytes of the UTF-8 character at `at`; 0 if none begins there. RFC 3629: refuses overlong forms, UTF-16 surrogates
/// and codes beyond U+10FFFF.
size_t characterLength(std::string_view text, size_t at) {
    const std::uint32_t lead = byteAt(text, at);
    if (lead < 0x80) return 1;
    const size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || text.size() - at < bytes) return 0;
    for (size_t i = 1; i < bytes; ++i)
        if ((byteAt(text, at + i) & 0xC0) != 0x80) return 0;
    const std::uint32_t second = byteAt(text, at + 1);
    const bool longer = (lead == 0xE0 && second < 0xA0) || (lead == 0xF0 && second < 0x90);
    const bool beyond = (lead == 0xED && second >= 0xA0) || (lead == 0xF4 && second >= 0x90);
    return longer || beyond ? 0 : bytes;
}

std::string fromUtf16(std::string_view bytes, bool little) {
    std::string text;
    text.reserve(bytes.size() / 2);
    const auto unit = [&](size_t at) {
        return little ? byteAt(bytes, at) | byteAt(bytes, at + 1) << 8 : byteAt(bytes, at) << 8 | byteAt(bytes, at + 1);
    };
    for (size_t at = 0; at < bytes.size(); at += 2) {
        const std::uint32_t code = unit(at);
        const bool half = code >= 0xD800 && code < 0xE000;
        const std::uint32_t next = half && code < 0xDC00 && at + 2 < bytes.size() ? unit(at + 2) : 0;
        if (half && next >= 0xDC00 && next < 0xE000) {
            append(text, 0x10000 + ((code & 0x3FF) << 10 | (next & 0x3FF)));
            at += 2;
        } else {
            append(text, half ? kReplacement : code);
        }
    }
    return text;
}

std::string fromWindows(std::string_view bytes) {
    std::string text;
    text.reserve(bytes.size() + bytes.size() / 16);
    for (size_t i = 0; i < bytes.size(); ++i) {
        const std::uint32_t byte = byteAt(bytes, i);
        append(text, byte >= 0x80 && byte < 0xA0 ? kWindows[byte - 0x80] : byte);
    }
    return text;
}

/// True if every second byte is 0, as in Western languages in UTF-16.
bool looksLikeUtf16(std::string_view bytes) {
    const std::string_view start = bytes.substr(0, 64);
    return bytes.size() >= 4 && static_cast<size_t>(std::count(start.begin(), start.end(), '\0')) * 3 > start.size();
}

} // namespace

std::string_view encodingName(TextEncoding encoding) {
    switch (encoding) {
    case TextEncoding::utf8Marked:
        return "UTF-8 with a mark";
    case TextEncoding::utf16:
        return "UTF-16";
    case TextEncoding::windows1252:
        return "Windows-1252";
    default:
        return "UTF-8";
    }
}

size_t utf8Length(std::string_view text) {
    size_t at = 0;
    while (at < text.size()) {
        const size_t length = characterLength(text, at);
        if (length == 0) break;
        at += length;
    }
    return at;
}

DecodedText decodeText(std::string bytes, const std::filesystem::path& file) {
    const std::string_view all = bytes;
    if (all.starts_with(std::string_view("\xFF\xFE\0\0", 4)) || all.starts_with(std::string_view("\0\0\xFE\xFF", 4)))
        throw InputError(file, 0, "is UTF-32; expected UTF-8, or UTF-16 with a byte order mark");
    const bool little = all.starts_with("\xFF\xFE");
    if (little || all.starts_with("\xFE\xFF")) {
        if (all.size() % 2 != 0)
            throw InputError(file, 0, "is UTF-16 and ends with half a character; expected an even number of bytes");
        return {fromUtf16(all.substr(2), little), TextEncoding::utf16};
    }
    if (all.starts_with(kUtf8Mark)) {
        bytes.erase(0, kUtf8Mark.size());
        return {std::move(bytes), TextEncoding::utf8Marked};
    }
    if (looksLikeUtf16(all))
        throw InputError(file, 0,
                         "looks like UTF-16 without a byte order mark; expected UTF-8, or UTF-16 with that mark");
    if (utf8Length(all) < all.size()) return {fromWindows(all), TextEncoding::windows1252};
    return {std::move(bytes), TextEncoding::utf8};
}

} // namespace meltpool
