#include "app/platform/aside_file.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <system_error>

namespace meltpool {

namespace fs = std::filesystem;

namespace {

fs::path asideName(const fs::path& file, int number) {
    fs::path name = file;
    return name.replace_filename(file.stem().string() + ".broken-" + std::to_string(number) +
                                 file.extension().string());
}

bool sameBytes(const fs::path& one, const fs::path& other) {
    std::error_code unreadable;
    if (fs::file_size(one, unreadable) != fs::file_size(other, unreadable) || unreadable) return false;
    using Bytes = std::istreambuf_iterator<char>;
    std::ifstream a(one, std::ios::binary), b(other, std::ios::binary);
    return a && b && std::equal(Bytes(a), Bytes(), Bytes(b), Bytes());
}

} // namespace

AsideFile keepAside(const fs::path& file, bool whole) {
    int number = 1;
    fs::path aside = asideName(file, number);
    for (; fs::exists(aside); aside = asideName(file, ++number))
        if (!whole && sameBytes(file, aside))
            return {true, file.string() + " as it was is kept as " + aside.string() + ".", true};
    std::error_code failed;
    if (whole)
        fs::rename(file, aside, failed);
    else
        fs::copy_file(file, aside, failed);
    if (failed) return {false, file.string() + " could not be kept aside: " + failed.message() + "."};
    return {true, file.string() + " as it was is kept as " + aside.string() + "."};
}

} // namespace meltpool
