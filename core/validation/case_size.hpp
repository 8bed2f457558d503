// Whether a case fits its spacing and this machine, told before anything is made of it.
#pragma once

#include "core/metal/metal_room.hpp"
#include "core/validation/validation_case.hpp"

namespace meltpool {

/// Throws InputError in a sentence where the memory that is free now, or the driver's buffers, could not hold it.
void requireRoom(const ValidationCase& from, const MetalSize& size);

/// Throws InputError where the case would take so many steps of heat or flow that nobody waits for them.
void requireSteps(const ValidationCase& from, double steps);

/// Throws InputError where a length (m) that the case names is less than `least` spacings.
void requireSpacings(const ValidationCase& from, std::string_view key, double length, double least);

} // namespace meltpool
