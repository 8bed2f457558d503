// Turns a lesson's demonstration to the hand that holds the torch: its handle is on the side of that hand.
#pragma once

#include "core/training/lesson/lesson.hpp"

namespace meltpool {

enum class WeldingHand { left, right };

/// Returns the direction of travel (+1 towards growing places, from left to right before the person; -1) in which the
/// handle of the torch is on the side of this hand: a right hand pushes from right to left and drags from left to
/// right. 0 if the lesson leaves no choice: it demands a direction, its seam is a circle or steep, or its torch is held
/// within 5 degrees of upright.
int directionForHand(const Lesson& lesson, WeldingHand hand);

/// Returns the lesson's path for this hand: the path itself, or its mirror image about the middle of the seam. All
/// straight workpieces are symmetric about that middle, so the weld is the same.
TorchPath pathForHand(const Lesson& lesson, WeldingHand hand);

} // namespace meltpool
