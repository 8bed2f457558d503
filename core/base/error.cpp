#include "core/base/error.hpp"

#include "core/base/text.hpp"

namespace meltpool {

namespace {

constexpr size_t kLongestSentence = 2000; ///< bytes; the longest sentence of the program lists all keys of a lesson

std::string located(const std::filesystem::path& file, int line, std::string_view sentence) {
    std::string text = file.string();
    if (line > 0) text += ":" + std::to_string(line);
    return text + ": " + std::string(sentence);
}

} // namespace

InputError::InputError(const std::filesystem::path& file, int line, std::string_view sentence)
    : InputError(located(file, line, sentence)) {}

InputError::InputError(std::string_view sentence) : std::runtime_error(printable(sentence, kLongestSentence)) {}

RuntimeFault::RuntimeFault(std::string_view sentence) : std::runtime_error(printable(sentence, kLongestSentence)) {}

} // namespace meltpool
