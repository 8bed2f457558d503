// A helper that presses Ctrl-C in a program's console: test_interrupt.exe FILE BYTES PROGRAM WORD... starts the
// program, waits until the file has that many bytes, and returns the program's exit code, or 100 and more if Ctrl-C
// fails.
#include <windows.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

int main(int count, char** words) {
    if (count < 4) return 100;
    const HANDLE input = GetStdHandle(STD_INPUT_HANDLE), output = GetStdHandle(STD_OUTPUT_HANDLE),
                 error = GetStdHandle(STD_ERROR_HANDLE);
    FreeConsole(); // a shell without a terminal gives its child a console without keys
    if (AllocConsole() == FALSE) return 105;
    std::string line;
    for (int i = 3; i < count; ++i)
        line += (i > 3 ? " \"" : "\"") + std::string(words[i]) + "\"";
    STARTUPINFOA start{};
    start.cb = sizeof start;
    start.dwFlags = STARTF_USESTDHANDLES;
    start.hStdInput = input; // other handles than the new console's
    start.hStdOutput = output;
    start.hStdError = error;
    PROCESS_INFORMATION process{};
    if (CreateProcessA(nullptr, line.data(), nullptr, nullptr, TRUE, 0, nullptr, nullptr, &start, &process) == FALSE)
        return 101;
    const auto wanted = static_cast<std::uintmax_t>(std::atoll(words[2]));
    std::error_code missing;
    for (int tries = 0; tries < 6000; ++tries) {
        const std::uintmax_t bytes = std::filesystem::file_size(words[1], missing);
        if (!missing && bytes >= wanted) break;
        if (WaitForSingleObject(process.hProcess, 50) == WAIT_OBJECT_0) return 102; // the program ended by itself
    }
    SetConsoleCtrlHandler(nullptr, TRUE); // this program must survive Ctrl-C
    if (GenerateConsoleCtrlEvent(CTRL_C_EVENT, 0) == FALSE) {
        TerminateProcess(process.hProcess, 103);
        return 103;
    }
    if (WaitForSingleObject(process.hProcess, 120'000) != WAIT_OBJECT_0) {
        TerminateProcess(process.hProcess, 104);
        return 104;
    }
    DWORD code = 0;
    GetExitCodeProcess(process.hProcess, &code);
    return static_cast<int>(code);
}
