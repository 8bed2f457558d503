// Rate and height of the waves in which a pool's tail freezes: the ripples of a bead.
#pragma once

namespace meltpool {

/// Waves of a pool's tail. A ripple's pitch is travel speed over `frequency`. They have no source: each process chooses
/// its own so that beads at usual travel speeds have the pitch that welders know.
struct FreezingRipples {
    float frequency = 10; ///< Hz
    float height = 1;     ///< times the metal's own, see MaterialLooks::rippleHeight
};

} // namespace meltpool
