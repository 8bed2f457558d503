// What the drawing passes and the renderer share: uniform blocks, texture units and vertex layout.
#ifndef MELTPOOL_SHARED_RENDER_H
#define MELTPOOL_SHARED_RENDER_H

#include "glsl_types.h"

// Uniform block bindings.
#define FRAME_BINDING 0
#define MATERIAL_BINDING 1

// Texture units.
#define SHARP_UNIT 0  // the environment as it is
#define ROUGH_UNIT 1  // the environment as rough surfaces mirror it, one roughness a level
#define SCALE_UNIT 2  // temperature colours, one scale a row
#define BACK_UNIT 3   // back faces: normal and distance from the eye

// Storage bindings of passes that pull their vertices.
#define PULL_VERTICES_BINDING 0
#define PULL_INDICES_BINDING 1

// Most views of one draw call list.
#define MOST_VIEWS 4

// The environment is stored as sqrt(light / ENVIRONMENT_RANGE) in eight bits: fine steps in the dark, lamps brighter
// than white, and filtering as cheap as that of a plain picture.
#define ENVIRONMENT_RANGE 8.0

// Mipmap levels of the rough environment; level i holds roughness (i + 1) / ROUGH_LEVELS.
#define ROUGH_LEVELS 5

// Columns and rows of the temperature colour texture.
#define SCALE_COLUMNS 257
#define SCALE_ROWS 3

#ifdef __cplusplus
namespace meltpool {
#endif

struct ViewData {
    mat4 worldToClip;
    mat4 clipToWay; // clip xy at the far plane (z = w = 1) to a world direction
    vec4 eye;       // world; w = height of the view in pixels times eyeToClip[1][1] / 2: pixels of 1 unit at depth 1
    vec4 size;      // pixels: width, height, 1 / width, 1 / height
};

struct FrameData {
    ViewData views[MOST_VIEWS];
    mat4 modelToWorld;
    vec4 light;       // place of the lamp, world units
    vec4 phong;       // ambient, diffuse, specular, shininess
    vec4 tone;        // x: exposure, y: 1 = this pass encodes sRGB, z: size of a model unit in world units
    vec4 temperature; // x: coldest, y: 1 / (hottest - coldest), z: solidus, w: 1 / (liquidus - solidus), 0 = classic
    vec4 colours;     // x: ColourMode, y: row of the temperature scale
    vec4 boxMin;
    vec4 boxMax;
};

struct MaterialData {
    vec4 solid;  // rgb: linear reflectance, w: share of the mirror image
    vec4 liquid; // the same, molten
    vec4 tint;   // rgb: colour of the mirror image, w: refractive index of translucent stuff
    vec4 rough;  // x: solid, y: liquid roughness, z: MaterialLook, w: unused
    vec4 absorb; // rgb: absorption per model unit, w: scattering per model unit
};

#ifdef __cplusplus
static_assert(sizeof(ViewData) == 160);
static_assert(sizeof(FrameData) == 4 * 160 + 64 + 7 * 16);
static_assert(sizeof(MaterialData) == 5 * 16);
} // namespace meltpool
#endif

#endif
