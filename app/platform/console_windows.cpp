#include "app/platform/console_windows.hpp"

#include "core/base/wide_text.hpp"

#include <windows.h>

#include <shellapi.h>

namespace meltpool {

namespace {

constexpr DWORD kCursorSigns = 0x0004; // ENABLE_VIRTUAL_TERMINAL_PROCESSING, which older headers lack

} // namespace

Utf8Console::Utf8Console() : codePage_(GetConsoleOutputCP()) {
    SetConsoleOutputCP(CP_UTF8);
    const HANDLE error = GetStdHandle(STD_ERROR_HANDLE);
    errorIsConsole_ = GetConsoleMode(error, &errorMode_) != FALSE;
    if (errorIsConsole_) SetConsoleMode(error, errorMode_ | kCursorSigns);
}

Utf8Console::~Utf8Console() {
    // The next program in this console expects the old settings.
    if (errorIsConsole_) SetConsoleMode(GetStdHandle(STD_ERROR_HANDLE), errorMode_);
    if (codePage_ != 0) SetConsoleOutputCP(codePage_);
}

std::vector<std::string> commandLineWords() {
    int count = 0;
    wchar_t** wide = CommandLineToArgvW(GetCommandLineW(), &count);
    std::vector<std::string> words;
    for (int i = 0; wide != nullptr && i < count; ++i)
        words.push_back(fromWide(wide[i]));
    LocalFree(wide);
    return words;
}

} // namespace meltpool
