// Whether metal of a given size fits this machine and its driver, told before anything of it is made.
#pragma once

#include <string>

namespace meltpool {

/// How much of what a metal will make.
struct MetalSize {
    double heatCells = 0;     ///< of the lattice that conducts
    double particles = 0;     ///< with heat
    double flowParticles = 0; ///< that may move, and walls beside them
    double flowVolume = 0;    ///< of the space they may move in, in spacings cubed
    double otherBytes = 0;    ///< of what is made beside the metal
};

/// Why the memory that is free now, or the driver's buffers, could not hold it, as the end of a sentence that begins
/// with its name: "would be 3 million particles in 7 GiB, and 5 GiB may be taken". Empty where there is room. Needs a
/// current context.
std::string roomFault(const MetalSize& size);

} // namespace meltpool
