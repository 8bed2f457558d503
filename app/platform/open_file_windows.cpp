#include "app/platform/open_file.hpp"

#include <windows.h>

#include <shellapi.h>

#include <cstdint>

namespace meltpool {

bool openForPerson(const std::filesystem::path& file) {
    std::error_code failed;
    const std::filesystem::path whole = std::filesystem::absolute(file, failed);
    const HINSTANCE answer = ShellExecuteW(nullptr, L"open", whole.c_str(), nullptr, nullptr, SW_SHOWNORMAL);
    return reinterpret_cast<std::intptr_t>(answer) > 32; // smaller values are errors
}

} // namespace meltpool
