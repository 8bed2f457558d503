// How often a pool's tail freezes in waves, and how high they are: the ripples that a bead keeps.
#pragma once

namespace meltpool {

/// The waves of a pool's tail. A ripple's pitch is travel speed over `frequency`. None has a source: each process
/// chooses its own so that beads at usual travel speeds have the pitch that welders know.
struct FreezingRipples {
    float frequency = 10; ///< Hz
    float height = 1;     ///< times the metal's own, see MaterialLooks::rippleHeight
};

} // namespace meltpool
