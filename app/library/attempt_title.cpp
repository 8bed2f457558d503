#include "app/library/attempt_title.hpp"

#include "core/base/error.hpp"
#include "core/base/output_file.hpp"
#include "core/base/text.hpp"

namespace meltpool {

namespace fs = std::filesystem;

namespace {

constexpr size_t kMostBytes = 4096; ///< bytes of a file that is read for a name

std::string oneLine(std::string_view text) {
    const std::string_view line = trimText(text.substr(0, text.find_first_of("\r\n")));
    return std::string(trimText(printable(line, kLongestTitle)));
}

} // namespace

fs::path titleFile(const fs::path& recording) {
    fs::path file = recording;
    return file.replace_extension(".title.txt");
}

std::string readTitle(const fs::path& recording) {
    const fs::path file = titleFile(recording);
    std::error_code missing;
    if (!fs::is_regular_file(file, missing)) return {};
    try {
        return oneLine(readTextFile(file, kMostBytes));
    } catch (const std::exception&) {
        return {}; // the attempt is of more worth than its name
    }
}

std::string writeTitle(const fs::path& recording, std::string_view title) {
    const std::string line = oneLine(title);
    const fs::path file = titleFile(recording);
    if (!line.empty()) {
        writeFile(file, line + "\n");
        return line;
    }
    std::error_code failure;
    fs::remove(file, failure);
    if (failure) throw InputError(file, 0, "cannot be removed: " + failure.message() + "; expected write permission");
    return line;
}

} // namespace meltpool
