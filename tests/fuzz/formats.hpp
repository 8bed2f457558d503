// The file formats that the program reads, each with the checks of its reader for arbitrary bytes.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace meltpool::test {

/// A reader's answer to an input.
enum class Answer { taken, refused };

struct Format {
    const char* name;
    const char* fileName;
    std::vector<std::string> (*corpus)();
    /// Reads the file. Throws std::logic_error with a sentence if accepted content is unsound; the only other permitted
    /// exception is InputError.
    Answer (*read)(const std::filesystem::path& file);
};

/// Returns every format, the command line included.
std::span<const Format> formats();

} // namespace meltpool::test
