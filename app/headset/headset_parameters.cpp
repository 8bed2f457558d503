#include "app/headset/headset_parameters.hpp"

#include <array>

namespace meltpool {

namespace {

constexpr std::array<std::string_view, 2> kHands{"right", "left"};
constexpr std::array<std::string_view, 2> kTorchOn{"controller", "tracker"};
constexpr std::array<std::string_view, 2> kDeskViews{"trainee", "camera"};
constexpr std::array<std::string_view, 4> kBothEyes{"automatic", "viewports", "clip distances", "passes"};
constexpr std::array<std::string_view, 2> kPostures{"standing", "seated"};

} // namespace

std::span<const std::string_view> idleParameters(bool weld) {
    static constexpr std::array<std::string_view, 2> kInWelds{"zoom", "visor_share"};
    static constexpr std::array<std::string_view, 5> kInClassic{"weld_zoom", "visor_shade", "visor_light_shade",
                                                                "visor_switching", "adaptation"};
    return weld ? std::span<const std::string_view>(kInWelds) : kInClassic;
}

ParameterList describe(HeadsetParameters& p) {
    return {
        {"hand", "Torch in the hand", "", &p.hand, 0, 1, "the other hand holds the pointer", kHands},
        {"torch", "Torch on", "", &p.torchOn, 0, 1,
         "tracker: a Vive tracker fixed to a real torch, with its own trigger or the hand's", kTorchOn},
        {"posture", "Posture", "", &p.posture, 0, 1,
         "seated: the table is put before the person, whatever the height of the floor", kPostures},
        {"table_height", "Table height", "m", &p.tableHeight, 0.4, 1.4, "seated: ignored"},
        {"zoom", "Zoom of the classic lesson", "", &p.zoom, 1, 10,
         "factor on the size of the metal, and so on ways and speeds; torch and hands keep their own"},
        {"weld_zoom", "Zoom of a weld", "", &p.weldZoom, 1, 10,
         "1 is real size, and how every weld lesson starts; at 4 the hand makes 4 mm for 1 mm of weld and of arc"},
        {"resolution_scale", "Resolution", "", &p.resolutionScale, 0.3, 2, "the work grows with its square", {}, true},
        {"samples",
         "Samples a pixel",
         "",
         &p.samples,
         1,
         8,
         "more make edges smoother and cost memory and time",
         {},
         true},
        {"both_eyes", "Both eyes", "", &p.bothEyes, 0, 3,
         "all give the same picture; passes cost most, the others need a driver that supports them", kBothEyes},
        {"visor", "Visor", "", &p.visor, 0, 1, "darkens the view while the heat is on"},
        {"visor_shade", "Visor's shade", "", &p.visorShade, 3, 14, "9 to 11 for arcs of 100 to 250 A; in weld lessons"},
        {"visor_light_shade", "Visor's shade without an arc", "", &p.visorLightShade, 0, 7,
         "3 or 4 of real ones; 0: clear; in weld lessons"},
        {"visor_switching", "Visor darkens in", "s", &p.visorSwitching, 1e-4, 1,
         "0.0001 protects; a slow one lets the arc dazzle; in weld lessons"},
        {"adaptation", "Eye adapts", "", &p.adaptation, 0, 1,
         "the eye gets used to bright and dark, and an arc without a visor dazzles it; in weld lessons"},
        {"visor_share", "Visor lets through", "", &p.visorShare, 0.02, 1, "share of the light, in the classic lesson"},
        {"desk_view", "The window shows", "", &p.deskView, 0, 1, "the trainee's left eye, or a camera of its own",
         kDeskViews},
        {"haptic_strength", "Vibration", "", &p.hapticStrength, 0, 1, "0: none"},
    };
}

} // namespace meltpool
