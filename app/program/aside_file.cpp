#include "app/program/aside_file.hpp"

#include <system_error>

namespace meltpool {

namespace fs = std::filesystem;

namespace {

/// The name of a new file beside `file`.
fs::path asideName(const fs::path& file) {
    for (int i = 1;; ++i) {
        fs::path name = file;
        name.replace_filename(file.stem().string() + ".broken-" + std::to_string(i) + file.extension().string());
        if (!fs::exists(name)) return name;
    }
}

} // namespace

AsideFile keepAside(const fs::path& file, bool whole) {
    const fs::path aside = asideName(file);
    std::error_code failed;
    if (whole)
        fs::rename(file, aside, failed);
    else
        fs::copy_file(file, aside, failed);
    if (failed) return {false, file.string() + " could not be kept aside: " + failed.message() + "."};
    return {true, file.string() + " as it was is kept as " + aside.string() + "."};
}

} // namespace meltpool
