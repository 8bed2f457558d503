// The two kinds of failure: wrong input (exit code 2) and a fault of the machine (exit code 1). Their sentences are
// safe for a terminal, whatever a file or a driver contributed: see printable().
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace meltpool {

/// Unusable input: a file, an argument, a driver that is too old. `what()` is one sentence that names the place and the
/// expected value. The program ends with exit code 2.
class InputError : public std::runtime_error {
  public:
    explicit InputError(std::string_view sentence);

    /// A fault in a text file; the sentence starts with "FILE:LINE: ". `line` counts from 1; 0 leaves the line out.
    InputError(const std::filesystem::path& file, int line, std::string_view sentence);
};

/// A failure that the input does not explain: a full disk, a lost GPU, a state that is no longer finite. The program
/// ends with exit code 1.
class RuntimeFault : public std::runtime_error {
  public:
    explicit RuntimeFault(std::string_view sentence);
};

} // namespace meltpool
