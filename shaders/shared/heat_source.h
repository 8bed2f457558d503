// Kinds of heat sources. A header of their own: every welding process makes sources without knowing the heat passes.
#ifndef MELTPOOL_SHARED_HEAT_SOURCE_H
#define MELTPOOL_SHARED_HEAT_SOURCE_H

#define SOURCE_SPHERE 0    // volume, 1 - d²/R²
#define SOURCE_GAUSSIAN 1  // surface that faces it, exp(-r²/(2 sigma²)) around its axis
#define SOURCE_ELLIPSOID 2 // volume, double ellipsoid of Goldak, Chakravarti and Bibby (1984)
#define SOURCE_TIP 3 // surface within its radius, conductance times temperature difference, power at most as stated

#endif
