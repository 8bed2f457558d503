// The launcher: starts the trainer from the start menu or for a lesson file, without a console, and shows its error
// messages.
#include <windows.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace {

std::filesystem::path programFile() {
    std::vector<wchar_t> name(32768); // the longest possible path
    GetModuleFileNameW(nullptr, name.data(), static_cast<DWORD>(name.size()));
    return std::filesystem::path(name.data()).parent_path() / "meltpool.exe";
}

/// Command line after the launcher's own name.
std::wstring givenWords() {
    const wchar_t* rest = GetCommandLineW();
    bool quoted = false;
    for (; *rest != L'\0' && (quoted || *rest != L' '); ++rest)
        if (*rest == L'"') quoted = !quoted;
    return rest;
}

/// Both ends of a pipe; the program inherits the write end.
struct Pipe {
    HANDLE read = nullptr, write = nullptr;

    Pipe() {
        SECURITY_ATTRIBUTES inherited{sizeof(SECURITY_ATTRIBUTES), nullptr, TRUE};
        CreatePipe(&read, &write, &inherited, 0);
        SetHandleInformation(read, HANDLE_FLAG_INHERIT, 0);
    }
};

/// Text that the program writes until its end; only the last part of a long one.
std::string readToEnd(HANDLE pipe) {
    constexpr size_t kMost = 2000;
    std::string said;
    std::array<char, 4096> part{};
    DWORD bytes = 0;
    while (ReadFile(pipe, part.data(), static_cast<DWORD>(part.size()), &bytes, nullptr) != FALSE && bytes > 0) {
        said.append(part.data(), bytes);
        if (said.size() > kMost) said.erase(0, said.size() - kMost);
    }
    return said;
}

void show(const std::string& text) {
    std::wstring wide(static_cast<size_t>(MultiByteToWideChar(CP_UTF8, 0, text.c_str(), -1, nullptr, 0)), L'\0');
    MultiByteToWideChar(CP_UTF8, 0, text.c_str(), -1, wide.data(), static_cast<int>(wide.size()));
    MessageBoxW(nullptr, wide.c_str(), L"Meltpool", MB_OK | MB_ICONERROR);
}

} // namespace

int WINAPI WinMain(HINSTANCE, HINSTANCE, char*, int) {
    const std::filesystem::path program = programFile();
    std::wstring words = L"\"" + program.wstring() + L"\"" + givenWords();
    Pipe errors;
    STARTUPINFOW start{};
    start.cb = sizeof start;
    start.dwFlags = STARTF_USESTDHANDLES;
    start.hStdOutput = errors.write;
    start.hStdError = errors.write;
    PROCESS_INFORMATION process{};
    if (CreateProcessW(program.c_str(), words.data(), nullptr, nullptr, TRUE, CREATE_NO_WINDOW, nullptr, nullptr,
                       &start, &process) == FALSE) {
        show("meltpool.exe is not beside this program; please install Meltpool again.");
        return 1;
    }
    CloseHandle(errors.write);
    const std::string said = readToEnd(errors.read);
    WaitForSingleObject(process.hProcess, INFINITE);
    DWORD code = 0;
    GetExitCodeProcess(process.hProcess, &code);
    if (code != 0) show(said.empty() ? "Meltpool ended with the code " + std::to_string(code) + "." : said);
    return static_cast<int>(code);
}
