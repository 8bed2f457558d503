// What the drawing passes and the renderer share: uniform blocks, texture units and vertex layout.
#ifndef MELTPOOL_SHARED_RENDER_H
#define MELTPOOL_SHARED_RENDER_H

#include "glsl_types.h"

// Uniform block bindings.
#define FRAME_BINDING 0
#define MATERIAL_BINDING 1

// Texture units.
#define SHARP_UNIT 0  // the environment, level 0 alone: without the cost of choosing a level
#define ROUGH_UNIT 1  // the environment with its levels: the higher, the rougher the surface that mirrors it
#define SCALE_UNIT 2  // temperature colours, one scale a row
#define BACK_UNIT 3   // back faces of all views side by side: normal and distance from the eye
#define HEAT_UNIT 5   // glow and tint over temperature
#define SECTION_UNIT 6 // what lies on the section's plane
#define NOISE_UNIT 4  // smooth random values in space, repeating

// Storage bindings of passes that pull their vertices.
#define PULL_VERTICES_BINDING 0
#define PULL_INDICES_BINDING 1

// Most views of one draw call list.
#define MOST_VIEWS 4

// The environment is stored as sqrt(light / ENVIRONMENT_RANGE) in ten bits: fine steps in the dark, lamps brighter than
// white, and filtering as cheap as that of a plain picture.
#define ENVIRONMENT_RANGE 8.0

// Levels of the environment. Level i holds what a surface of GGX roughness (i / (ENVIRONMENT_LEVELS - 1))^1.5 mirrors.
#define ENVIRONMENT_LEVELS 7

// Columns and rows of the temperature colour texture.
#define SCALE_COLUMNS 257
#define SCALE_ROWS 3

// Columns of the heat colour texture and the temperatures (K) of its ends.
#define HEAT_COLUMNS 512
#define HEAT_COLDEST 300.0
#define HEAT_HOTTEST 4300.0

// The section: reach of a particle in spacings, and the sum of weights (1 - r²)² at half of the full density, which is
// 0.957 reach³ (4 pi times the integral of (1 - r²)² r² over 0..1, times the density).
#define SECTION_REACH 1.5f
#define SECTION_INSIDE (0.5f * 0.957f * SECTION_REACH * SECTION_REACH * SECTION_REACH)

#ifdef __cplusplus
namespace meltpool {
#endif

struct ViewData {
    mat4 worldToClip;
    mat4 worldToEye;
    mat4 clipToWay; // clip xy at the far plane (z = w = 1) to a world direction
    vec4 eye;       // world; w: pixels that one world unit covers at a depth of 1
    vec4 size;      // pixels: width, height, left and lower border in the frame buffer
};

struct FrameData {
    ViewData views[MOST_VIEWS];
    mat4 modelToWorld;
    vec4 light;       // place of the lamp, world units
    vec4 lampWay;     // unit world direction from the model's origin to the lamp: highlights take the lamp as far away
    vec4 phong;       // ambient, diffuse, specular, shininess
    vec4 tone;        // rgb: exposure times what the visor lets through, w: size of a model unit in world units
    vec4 temperature; // x: coldest, y: 1 / (hottest - coldest), z: solidus, w: 1 / (liquidus - solidus), 0 = classic
    vec4 colours;     // x: ColourMode, y: row of the temperature scale, z: number of views
    vec4 boxMin;
    vec4 boxMax;
    vec4 cut;    // plane, world: what has dot(xyz, place) > w is taken away
    vec4 arc;      // place of the arc, world units; w: square of the least distance, model units
    vec4 arcLight; // rgb: its intensity, 1 = white paper's luminance times square model unit; 0: no arc
    vec4 detail; // x: dullness of solid metal, y: radius of a drawn particle in world units, z: width of a classic cube over a model unit: scales frost and clouds
};

struct MaterialData {
    vec4 solid;  // rgb: colour as displayed (sRGB), w: share of the mirror image
    vec4 liquid; // the same, molten
    vec4 mirror; // rgb: linear colour of the mirror image, w: refractive index of translucent stuff
    vec4 glint;  // rgb: linear colour of the lamp's highlight
    vec4 heat;   // x: share of a black body's light, y: strength of the oxide's tint
    vec4 absorb; // rgb: absorption over the width of a classic cube, w: scattering over it
};

#ifdef __cplusplus
static_assert(sizeof(ViewData) == 224);
static_assert(sizeof(FrameData) == 4 * 224 + 64 + 12 * 16);
static_assert(sizeof(MaterialData) == 6 * 16);
} // namespace meltpool
#endif

#endif
