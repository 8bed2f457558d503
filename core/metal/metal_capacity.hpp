// Checks before allocation that metal of a given size fits this machine and its driver.
#pragma once

#include <string>

namespace meltpool {

/// The numbers of cells and particles of a metal.
struct MetalSize {
    double heatCells = 0;     ///< cells of the lattice that conducts
    double particles = 0;     ///< particles with heat
    double flowParticles = 0; ///< particles that may move, and adjacent walls
    double flowVolume = 0;    ///< volume of the space they may move in, in spacings cubed
    double otherBytes = 0;    ///< memory for other things than the metal
};

/// The available memory.
struct MetalCapacity {
    double bytes = 0;        ///< bytes that may be taken
    double bufferTexels = 0; ///< most texels of a buffer texture in the graphics driver
};

/// The capacity of this machine now and of the current context's driver.
MetalCapacity machineCapacity();

/// The reason why the metal does not fit, as the end of a sentence that begins with its name: "would be 3 million
/// particles in 7 GiB, and 5 GiB may be taken". Empty if it fits.
std::string capacityFault(const MetalSize& size, const MetalCapacity& room);

} // namespace meltpool
