// Whether a lesson fits this machine, told before its metal is made.
#pragma once

#include "core/metal/metal_room.hpp"
#include "core/training/lesson/lesson.hpp"

namespace meltpool {

/// Throws InputError in a sentence where the room could not hold the lesson's metal and surface, or where its workpiece
/// cannot be made.
void requireRoom(const Lesson& lesson, const MetalRoom& room);

} // namespace meltpool
