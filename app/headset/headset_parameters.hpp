// Describes the parameters of working in the headset.
#pragma once

#include "core/base/parameter.hpp"

#include <span>
#include <string_view>

namespace meltpool {

struct HeadsetParameters {
    enum TorchHand { kRight, kLeft };
    enum TorchOn { kController, kTracker };
    enum Table { kAutomaticHeight, kSetHeight };
    enum DeskView { kByVisor, kTrainee, kCamera };
    enum BothEyes { kAutomatic, kViewports, kClipDistances, kPasses };

    int hand = kRight;            ///< TorchHand
    int torchOn = kController;    ///< TorchOn: device that carries the torch's pose
    int table = kAutomaticHeight; ///< Table: origin of the table's height
    float setHeight = 0.90f;      ///< m of the table over the floor, for kSetHeight
    float tableHeight = 0.90f;    ///< m over the workshop's floor, in effect since the workshop was last placed
    float zoom = 4.0f;            ///< scale at which the classic lesson's box is shown
    float weldZoom = 1.0f;        ///< scale of a weld's workpiece; 1 again at each start of a weld lesson
    float resolutionScale = 1.0f; ///< factor on the runtime's recommended size of a side
    int samples = 4;              ///< samples a pixel
    int bothEyes = kAutomatic;    ///< BothEyes: way of one frame to two eyes
    bool visor = true;            ///< darkens while heat or arc is on
    float visorShade = 10;        ///< EN 169 number of the dark visor over an arc
    float visorLightShade = 3;    ///< EN 169 number of the light visor without an arc; 0: clear
    float visorSwitching = 1e-4f; ///< s from light to dark
    bool adaptation = true;       ///< the eye adapts to bright and dark, and can be dazzled
    float visorShare = 0.25f;     ///< share of the light that the visor transmits if the source gives none
    int deskView = kByVisor;      ///< DeskView: content of the window while the headset is in use
    float hapticStrength = 1.0f;  ///< factor on every vibration
};

/// Returns the zoom of a weld or of the classic lesson.
inline float shownZoom(const HeadsetParameters& parameters, bool weld) {
    return weld ? parameters.weldZoom : parameters.zoom;
}

/// Returns the keys that have no effect in a weld or in the classic lesson.
std::span<const std::string_view> idleParameters(bool weld);

/// Returns a list that points into `parameters`.
ParameterList describe(HeadsetParameters& parameters);

} // namespace meltpool
