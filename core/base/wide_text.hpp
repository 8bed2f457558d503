// Conversions between UTF-16, the encoding of Windows, and UTF-8, that of the program.
#pragma once

#include <string>
#include <string_view>

namespace meltpool {

std::wstring toWide(std::string_view text);
/// UTF-8 of a UTF-16 text; halves of pairs become U+FFFD.
std::string fromWide(std::wstring_view text);

} // namespace meltpool
