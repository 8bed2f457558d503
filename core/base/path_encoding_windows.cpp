// GCC's library for Windows converts texts to paths with the C library's mbrtowc(), which knows no UTF-8 there. The
// linker replaces it by this function (--wrap=mbrtowc, CMakeLists.txt), so that paths are made from UTF-8.
#ifdef __MINGW32__

#include <cstddef>
#include <cwchar>

extern "C" std::size_t __wrap_mbrtowc(wchar_t* to, const char* from, std::size_t bytes, std::mbstate_t*);

/// Decodes UTF-8; refuses characters beyond U+FFFF, which need two of Windows' units, like invalid bytes.
extern "C" std::size_t __wrap_mbrtowc(wchar_t* to, const char* from, std::size_t bytes, std::mbstate_t*) {
    constexpr auto kRefused = static_cast<std::size_t>(-1), kTooShort = static_cast<std::size_t>(-2);
    if (from == nullptr) return 0;
    if (bytes == 0) return kTooShort;
    const auto byte = [from](std::size_t at) { return static_cast<unsigned>(static_cast<unsigned char>(from[at])); };
    const unsigned lead = byte(0);
    const std::size_t length = lead < 0x80 ? 1 : lead < 0xC2 ? 0 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 0;
    if (length == 0) return kRefused;
    if (bytes < length) return kTooShort;
    unsigned code = length == 1 ? lead : lead & (0xFFu >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0) != 0x80) return kRefused;
        code = code << 6 | (byte(i) & 0x3F);
    }
    if (to != nullptr) *to = static_cast<wchar_t>(code);
    return code == 0 ? 0 : length;
}

#endif
