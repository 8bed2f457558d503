// Tells before the metal is made if a lesson fits this machine.
#pragma once

#include "core/metal/metal_capacity.hpp"
#include "core/training/lesson/lesson.hpp"

namespace meltpool {

/// Throws InputError with a sentence if the room is too small for the lesson's metal and surface, or if its workpiece
/// cannot be made.
void requireCapacity(const Lesson& lesson, const MetalCapacity& room);

} // namespace meltpool
