#include "xr/runtime_manifest.hpp"

#include <windows.h>

namespace meltpool::xr {

namespace fs = std::filesystem;

std::vector<fs::path> activeRuntimePlaces() {
    return {};
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
