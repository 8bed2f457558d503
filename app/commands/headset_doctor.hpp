// The headset's part of `meltpool doctor`.
#pragma once

#include "app/commands/doctor.hpp"

namespace meltpool {

/// Inspects runtime, headset, formats, refresh rate and controllers; a missing part is a note, because every lesson
/// runs without a headset.
void inspectHeadset(std::vector<Finding>& findings);

} // namespace meltpool
