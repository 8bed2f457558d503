#include "app/session/menu_state.hpp"

namespace meltpool {

ParameterList describe(PanelState& p) {
    return {
        {"view", "View menu", "", &p.view, 0, 1, "Open when the program starts."},
        {"simulation", "Machine menu", "", &p.simulation, 0, 1, "Open when the program starts."},
        {"timings", "Timings", "", &p.timings, 0, 1, "Open when the program starts."},
    };
}

} // namespace meltpool
