// Windows' own texts are UTF-16, the program's are UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace meltpool {

std::wstring toWide(std::string_view text);
/// Halves of UTF-16 pairs become U+FFFD.
std::string fromWide(std::wstring_view text);

} // namespace meltpool
