#include "core/base/error.hpp"

namespace meltpool {

namespace {

std::string located(const std::filesystem::path& file, int line, std::string_view sentence) {
    std::string text = file.string();
    if (line > 0) text += ":" + std::to_string(line);
    return text + ": " + std::string(sentence);
}

} // namespace

InputError::InputError(const std::filesystem::path& file, int line, std::string_view sentence)
    : std::runtime_error(located(file, line, sentence)) {}

} // namespace meltpool
