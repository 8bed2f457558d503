// A torch that welds straight over a plate: what the bead and the energy cases have in common with a lesson.
#pragma once

#include "core/validation/validation_case.hpp"
#include "core/weld/process/weld.hpp"
#include "core/weld/torch/torch_path.hpp"

namespace meltpool {

/// The process that a case's keys `process`, `voltage`, `current_a`, `wire_diameter_mm`, `wire_feed_m_min`, `ctwd_mm`
/// and `arc_length_mm` ask for. A machine with wire that is given a current is given the feed that melts at it, in a
/// fillet above the metal that fills the corner. A case that only says `power_w` gets a machine of that electric power:
/// voltage over the computed current with wire, an arc of 3 mm without. Throws InputError where the keys do not make a
/// process.
ProcessSettings caseProcess(const ValidationCase& from);

/// Distance (m) from the plate to the torch's pose, which is the electrode's tip or the wire's end at its stick-out.
float caseTorchHeight(const ValidationCase& from, const ProcessSettings& settings);

/// An upright torch that moves from x = `start` to `end` (m) at height `height` over y = 0 with the trigger pulled, in
/// `seconds`, and then stands there with the trigger released.
TorchPath straightRun(float start, float end, float height, double seconds);

/// How a torch is held over a seam along x.
struct TorchPose {
    float height = 0;                      ///< m from the seam to the torch's pose, along the torch
    double workAngle = 0, travelAngle = 0; ///< rad, see heldOrientation()
};

/// The same run of a torch that is held in another way and points at y = z = 0.
TorchPath heldRun(float start, float end, const TorchPose& held, double seconds);

/// The whole number of spacings that is nearest to a length, at least one. All in mm.
float wholeSpacings(double length, float spacing);

/// A plate of length x thickness x width (m) with its upper face at y = 0, as lessons make it.
Workpiece casePlate(const ValidationCase& from, float length, float thickness, float width, double temperature);

} // namespace meltpool
