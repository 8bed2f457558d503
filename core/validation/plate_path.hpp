// A plate and a straight path over its middle, in SI: for the cases that weld a bead on a plate.
#pragma once

#include "core/validation/torch_run.hpp"

namespace meltpool {

/// The plate's frame: x along the seam with the plate's middle at 0, y up with the plate's top at 0.
struct PlatePath {
    ProcessSettings process;
    float length, thickness, width; ///< m, size of the plate
    float height;                   ///< m, height of the torch's pose
    float speed;                    ///< m/s
    float start, end;               ///< m, ends of the path
    double ambient;                 ///< K

    /// Reads `plate_mm`, `ambient_k`, `speed_mm_s` and the keys of the process.
    explicit PlatePath(const ValidationCase& from);

    /// Throws InputError if the plate has too few particles or this machine too little room.
    void require(const ValidationCase& from) const;
    double way() const { return static_cast<double>(end - start); } ///< m
    double seconds() const { return static_cast<double>((end - start) / speed); }
    TorchPath torch() const { return straightRun(start, end, height, seconds()); }
    Workpiece workpiece(const ValidationCase& from) const { return casePlate(from, length, thickness, width, ambient); }
};

} // namespace meltpool
