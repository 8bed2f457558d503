#include "app/headset/visor.hpp"

namespace meltpool {

void Visor::wear(const HeadsetParameters& parameters, bool kelvin, LookParameters& look) const {
    if (kelvin) {
        look.adaptation = parameters.adaptation;
        look.visorShade = 0; // shade of the window's picture
        worn_.wear(settingsOf(parameters), look);
        if (look.visorShade <= 1) look.visorShade = 0;
        return;
    }
    look.exposure *= 1 + (parameters.visorShare - 1) * darkness(parameters);
}

} // namespace meltpool
