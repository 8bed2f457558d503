// Checks that a case fits its spacing and this machine, before anything is made of it.
#pragma once

#include "core/metal/metal_capacity.hpp"
#include "core/validation/validation_case.hpp"

namespace meltpool {

/// Throws InputError in a sentence if the memory that is free now, or the driver's buffers, could not hold it.
void requireCapacity(const ValidationCase& from, const MetalSize& size);

/// Throws InputError if the case would take too many steps of heat or flow to wait for.
void requireSteps(const ValidationCase& from, double steps);

/// Throws InputError if a length (m) that the case names is less than `least` spacings.
void requireSpacings(const ValidationCase& from, std::string_view key, double length, double least);

} // namespace meltpool
