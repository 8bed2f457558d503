// What the report of a crash tells about the running program besides where it crashed.
#pragma once

#include <string_view>

namespace meltpool {

enum class LastFact { driver, lesson, count };

/// Remembers the first 127 bytes of the newest of each kind.
void noteFact(LastFact kind, std::string_view text);

/// May be called where nothing else works any more: allocates nothing, waits for no lock. "none yet" before the first.
const char* lastFact(LastFact kind);

} // namespace meltpool
