// The formats of files that the program reads, each with what a reader must make of any bytes whatever.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace meltpool::test {

/// What a reader did with an input.
enum class Answer { taken, refused };

struct Format {
    const char* name;
    const char* fileName;
    std::vector<std::string> (*corpus)();
    /// Reads the file. Throws std::logic_error with a sentence when what was taken is unsound; InputError is the only
    /// other exception that it may throw.
    Answer (*read)(const std::filesystem::path& file);
};

/// Every format, the command line too.
std::span<const Format> formats();

} // namespace meltpool::test
