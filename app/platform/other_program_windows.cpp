#include "app/platform/other_program.hpp"

#include "core/base/wide_text.hpp"

#include <windows.h>

#include <array>
#include <vector>

namespace meltpool {

namespace {

/// Word of a command line, quoted so that the program's own splitting restores it: with the backslashes before
/// quotation marks doubled.
std::wstring quoted(const std::wstring& word) {
    std::wstring out = L"\"";
    size_t backslashes = 0;
    for (const wchar_t c : word) {
        if (c == L'\\') {
            ++backslashes;
            continue;
        }
        out.append(c == L'"' ? 2 * backslashes + 1 : backslashes, L'\\');
        out += c;
        backslashes = 0;
    }
    return out.append(2 * backslashes, L'\\') + L"\"";
}

} // namespace

std::filesystem::path findProgram(const std::string& name) {
    std::vector<wchar_t> path(32768);
    if (GetEnvironmentVariableW(L"PATH", path.data(), static_cast<DWORD>(path.size())) == 0) return {};
    // PATH alone: without it the search begins in the program's and the current folder.
    std::array<wchar_t, 4096> found{};
    const DWORD length = SearchPathW(path.data(), toWide(name).c_str(), L".exe", static_cast<DWORD>(found.size()),
                                     found.data(), nullptr);
    return length == 0 || length >= found.size() ? std::filesystem::path() : std::filesystem::path(found.data());
}

int runToItsEnd(const std::filesystem::path& program, std::span<const std::string> words) {
    std::wstring line = quoted(program.wstring());
    for (const std::string& word : words)
        line += L" " + quoted(toWide(word));
    STARTUPINFOW start{};
    start.cb = sizeof start;
    PROCESS_INFORMATION process{};
    if (CreateProcessW(program.c_str(), line.data(), nullptr, nullptr, FALSE, 0, nullptr, nullptr, &start, &process) ==
        0)
        return -1;
    CloseHandle(process.hThread);
    WaitForSingleObject(process.hProcess, INFINITE);
    DWORD code = 1;
    const bool known = GetExitCodeProcess(process.hProcess, &code) != 0;
    CloseHandle(process.hProcess);
    return known ? static_cast<int>(code) : -1;
}

} // namespace meltpool
