#include "xr/runtime_manifest.hpp"

#include <windows.h>

#include <array>
#include <cstddef>

namespace meltpool::xr {

namespace fs = std::filesystem;

std::vector<fs::path> activeRuntimePlaces() {
    return {};
}

/// A setting by a person without an administrator's rights must not choose code that runs with those rights, so the
/// loader checks the level that Windows trusts the process with.
bool runtimeVariableHeeded() {
    HANDLE token = nullptr;
    if (OpenProcessToken(GetCurrentProcess(), TOKEN_QUERY, &token) == FALSE) return true;
    alignas(TOKEN_MANDATORY_LABEL) std::array<std::byte, sizeof(TOKEN_MANDATORY_LABEL) + SECURITY_MAX_SID_SIZE> answer;
    DWORD bytes = 0;
    const BOOL told = GetTokenInformation(token, TokenIntegrityLevel, answer.data(), answer.size(), &bytes);
    CloseHandle(token);
    if (told == FALSE) return true;
    PSID label = reinterpret_cast<const TOKEN_MANDATORY_LABEL*>(answer.data())->Label.Sid;
    const DWORD last = *GetSidSubAuthorityCount(label) - 1u;
    return *GetSidSubAuthority(label, last) <= SECURITY_MANDATORY_MEDIUM_RID;
}

fs::path activeRuntimeFile() {
    DWORD bytes = 0;
    constexpr const wchar_t* kKey = L"SOFTWARE\\Khronos\\OpenXR\\1";
    constexpr const wchar_t* kValue = L"ActiveRuntime";
    if (RegGetValueW(HKEY_LOCAL_MACHINE, kKey, kValue, RRF_RT_REG_SZ, nullptr, nullptr, &bytes) != ERROR_SUCCESS)
        return {};
    std::wstring text(bytes / sizeof(wchar_t), L'\0');
    if (RegGetValueW(HKEY_LOCAL_MACHINE, kKey, kValue, RRF_RT_REG_SZ, nullptr, text.data(), &bytes) != ERROR_SUCCESS)
        return {};
    text.resize(text.find(L'\0')); // the value's own end
    return text;
}

} // namespace meltpool::xr
