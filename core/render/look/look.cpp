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
        {"mode", "Render mode", "", &l.mode, 0, 2, "points are the fastest and show exact temperatures", kModes},
        {"colours", "Colours", "", &l.colours, 0, 3,
         "temperature: the classic scale; even: equal steps look equally large", kColours},
        {"material", "Material", "", &l.material, 0, 4, "ice and wax draw the surface twice", kMaterials},
        {"detail", "Detail", "", &l.detail, 0, 2, "lower draws faster; the metal is the same", kDetails},
        {"ambient", "Ambient light", "", &l.ambient, 0, 2,
         "above 1 together with diffuse, bright parts lose their colour"},
        {"diffuse", "Diffuse light", "", &l.diffuse, 0, 2,
         "above 1 together with ambient, bright parts lose their colour"},
        {"specular", "Specular light", "", &l.specular, 0, 4, "strength of the highlight"},
        {"shininess", "Shininess", "", &l.shininess, 1, 500, "higher makes the highlight smaller"},
        {"dullness", "Dullness of solid metal", "", &l.dullness, 0, 1,
         "0, as in the thesis: solid metal mirrors sharply"},
        {"light_position", "Light position", "model units", &l.lightPosition, -100, 100, "from the model's origin"},
        {"show_box", "Box", "", &l.showBox, 0, 1, "white edges of the particles' space"},
        {"show_sky", "Workshop", "", &l.showSky, 0, 1, "reflections stay when it is off"},
        {"show_source", "Heat source", "", &l.showSource, 0, 1, "the small cube"},
        {"point_size", "Point size", "model units", &l.pointSize, 0.001, 0.2,
         "radius; large points cost time per pixel"},
        {"exposure", "Exposure", "", &l.exposure, 0.01, 100, "factor on all light; 1 shows a material's grey as it is"},
        {"arc_light", "Arc's light", "", &l.arcLight, 0, 1,
         "share of it that is drawn without a visor: at 1 it dazzles, as in reality; with a visor all of it is drawn"},
        {"glow_softening", "Softening of glow", "", &l.glowSoftening, 0, 10,
         "without a visor hot metal's light is compressed from about this on, so that the pool's edge can be seen; "
         "0: as bright as it is, which dazzles"},
        {"visor_shade", "Visor shade", "", &l.visorShade, 0, 15,
         "0: no visor; 10 transmits 1/7000, for an arc of 200 A"},
        {"visor_light_shade", "Visor shade without an arc", "", &l.visorLightShade, 0, 7,
         "0: the visor is always dark; 3 or 4: it darkens by itself when the arc strikes"},
        {"visor_switching", "Visor darkens in", "s", &l.visorSwitching, 1e-4, 1,
         "0.0001 protects; a slow one lets the arc dazzle"},
        {"adaptation", "Eye adapts", "", &l.adaptation, 0, 1,
         "the eye gets used to bright and dark, and an arc without a visor dazzles it"},
        {"spatter", "Spatter", "", &l.spatter, 0, 1,
         "drops that the arc throws, and those of the wire; not at low detail"},
        {"fume", "Fume", "", &l.fume, 0, 1,
         "smoke that the arc lights, and puffs that rise; costs time per pixel; not at low detail"},
    };
}

} // namespace meltpool
