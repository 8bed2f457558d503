// Parameters of the picture that a person can choose.
#pragma once

#include "core/base/parameter.hpp"

#include <glm/vec3.hpp>

namespace meltpool {

enum RenderMode : int { kSurfaceMode, kWireframeMode, kPointsMode };
enum ColourMode : int { kMaterialColours, kTemperatureColours, kEvenColours, kGreyColours };
enum MaterialLook : int { kSolder, kCopper, kGold, kWax, kIce };
/// Amount of light and metal that a picture computes; each level adds to the one before.
enum PictureDetail : int { kLowDetail, kMediumDetail, kHighDetail };

struct LookParameters {
    int mode = kSurfaceMode;        ///< RenderMode
    int colours = kMaterialColours; ///< ColourMode
    int material = kSolder;         ///< MaterialLook
    int detail = kHighDetail;       ///< PictureDetail
    float ambient = 0.4f;
    float diffuse = 0.6f;
    float specular = 0.6f;
    float shininess = 60.0f;
    float dullness = 0.8f;                     ///< 0: solid metal mirrors as sharply as liquid, 1: like brushed metal
    glm::vec3 lightPosition{1.2f, 2.6f, 2.4f}; ///< model units, from the model's origin along the world's axes
    bool showBox = true;
    bool showSky = true;
    bool showSource = true;
    float pointSize = 0.02f;      ///< radius of a drawn particle, model units
    float exposure = 1.0f;        ///< factor on all light
    float arcLight = 5e-5f;       ///< share of an arc's light that is drawn without a visor
    float glowSoftening = 0.08f;  ///< light of hot metal from which on it is compressed without a visor
    float visorShade = 0.0f;      ///< shade number of the welding filter; 0: none
    bool spatter = true;          ///< drops that the arc throws, the wire's drops, and the beads on plate and table
    bool fume = true;             ///< smoke that the arc lights
    float visorLightShade = 0.0f; ///< shade of an auto-darkening filter without an arc; 0: always as dark as its shade
    float visorSwitching = 1e-4f; ///< s in which such a filter darkens
    bool adaptation = false;      ///< the eye of a person who watches adapts to bright and dark, and is dazzled
    /// Measures that are left out whatever the detail, a bit each (see measures.hpp): the way to measure the cost of
    /// one.
    unsigned leftOut = 0;
};

/// Returns the description for menus, files and `--set`; it points into `look`.
ParameterList describe(LookParameters& look);

} // namespace meltpool
