#include "app/session/menu_state.hpp"

namespace meltpool {

ParameterList describe(PanelState& p) {
    return {
        {"view", "View menu", "", &p.view, 0, 1, "open at the start"},
        {"simulation", "Machine menu", "", &p.simulation, 0, 1, "open at the start"},
        {"timings", "Timings", "", &p.timings, 0, 1, "open at the start"},
    };
}

} // namespace meltpool
