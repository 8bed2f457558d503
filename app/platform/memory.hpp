// The behaviour of the program's memory over hours.
#pragma once

namespace meltpool {

/// Makes each block of memory of 256 KiB or more go back to the system as soon as it is freed. The GNU C library would
/// otherwise reuse blocks up to the largest that it has seen freed: an attempt's megabytes then mix with longer-lived
/// blocks, and the gaps grow for minutes. No-op with other C libraries.
void giveLargeBlocksBack();

} // namespace meltpool
