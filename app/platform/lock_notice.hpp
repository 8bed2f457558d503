// The notice on the terminal that a command's file or folder could not be locked.
#pragma once

#include "core/base/file_lock.hpp"
#include "core/base/text.hpp"

#include <cstdio>

namespace meltpool {

inline void tellUnlocked(const FileLock& lock) {
    if (!lock.warning().empty()) std::fprintf(stderr, "meltpool: %s\n", printable(lock.warning(), 3000).c_str());
}

} // namespace meltpool
