#include "app/headset/headset_parameters.hpp"

#include "app/session/person_settings.hpp"

#include <array>

namespace meltpool {

namespace {

constexpr std::array<std::string_view, 2> kTorchOn{"controller", "tracker"};
constexpr std::array<std::string_view, 3> kDeskViews{"automatic", "trainee", "camera"};
constexpr std::array<std::string_view, 4> kBothEyes{"automatic", "viewports", "clip distances", "passes"};
constexpr std::array<std::string_view, 2> kTables{"automatic", "set"};

} // namespace

std::span<const std::string_view> idleParameters(bool weld) {
    static constexpr std::array<std::string_view, 2> kInWelds{"zoom", "visor_share"};
    static constexpr std::array<std::string_view, 5> kInClassic{"weld_zoom", "visor_shade", "visor_light_shade",
                                                                "visor_switching", "adaptation"};
    return weld ? std::span<const std::string_view>(kInWelds) : kInClassic;
}

ParameterList describe(HeadsetParameters& p) {
    return {
        {"hand", "Torch in the hand", "", &p.hand, 0, 1, "The other hand holds the pointer.", handChoices()},
        {"torch", "Torch on", "", &p.torchOn, 0, 1,
         "With tracker, a Vive tracker sits on a real torch. The trigger is its own or the hand's.", kTorchOn},
        {"table", "Height of the table", "", &p.table, 0, 1,
         "Automatic: it fits your eyes, standing or seated. Set: the height below, over the floor.", kTables},
        {"table_height", "Set height", "m", &p.setHeight, 0.4, 1.6,
         "Height over the floor, if the height of the table is set."},
        {"zoom", "Zoom of the classic lesson", "", &p.zoom, 1, 10,
         "Factor on the metal's size, paths and speeds. Torch and hands keep their size."},
        {"weld_zoom", "Zoom of a weld", "", &p.weldZoom, 1, 10,
         "1 is real size. Every weld lesson starts with it. At 4 your hand moves 4 mm for 1 mm of weld or arc."},
        {"resolution_scale",
         "Resolution",
         "",
         &p.resolutionScale,
         0.3,
         2,
         "Factor on the headset's own resolution. Higher is sharper but slower.",
         {},
         true},
        {"samples",
         "Samples a pixel",
         "",
         &p.samples,
         1,
         8,
         "More make edges smoother. They need more memory and time.",
         {},
         true},
        {"both_eyes", "Both eyes", "", &p.bothEyes, 0, 3,
         "Way to draw both eyes, with equal pictures. Passes are slowest. The others need the driver's support.",
         kBothEyes},
        {"visor", "Visor", "", &p.visor, 0, 1, "Darkens the view while the heat is on."},
        {"visor_shade", "Visor's shade", "", &p.visorShade, 3, 14, "9 to 11 suit 100 to 250 A. Only in weld lessons."},
        {"visor_light_shade", "Visor's shade without an arc", "", &p.visorLightShade, 0, 7,
         "Real visors have 3 or 4. 0 is clear. Only in weld lessons."},
        {"visor_switching", "Visor darkens in", "s", &p.visorSwitching, 1e-4, 1,
         "0.0001 s protects you. A slow visor lets the arc dazzle you. Only in weld lessons."},
        {"adaptation", "Eye adapts", "", &p.adaptation, 0, 1,
         "The eye gets used to bright and dark. An arc without a visor dazzles it. Only in weld lessons."},
        {"visor_share", "Visor lets through", "", &p.visorShare, 0.02, 1, "Share of light, for the classic lesson."},
        {"desk_view", "The window shows", "", &p.deskView, 0, 2,
         "The trainee's left eye, or a camera of its own. Automatic: the camera while the visor is dark. Key F6.",
         kDeskViews},
        {"haptic_strength", "Vibration", "", &p.hapticStrength, 0, 1, "0 is none."},
    };
}

} // namespace meltpool
