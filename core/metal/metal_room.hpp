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

/// What there is for it.
struct MetalRoom {
    double bytes = 0;        ///< that may be taken
    double bufferTexels = 0; ///< that the graphics driver lets a buffer texture have
};

/// Of this machine now and of the current context's driver.
MetalRoom machineRoom();

/// Why the room could not hold the metal, as the end of a sentence that begins with its name: "would be 3 million
/// particles in 7 GiB, and 5 GiB may be taken". Empty where it does.
std::string roomFault(const MetalSize& size, const MetalRoom& room);

} // namespace meltpool
