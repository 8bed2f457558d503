// State of the headset for the window's telemetry.
#pragma once

#include "app/session/menu_state.hpp"

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include <map>
#include <string>

namespace meltpool {

/// State at the tip of the torch in the hand, and its vibration.
struct TipStatus {
    std::string action = "out"; ///< see arcActionName()
    double aheadMm = 0;         ///< distance to the metal along the torch's axis; infinite (null): none
    double nearestMm = 0;
    double liquid = 0;
    bool touching = false;
    double amplitude = 0;
    double frequency = 0;
    unsigned touches = 0; ///< count since the start
    unsigned pulses = 0;  ///< pulses sent to the controller since the headset was opened
};

/// State of the headset; the defaults hold if none is looked for.
struct HeadsetStatus {
    std::string state = "off"; ///< "searching", "asleep", "running", "stalled", "ended"
    std::string mode; ///< state of the session: "waiting", "synchronized", "visible", "focused"; empty: there is none
    std::string warning;
    std::string notice;    ///< notices before the person's eyes, one per line
    glm::vec3 noticeAt{0.0f}; ///< their middle, m, in the headset's space
    glm::vec3 endAt{0.0f};    ///< end of the torch at which they hang, there; the place of its tip until it burns off
    std::string tipReport; ///< request or result of measuring the torch's tip
    bool mirrored = false; ///< the window shows the trainee's eye
    int openings = 0;
    bool tracked = false;       ///< true if the torch's hand is tracked
    bool triggerLocked = false; ///< true until the trigger is released
    bool panel = false;
    glm::vec3 panelAt{0.0f};         ///< the panel's middle, m, in the headset's space
    glm::quat panelTurn{1, 0, 0, 0}; ///< its turn there
    TipStatus tip;
    double displayHz = 0;                    ///< frames per second that the runtime asks for; 0: not known yet
    double busyMs = 0;                       ///< CPU time of the last headset frame, without waiting for the runtime
    std::map<std::string, ui::Place> places; ///< controls on the panel, in its pixels
};

} // namespace meltpool
