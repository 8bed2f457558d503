#include "app/platform/stop_signals.hpp"

#include <windows.h>

#include <cstring>

namespace meltpool {

namespace {

/// Handler that Windows calls on a thread of its own.
BOOL WINAPI askToStop(DWORD event) {
    StopSignals::wish(event == CTRL_C_EVENT);
    // Windows ends the program on a closed console as soon as this returns.
    if (event == CTRL_CLOSE_EVENT || event == CTRL_LOGOFF_EVENT || event == CTRL_SHUTDOWN_EVENT)
        Sleep(static_cast<DWORD>(StopSignals::kFarewell.count()));
    return TRUE;
}

} // namespace

void StopSignals::say(const char* sentence) {
    const HANDLE error = GetStdHandle(STD_ERROR_HANDLE);
    DWORD written = 0;
    WriteFile(error, sentence, static_cast<DWORD>(std::strlen(sentence)), &written, nullptr);
}

void StopSignals::catchSignals() {
    SetConsoleCtrlHandler(askToStop, TRUE);
}

void StopSignals::leaveSignals() {
    SetConsoleCtrlHandler(askToStop, FALSE);
}

} // namespace meltpool
