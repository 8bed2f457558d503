// Makes a running program crash: test_crash.exe NAME starts a thread in the newest process of that file name at an
// address where there is no code.
#include <windows.h>

#include <tlhelp32.h>

#include <string>

int main(int count, char** words) {
    if (count != 2) return 100;
    const HANDLE list = CreateToolhelp32Snapshot(TH32CS_SNAPPROCESS, 0);
    const std::string name = words[1];
    const std::wstring wanted(name.begin(), name.end());
    PROCESSENTRY32W entry{};
    entry.dwSize = sizeof entry;
    HANDLE newest = nullptr; // an ended one may still be listed
    ULONGLONG newestTime = 0;
    for (BOOL more = Process32FirstW(list, &entry); more != FALSE; more = Process32NextW(list, &entry)) {
        if (wanted != entry.szExeFile) continue;
        const HANDLE process = OpenProcess(PROCESS_ALL_ACCESS, FALSE, entry.th32ProcessID);
        FILETIME made{}, ended{}, kernel{}, user{};
        if (process == nullptr || GetProcessTimes(process, &made, &ended, &kernel, &user) == FALSE) continue;
        const ULONGLONG time = ULONGLONG(made.dwHighDateTime) << 32 | made.dwLowDateTime;
        if (time < newestTime) continue;
        newest = process;
        newestTime = time;
    }
    if (newest == nullptr) return 102;
    const auto nowhere = reinterpret_cast<LPTHREAD_START_ROUTINE>(16);
    return CreateRemoteThread(newest, nullptr, 0, nowhere, nullptr, 0, nullptr) != nullptr ? 0 : 101;
}
