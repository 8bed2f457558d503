// Decodes the bytes of text files from other programs.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace meltpool {

enum class TextEncoding { utf8, utf8Marked, utf16, windows1252 };

/// "UTF-8", "UTF-8 with a mark", "UTF-16" or "Windows-1252", for messages and results.
std::string_view encodingName(TextEncoding encoding);

struct DecodedText {
    std::string text; ///< UTF-8 without a mark
    TextEncoding encoding = TextEncoding::utf8;
};

/// Bytes at the beginning of `text` that are whole UTF-8 characters: all of them for UTF-8 text.
std::size_t utf8Length(std::string_view text);

/// The text of a file's bytes. A mark (U+FEFF) at the beginning identifies UTF-8 and UTF-16 of either byte order;
/// without one, bytes that are not UTF-8 are Windows-1252, which includes Latin-1. Halves of UTF-16 pairs become
/// U+FFFD. Throws InputError, naming `file`, for UTF-32, for UTF-16 without a mark or with half a character at its end.
DecodedText decodeText(std::string bytes, const std::filesystem::path& file);

} // namespace meltpool
