#include "app/platform/crash_report_windows.hpp"

#include "app/platform/program_info.hpp"
#include "core/base/last_facts.hpp"

#include <windows.h>

#include <dbghelp.h>
#include <shellapi.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <cwchar>
#include <exception>
#include <optional>
#include <string>

namespace meltpool {

namespace {

constexpr int kMostCalls = 48;
constexpr ULONG kStackForReport = 64 << 10;          ///< bytes, reserved for the report of a stack overflow
constexpr wchar_t kDumpWord[] = L"--write-minidump"; ///< first word of a process that writes one, and of no other
constexpr DWORD kAbort = 0xE0000A0B;                 ///< code for abort() and C++ exceptions in a report

std::wstring reportFolder;
std::string reportVersion;
std::array<char, 256> reason{};  ///< message of a C++ exception
std::atomic<DWORD> reporter = 0; ///< the thread that writes the report

void write(HANDLE file, const char* text) {
    DWORD written = 0;
    WriteFile(file, text, static_cast<DWORD>(std::char_traits<char>::length(text)), &written, nullptr);
}

template <class... Texts>
void writeLine(HANDLE file, Texts... texts) {
    (write(file, texts), ...);
    write(file, "\r\n");
}

/// Number as "0x1234".
struct Hexadecimal {
    explicit Hexadecimal(DWORD64 value) { std::snprintf(text.data(), text.size(), "0x%llx", value); }
    const char* c_str() const { return text.data(); }
    std::array<char, 24> text{};
};

/// Writes "meltpool.exe+0x1234" for an address in the code of a module.
void writePlace(HANDLE file, DWORD64 address) {
    DWORD64 base = 0;
    RtlLookupFunctionEntry(address, &base, nullptr);
    std::array<char, MAX_PATH> name{};
    if (base != 0) GetModuleFileNameA(reinterpret_cast<HMODULE>(base), name.data(), MAX_PATH - 1);
    const char* slash = std::strrchr(name.data(), '\\');
    const char* last = slash == nullptr ? name.data() : slash + 1;
    if (base == 0)
        writeLine(file, "    ", Hexadecimal(address).c_str(), ", in no module");
    else
        writeLine(file, "    ", last, "+", Hexadecimal(address - base).c_str());
}

/// Writes the calls that led to `context`, the newest first.
void writeCalls(HANDLE file, CONTEXT context) {
    for (int i = 0; i < kMostCalls && context.Rip != 0; ++i) {
        writePlace(file, context.Rip);
        DWORD64 base = 0, frame = 0;
        void* handler = nullptr;
        if (RUNTIME_FUNCTION* function = RtlLookupFunctionEntry(context.Rip, &base, nullptr)) {
            RtlVirtualUnwind(UNW_FLAG_NHANDLER, base, context.Rip, function, &context, &handler, &frame, nullptr);
            continue;
        }
        // A function without an entry has only its return address on the stack.
        if (IsBadReadPtr(reinterpret_cast<void*>(context.Rsp), sizeof(DWORD64)) != FALSE) return;
        context.Rip = *reinterpret_cast<DWORD64*>(context.Rsp);
        context.Rsp += sizeof(DWORD64);
    }
}

void writeText(HANDLE file, const EXCEPTION_POINTERS& what) {
    SYSTEMTIME now{};
    GetSystemTime(&now);
    std::array<char, 64> date{};
    std::snprintf(date.data(), date.size(), "%04d-%02d-%02d %02d:%02d:%02d UTC", now.wYear, now.wMonth, now.wDay,
                  now.wHour, now.wMinute, now.wSecond);
    writeLine(file, "Meltpool ", reportVersion.c_str(), " ended by a fault of its own.");
    writeLine(file, "when: ", date.data());
    writeLine(file, "driver: ", lastFact(LastFact::driver));
    writeLine(file, "last lesson: ", lastFact(LastFact::lesson));
    writeLine(file, "exception: ", Hexadecimal(what.ExceptionRecord->ExceptionCode).c_str());
    if (reason.front() != '\0') writeLine(file, "it says: ", reason.data());
    writeLine(file, "calls, the newest first:");
    writeCalls(file, *what.ContextRecord);
}

HANDLE makeFile(const std::wstring& stem, const wchar_t* extension) {
    return CreateFileW((stem + extension).c_str(), GENERIC_WRITE, FILE_SHARE_READ, nullptr, CREATE_ALWAYS,
                       FILE_ATTRIBUTE_NORMAL, nullptr);
}

/// Starts another process of this program that writes the minidump and waits for it, up to a limit. The crashed process
/// would stop threads of which one may hold a lock that the writing needs. False: there is none, and no part of one
/// either.
bool writeDump(const std::wstring& stem, EXCEPTION_POINTERS* what) {
    constexpr DWORD kPatience = 30000; // ms; Wine takes longest, about 10 s on an idle machine
    constexpr DWORD kFarewell = 2000;  // ms, until the file that it holds can be removed
    static std::array<wchar_t, 1024> own{};
    static std::array<wchar_t, 4096> command{};
    if (GetModuleFileNameW(nullptr, own.data(), static_cast<DWORD>(own.size())) >= own.size()) return false;
    const int length = std::swprintf(command.data(), command.size(), L"\"%ls\" %ls %lu %lu %llu \"%ls.dmp\"",
                                     own.data(), kDumpWord, GetCurrentProcessId(), GetCurrentThreadId(),
                                     static_cast<unsigned long long>(reinterpret_cast<ULONG_PTR>(what)), stem.c_str());
    if (length < 0) return false;
    STARTUPINFOW start{};
    start.cb = sizeof start;
    PROCESS_INFORMATION writer{};
    if (CreateProcessW(own.data(), command.data(), nullptr, nullptr, FALSE, CREATE_NO_WINDOW, nullptr, nullptr, &start,
                       &writer) == FALSE)
        return false;
    DWORD code = 1;
    if (WaitForSingleObject(writer.hProcess, kPatience) == WAIT_OBJECT_0) GetExitCodeProcess(writer.hProcess, &code);
    if (code == 0) return true;
    TerminateProcess(writer.hProcess, 1);
    WaitForSingleObject(writer.hProcess, kFarewell);
    DeleteFileW((stem + L".dmp").c_str());
    return false;
}

void tell(const std::wstring& file) {
    std::array<char, 1024> narrow{};
    WideCharToMultiByte(CP_UTF8, 0, file.c_str(), -1, narrow.data(), static_cast<int>(narrow.size()) - 1, nullptr,
                        nullptr);
    const HANDLE error = GetStdHandle(STD_ERROR_HANDLE);
    write(error, "meltpool: the program ended by a fault of its own; ");
    write(error, narrow.data());
    write(error, " tells its makers where; what was recorded up to here is kept\n");
}

/// Ends the process without destructors and libraries, which a crash may have left in any state.
[[noreturn]] void endProcess(DWORD code) {
    TerminateProcess(GetCurrentProcess(), code);
    std::_Exit(1);
}

[[noreturn]] void report(EXCEPTION_POINTERS* what, DWORD code) {
    DWORD other = 0;
    if (!reporter.compare_exchange_strong(other, GetCurrentThreadId())) {
        if (other == GetCurrentThreadId()) endProcess(code); // writing the report crashed
        Sleep(INFINITE);                                     // the other thread ends the process
    }
    CreateDirectoryW(reportFolder.c_str(), nullptr);
    SYSTEMTIME now{};
    GetLocalTime(&now);
    std::array<wchar_t, 96> name{};
    std::swprintf(name.data(), name.size(), L"\\crash-%04d-%02d-%02dT%02d%02d%02d-%lu", now.wYear, now.wMonth, now.wDay,
                  now.wHour, now.wMinute, now.wSecond, GetCurrentProcessId());
    const std::wstring stem = reportFolder + name.data();
    const HANDLE file = makeFile(stem, L".txt");
    if (file != INVALID_HANDLE_VALUE) {
        writeText(file, *what);
        tell(stem + L".txt");
    }
    const bool dumped = writeDump(stem, what);
    if (file != INVALID_HANDLE_VALUE) {
        writeLine(file, dumped ? "minidump: beside this file" : "minidump: could not be written");
        CloseHandle(file);
    }
    endProcess(code);
}

LONG WINAPI onException(EXCEPTION_POINTERS* what) {
    report(what, what->ExceptionRecord->ExceptionCode);
}

/// Reports from here: abort() and std::terminate() raise no exception of Windows by themselves.
[[noreturn]] void reportHere() {
    CONTEXT context{};
    RtlCaptureContext(&context);
    EXCEPTION_RECORD record{};
    record.ExceptionCode = kAbort;
    record.ExceptionAddress = reinterpret_cast<void*>(context.Rip);
    EXCEPTION_POINTERS what{&record, &context};
    report(&what, 1);
}

[[noreturn]] void onTerminate() {
    try {
        if (const auto exception = std::current_exception()) std::rethrow_exception(exception);
    } catch (const std::exception& fault) {
        std::snprintf(reason.data(), reason.size(), "%s", fault.what());
    } catch (...) {
        std::snprintf(reason.data(), reason.size(), "an exception without a text");
    }
    reportHere();
}

} // namespace

void reportCrashes(const std::filesystem::path& folder) {
    reportFolder = folder.wstring();
    reportVersion = programBuild();
    SetErrorMode(SEM_FAILCRITICALERRORS | SEM_NOGPFAULTERRORBOX);
    ULONG kept = kStackForReport;
    SetThreadStackGuarantee(&kept);
    SetUnhandledExceptionFilter(onException);
    std::set_terminate(onTerminate);
    std::signal(SIGABRT, [](int) { reportHere(); });
}

std::optional<int> writeAskedDump() {
    int count = 0;
    wchar_t** words = CommandLineToArgvW(GetCommandLineW(), &count);
    if (words == nullptr || count != 6 || std::wcscmp(words[1], kDumpWord) != 0) return std::nullopt;
    using Write = BOOL(WINAPI*)(HANDLE, DWORD, HANDLE, MINIDUMP_TYPE, PMINIDUMP_EXCEPTION_INFORMATION, void*, void*);
    const DWORD process = std::wcstoul(words[2], nullptr, 10), thread = std::wcstoul(words[3], nullptr, 10);
    const ULONG_PTR pointers = std::wcstoull(words[4], nullptr, 10);
    const HMODULE library = LoadLibraryW(L"dbghelp.dll");
    const HANDLE crashed = OpenProcess(PROCESS_ALL_ACCESS, FALSE, process);
    if (library == nullptr || crashed == nullptr) return 1;
    const auto write = reinterpret_cast<Write>(reinterpret_cast<void*>(GetProcAddress(library, "MiniDumpWriteDump")));
    const HANDLE file = makeFile(words[5], L"");
    if (write == nullptr || file == INVALID_HANDLE_VALUE) return 1;
    MINIDUMP_EXCEPTION_INFORMATION exception{thread, reinterpret_cast<EXCEPTION_POINTERS*>(pointers), TRUE};
    const BOOL written = write(crashed, process, file, MiniDumpNormal, &exception, nullptr, nullptr);
    CloseHandle(file);
    return written != FALSE ? 0 : 1;
}

} // namespace meltpool
