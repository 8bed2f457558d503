// Facts about the running program for the crash report.
#pragma once

#include <string_view>

namespace meltpool {

enum class LastFact { driver, lesson, count };

/// Stores the first 127 bytes as the newest fact of its kind.
void noteFact(LastFact kind, std::string_view text);

/// The newest fact; "none yet" before the first. Safe in a crash handler: allocates nothing, waits for no lock.
const char* lastFact(LastFact kind);

} // namespace meltpool
