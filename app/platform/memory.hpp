// How the program's memory behaves over hours.
#pragma once

namespace meltpool {

/// From now on each block of memory of 256 KiB or more goes back to the system as soon as it is freed. The C library of
/// GNU would otherwise keep blocks up to the largest that it has seen freed: an attempt's megabytes then lie among what
/// lives longer, and the gaps grow for minutes. Does nothing with other C libraries.
void giveLargeBlocksBack();

} // namespace meltpool
