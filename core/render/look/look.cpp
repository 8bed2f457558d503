#include "core/render/look/look.hpp"

#include <array>

namespace meltpool {

namespace {

constexpr std::array<std::string_view, 3> kModes{"surface", "wireframe", "points"};
constexpr std::array<std::string_view, 4> kColours{"material", "temperature", "even", "grey"};
constexpr std::array<std::string_view, 5> kMaterials{"solder", "copper", "gold", "wax", "ice"};
constexpr std::array<std::string_view, 3> kDetails{"low", "medium", "high"};

} // namespace

ParameterList describe(LookParameters& l) {
    return {
        {"mode", "Render mode", "", &l.mode, 0, 2, "Points are the fastest and show exact temperatures.", kModes},
        {"colours", "Colours", "", &l.colours, 0, 3,
         "Temperature is the classic scale. With even, equal steps look equally large.", kColours},
        {"material", "Material", "", &l.material, 0, 4, "Ice and wax draw the surface twice.", kMaterials},
        {"detail", "Detail", "", &l.detail, 0, 2, "Lower detail draws faster. The metal does not change.", kDetails},
        {"ambient", "Ambient light", "", &l.ambient, 0, 2,
         "Above 1 together with diffuse, bright parts lose their colour."},
        {"diffuse", "Diffuse light", "", &l.diffuse, 0, 2,
         "Above 1 together with ambient, bright parts lose their colour."},
        {"specular", "Specular light", "", &l.specular, 0, 4, "Strength of the highlight."},
        {"shininess", "Shininess", "", &l.shininess, 1, 500, "A higher value makes the highlight smaller."},
        {"dullness", "Dullness of solid metal", "", &l.dullness, 0, 1,
         "At 0 solid metal mirrors sharply, as in the thesis."},
        {"light_position", "Light position", "model units", &l.lightPosition, -100, 100,
         "Distance from the model's origin."},
        {"show_box", "Box", "", &l.showBox, 0, 1, "White edges of the particles' space."},
        {"show_sky", "Workshop", "", &l.showSky, 0, 1, "Reflections stay when it is off."},
        {"show_source", "Heat source", "", &l.showSource, 0, 1, "Burner, flame and the place that it heats."},
        {"point_size", "Point size", "model units", &l.pointSize, 0.001, 0.2, "Radius. Large points cost time."},
        {"exposure", "Exposure", "", &l.exposure, 0.01, 100, "Factor on all light. At 1 a material's grey is exact."},
        {"arc_light", "Arc's light", "", &l.arcLight, 0, 1,
         "Share of it that is drawn without a visor. 1 dazzles, as in reality. With a visor all of it is drawn."},
        {"glow_softening", "Softening of glow", "", &l.glowSoftening, 0, 10,
         "Without a visor, light of hot metal above this is compressed, so that you see the pool's edge. "
         "0 is real brightness, which dazzles."},
        {"visor_shade", "Visor shade", "", &l.visorShade, 0, 15,
         "0 is no visor. Shade 10 transmits 1/7000 and suits 200 A."},
        {"visor_light_shade", "Visor shade without an arc", "", &l.visorLightShade, 0, 7,
         "At 0 the visor is always dark. With 3 or 4 it darkens when the arc strikes."},
        {"visor_switching", "Visor darkens in", "s", &l.visorSwitching, 1e-4, 1,
         "0.0001 s protects you. A slow visor lets the arc dazzle you."},
        {"adaptation", "Eye adapts", "", &l.adaptation, 0, 1,
         "The eye gets used to bright and dark. An arc without a visor dazzles it."},
        {"spatter", "Spatter", "", &l.spatter, 0, 1, "Drops from the arc and from the wire. Not at low detail."},
        {"fume", "Fume", "", &l.fume, 0, 1,
         "Smoke in the arc's light, and rising puffs. Costs time. Not at low detail."},
    };
}

} // namespace meltpool
