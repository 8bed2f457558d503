// The move or copy of a user's unusable file, before a new one takes its place.
#pragma once

#include <filesystem>
#include <string>

namespace meltpool {

struct AsideFile {
    bool kept = false;
    std::string sentence; ///< its new place, or the reason why it could not be moved or copied
    bool before = false;  ///< true: an identical copy existed already
};

/// Moves or copies `file` to NAME.broken-N.EXTENSION in its folder, with the first N that is free. `whole`: nothing in
/// it is usable, so it is renamed; else it is copied, once.
AsideFile keepAside(const std::filesystem::path& file, bool whole);

} // namespace meltpool
