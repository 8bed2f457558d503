// What the window's telemetry says about the headset.
#pragma once

#include "app/session/menu_state.hpp"

#include <map>
#include <string>

namespace meltpool {

/// What happens at the tip of the torch in the hand, and its vibration.
struct TipStatus {
    std::string action = "out"; ///< see arcActionName()
    double aheadMm = 0;         ///< to the metal along the torch's axis; infinite (null): none
    double nearestMm = 0;
    double liquid = 0;
    bool touching = false;
    double amplitude = 0;
    double frequency = 0;
    unsigned touches = 0; ///< since the start
    unsigned pulses = 0;  ///< sent to the controller since the headset was opened
};

/// The state of the headset; the defaults hold where none is searched for.
struct HeadsetStatus {
    std::string state = "off"; ///< "searching", "asleep", "running", "stalled", "ended"
    std::string mode; ///< of the session: "waiting", "synchronized", "visible", "focused"; empty: there is none
    std::string warning;
    std::string notice;    ///< what stands before the person's eyes, a line each
    std::string tipReport; ///< what measuring the torch's tip wants or has found
    bool mirrored = false; ///< the window shows the trainee's eye
    int openings = 0;
    bool tracked = false;       ///< the torch's hand
    bool triggerLocked = false; ///< until it is let go
    bool panel = false;
    TipStatus tip;
    double displayHz = 0;                    ///< frames a second that the runtime asks for; 0: not known yet
    double busyMs = 0;                       ///< CPU time of the last headset frame without the runtime's waiting
    std::map<std::string, ui::Place> places; ///< controls on the panel, its pixels
};

} // namespace meltpool
