// The parameters of working in the headset.
#pragma once

#include "core/base/parameter.hpp"

#include <span>
#include <string_view>

namespace meltpool {

struct HeadsetParameters {
    enum TorchHand { kRight, kLeft };
    enum TorchOn { kController, kTracker };
    enum Posture { kStanding, kSeated };
    enum DeskView { kTrainee, kCamera };
    enum BothEyes { kAutomatic, kViewports, kClipDistances, kPasses };

    int hand = kRight;            ///< TorchHand
    int torchOn = kController;    ///< TorchOn: what carries the torch's pose
    int posture = kStanding;      ///< Posture
    float tableHeight = 0.90f;    ///< m above the floor (standing)
    float zoom = 4.0f;            ///< the classic lesson's box is shown this many times its size
    float weldZoom = 1.0f;        ///< the same of a weld's workpiece; 1 again at each start of a weld lesson
    float resolutionScale = 1.0f; ///< times the runtime's recommended size a side
    int samples = 4;              ///< for each pixel
    int bothEyes = kAutomatic;    ///< BothEyes: how one frame gets to two eyes
    bool visor = true;            ///< darkens while the heat is on
    float visorShade = 10;        ///< EN 169 number of the dark visor over an arc
    float visorLightShade = 3;    ///< the same without an arc; 0: clear
    float visorSwitching = 1e-4f; ///< s from light to dark
    bool adaptation = true;       ///< the eye gets used to bright and dark, and is dazzled
    float visorShare = 0.25f;     ///< share of the light that it transmits where the source gives none
    int deskView = kTrainee;      ///< DeskView: what the window shows while the headset is in use
    float hapticStrength = 1.0f;  ///< factor on every vibration
};

/// The zoom of a lesson, by whether it is a weld.
inline float shownZoom(const HeadsetParameters& parameters, bool weld) {
    return weld ? parameters.weldZoom : parameters.zoom;
}

/// Keys that change nothing in such a lesson.
std::span<const std::string_view> idleParameters(bool weld);

/// The list points into `parameters`.
ParameterList describe(HeadsetParameters& parameters);

} // namespace meltpool
