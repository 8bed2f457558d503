// A helper that crashes a running program: test_crash.exe TITLE starts a thread at an address without code, in the
// process of the visible window whose title begins with TITLE, and prints the process's number.
#include <windows.h>

#include <array>
#include <cstdio>
#include <string>

namespace {

struct Search {
    std::string title;
    DWORD process = 0;
};

BOOL CALLBACK look(HWND window, LPARAM given) {
    auto& search = *reinterpret_cast<Search*>(given);
    std::array<char, 256> title{};
    GetWindowTextA(window, title.data(), static_cast<int>(title.size()));
    if (IsWindowVisible(window) == FALSE || std::string(title.data()).rfind(search.title, 0) != 0) return TRUE;
    GetWindowThreadProcessId(window, &search.process);
    return FALSE;
}

} // namespace

int main(int count, char** words) {
    if (count != 2) return 100;
    Search search{words[1]};
    EnumWindows(look, reinterpret_cast<LPARAM>(&search));
    if (search.process == 0) return 102;
    std::printf("%lu\n", search.process);
    const HANDLE process = OpenProcess(PROCESS_ALL_ACCESS, FALSE, search.process);
    if (process == nullptr) return 103;
    const auto nowhere = reinterpret_cast<LPTHREAD_START_ROUTINE>(16);
    return CreateRemoteThread(process, nullptr, 0, nowhere, nullptr, 0, nullptr) != nullptr ? 0 : 101;
}
