// The program's entry on Windows.
#include "app/commands/command_line.hpp"
#include "app/platform/console_windows.hpp"
#include "app/platform/crash_report_windows.hpp"
#include "core/base/resources.hpp"

#include <windows.h>

#include <mmsystem.h>

#include <string>
#include <vector>

// Laptops with two graphics cards give the program the faster one if it exports these.
extern "C" {
__declspec(dllexport) DWORD NvOptimusEnablement = 1;
__declspec(dllexport) int AmdPowerXpressRequestHighPerformance = 1;
}

namespace {

/// Timer resolution of 1 ms during its lifetime; by default Windows rounds waits to 15.6 ms.
struct FineTimer {
    FineTimer() { timeBeginPeriod(1); }
    ~FineTimer() { timeEndPeriod(1); }
};

} // namespace

int main() {
    if (const auto code = meltpool::writeAskedDump()) return *code;
    const FineTimer timer;
    const meltpool::Utf8Console console;
    meltpool::reportCrashes(meltpool::settingsFolder());
    std::vector<std::string> words = meltpool::commandLineWords();
    std::vector<char*> pointers;
    for (std::string& word : words)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);
    return meltpool::runProgram(static_cast<int>(words.size()), pointers.data());
}
