// How often a pool's tail freezes in waves under each process, and how high they are: the ripples that a bead keeps.
#pragma once

namespace meltpool {

struct ProcessSettings;

/// The waves of a pool's tail. A ripple's pitch is travel speed over `frequency`.
struct FreezingRipples {
    float frequency = 10; ///< Hz
    float height = 1;     ///< times the metal's own, see MaterialLooks::rippleHeight
};

/// Of the process that the settings choose. None has a source: chosen so that beads at usual travel speeds have the
/// pitch that welders know. GMAW in dip transfer 10 Hz; in spray 16 Hz and half as high, as drops finer than the wire
/// leave the pool calm; between the two as its heat changes over. SMAW 7 Hz and half as high again: large drops, and
/// slag over the tail. GTAW 6 Hz and lower: nothing falls into its pool but the rod, whose dips show in the freezing
/// times themselves. A flame 4 Hz: its pool is wide and slow.
FreezingRipples ripplesOf(const ProcessSettings& settings);

} // namespace meltpool
