// Which menus are open, and what a person asks for in them.
#pragma once

#include "core/base/parameter.hpp"

namespace meltpool {

/// Which panels of the window are open.
struct PanelState {
    bool view = false;
    bool simulation = true;
    bool timings = false;
    bool help = false;
    bool hidden = false; ///< everything out of the way of the picture
};
ParameterList describe(PanelState& panels);

/// What a person asked for with a button.
enum class MenuRequest { none, start, startWithDefaults, reset, restart };

} // namespace meltpool
