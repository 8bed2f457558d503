// Whether a lesson fits this machine, told before its metal is made.
#pragma once

#include "core/training/lesson.hpp"

namespace meltpool {

/// Throws InputError in a sentence where the memory that is free now, or the driver's buffers, could not hold the
/// lesson's metal and surface, or where its workpiece cannot be made. Needs a current context.
void requireRoom(const Lesson& lesson);

} // namespace meltpool
