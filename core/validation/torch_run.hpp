// A torch that welds straight over a plate: the common part of the bead and the energy cases with a lesson.
#pragma once

#include "core/validation/validation_case.hpp"
#include "core/weld/process/weld.hpp"
#include "core/weld/torch/torch_path.hpp"

namespace meltpool {

/// Returns a number of the case; 0 if its kind has no such key.
double numberOrNone(const ValidationCase& from, std::string_view key);

/// Returns the speed (m/s) at which the case's covered electrode burns off; 0 for another process.
double caseBurnOff(const ValidationCase& from, const ProcessSettings& process);

/// Returns the filler (m³/s) of a wire, a covered electrode or a rod that the fingers feed.
double caseFillerRate(const ValidationCase& from, const ProcessSettings& process);

/// Returns the process for a case's keys `process`, `voltage`, `current_a`, `wire_diameter_mm`, `wire_feed_m_min`,
/// `ctwd_mm` and `arc_length_mm`. A machine with wire and a given current receives the feed that melts at it, in a
/// fillet above the metal that fills the corner. A case with only `power_w` gets a machine of that electric power:
/// voltage over the computed current with wire, an arc of 3 mm without. A chart's weld has `electrode`,
/// `electrode_diameter_mm` and `rod_diameter_mm`, too. Throws InputError if the keys do not make a
/// process.
ProcessSettings caseProcess(const ValidationCase& from);

/// Returns the distance (m) from the plate to the torch's pose, which is the electrode's tip or the wire's end at its
/// stick-out.
float caseTorchHeight(const ValidationCase& from, const ProcessSettings& settings);

/// Returns an upright torch that moves from x = `start` to `end` (m) at height `height` over y = 0 with the trigger
/// pulled, in `seconds`, and then stays there with the trigger released.
TorchPath straightRun(float start, float end, float height, double seconds);

/// Hold of a torch over a seam along x.
struct TorchPose {
    float height = 0;                      ///< m from the seam to the torch's pose, along the torch
    double workAngle = 0, travelAngle = 0; ///< rad, see heldOrientation()
};

/// Returns a straight run like straightRun() of a torch that is held at `held` and points at y = z = 0.
TorchPath heldRun(float start, float end, const TorchPose& held, double seconds);

/// Returns the whole number of spacings nearest to a length, at least one. All in mm.
float wholeSpacings(double length, float spacing);

/// Returns a plate of length x thickness x width (m) with its upper face at y = 0, as lessons make it.
Workpiece casePlate(const ValidationCase& from, float length, float thickness, float width, double temperature);

} // namespace meltpool
