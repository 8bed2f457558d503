#include "core/render/look/look.hpp"

#include <array>

namespace meltpool {

namespace {

constexpr std::array<std::string_view, 3> kModes{"surface", "wireframe", "points"};
constexpr std::array<std::string_view, 4> kColours{"material", "temperature", "even", "grey"};
constexpr std::array<std::string_view, 5> kMaterials{"solder", "copper", "gold", "wax", "ice"};

} // namespace

ParameterList describe(LookParameters& l) {
    return {
        {"mode", "Render mode", "", &l.mode, 0, 2, "points are the quickest and show exact temperatures", kModes},
        {"colours", "Colours", "", &l.colours, 0, 3,
         "temperature: the classic scale; even: equal steps look equally far apart", kColours},
        {"material", "Material", "", &l.material, 0, 4, "ice and wax draw the surface twice", kMaterials},
        {"ambient", "Ambient light", "", &l.ambient, 0, 2, "with diffuse above 1 together bright parts wash out"},
        {"diffuse", "Diffuse light", "", &l.diffuse, 0, 2, "with ambient above 1 together bright parts wash out"},
        {"specular", "Specular light", "", &l.specular, 0, 4, "strength of the highlight"},
        {"shininess", "Shininess", "", &l.shininess, 1, 500, "higher makes the highlight smaller"},
        {"dullness", "Dullness of solid metal", "", &l.dullness, 0, 1, "0 is the plain thesis: solid mirrors sharply"},
        {"light_position", "Light position", "model units", &l.lightPosition, -100, 100, "from the model's origin"},
        {"show_box", "Box", "", &l.showBox, 0, 1, "white edges of the space the particles live in"},
        {"show_sky", "Workshop", "", &l.showSky, 0, 1, "reflections stay when it is off"},
        {"show_source", "Heat source", "", &l.showSource, 0, 1, "the small cube"},
        {"point_size", "Point size", "model units", &l.pointSize, 0.001, 0.2, "radius; large points cost fill rate"},
        {"exposure", "Exposure", "", &l.exposure, 0.01, 100, "factor on all light; 1 keeps the material's grey"},
        {"arc_light", "Arc's light", "", &l.arcLight, 0, 1,
         "share that falls on things without a visor: 1 blinds, as it does; through a visor it is always whole"},
        {"visor_shade", "Visor shade", "", &l.visorShade, 0, 15,
         "0: no visor; 10 lets 1/7000 through, for an arc of 200 A"},
    };
}

} // namespace meltpool
