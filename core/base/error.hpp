// The two ways a request can fail: the input was wrong (exit code 2), or the machine could not do it (exit code 1).
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace meltpool {

/// The person gave something that cannot be used: a file, an argument, a driver that is too old. `what()` is one
/// sentence that names the place and says what was expected. The program ends with exit code 2.
class InputError : public std::runtime_error {
  public:
    explicit InputError(const std::string& sentence) : std::runtime_error(sentence) {}

    /// A fault in a text file; the sentence starts with "FILE:LINE: ". `line` counts from 1; 0 leaves the line out.
    InputError(const std::filesystem::path& file, int line, std::string_view sentence);
};

/// Something failed that the input does not explain: a full disk, a lost GPU, a state that is no longer finite.
class RuntimeFault : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

} // namespace meltpool
