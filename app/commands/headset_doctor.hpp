// The headset's part of `meltpool doctor`.
#pragma once

#include "app/commands/doctor.hpp"

namespace meltpool {

/// Runtime, headset, formats, refresh rate, controllers; what is missing is a note, since every lesson runs without a
/// headset.
void inspectHeadset(std::vector<Finding>& findings);

} // namespace meltpool
