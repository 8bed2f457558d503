// Keeps a file of the user's that cannot be used, before a new one takes its place.
#pragma once

#include <filesystem>
#include <string>

namespace meltpool {

struct AsideFile {
    bool kept = false;
    std::string sentence; ///< where it is, or why it could not be kept
    bool before = false;  ///< it was kept earlier, to the last byte
};

/// Keeps `file` beside itself as NAME.broken-N.EXTENSION, with the first N that is free. `whole`: nothing in it is
/// usable, so it is renamed; else it is copied, once.
AsideFile keepAside(const std::filesystem::path& file, bool whole);

} // namespace meltpool
