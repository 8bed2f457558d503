// Definitions that the drawing shaders share with the renderer: uniform blocks, texture units, vertex attributes.
#ifndef MELTPOOL_SHARED_RENDER_H
#define MELTPOOL_SHARED_RENDER_H

#include "glsl_types.h"

// Uniform block bindings.
#define FRAME_BINDING 0
#define MATERIAL_BINDING 1

// Texture units.
#define SHARP_UNIT 0   // the environment, level 0 only: saves choosing a level
#define ROUGH_UNIT 1   // the environment with its levels: higher for rougher mirrors
#define SCALE_UNIT 2   // temperature colours, one scale a row
#define BACK_UNIT 3    // back faces of all views side by side: normal and distance from the eye
#define NOISE_UNIT 4   // smooth random values in space, repeating
#define HEAT_UNIT 5    // glow and tint over temperature
#define SECTION_UNIT 6 // the map of the section
#define MIRROR_SHARE_UNIT 7 // share of an even room's light that rough metal mirrors

// Vertex attributes of the metal's surface (SurfaceVertex) and of particles drawn as points.
#define POSITION_ATTRIBUTE 0
#define NORMAL_ATTRIBUTE 1
#define PEAK_ATTRIBUTE 2
#define TEMPERATURE_ATTRIBUTE 3
#define FREEZING_ATTRIBUTE 4 // SurfaceFreezing
#define FROZEN_ATTRIBUTE 5

// Vertex attributes of solids, besides POSITION_ATTRIBUTE and NORMAL_ATTRIBUTE: constant over the vertices of one.
#define SOLID_PLACE_ATTRIBUTE 2 // four columns
#define SOLID_PAINT_ATTRIBUTE 6
#define SOLID_GLOW_ATTRIBUTE 7

// Storage bindings of passes that read vertices from buffers by themselves.
#define PULL_VERTICES_BINDING 0
#define PULL_INDICES_BINDING 1
#define STROKES_BINDING 2

// Storage bindings of the islands of oxide, and the pass that finds them. One of each OXIDE_STRIDE particles carries an
// island while it is liquid: at 1 mm a pool has some five visible ones. None: chosen.
#define OXIDE_PARTICLES_BINDING 4
#define OXIDE_BINDING 5
#define OXIDE_GROUP 256u
#define OXIDE_STRIDE 20u
#define OXIDE_MOST 96u

// Storage bindings and group of the pass that colours vertices for files.
#define COLOURED_HEATS_BINDING 0
#define COLOURS_BINDING 1
#define COLOURS_GROUP 64

// Most views of a frame.
#define MOST_VIEWS 4
#define MOST_SHADOW_BOXES 3 // blocks of a workpiece: a bridge has three
#define MOST_TORCH_PARTS 5  // a TIG torch with its filler rod has five
#define MOST_ROLLED_PLATES 3

// The environment is stored as sqrt(light / ENVIRONMENT_RANGE) in ten bits: fine steps in the dark, room for lamps
// brighter than white, and the filtering cost of an ordinary texture.
#define ENVIRONMENT_RANGE 8.0

// Levels of the environment. Level i is the mirror image in a surface of GGX roughness (i / (ENVIRONMENT_LEVELS - 1))^1.5.
#define ENVIRONMENT_LEVELS 7

// The workshop's geometry: boxes and gas bottles, and the sides that a bottle is drawn with. The floor's height is that
// under the place from which the environment shows the workshop, m.
#define WORKSHOP_BOXES 17
#define WORKSHOP_BOTTLES 3
#define WORKSHOP_BOTTLE_SIDES 24
#define WORKSHOP_FLOOR (-1.25)
#define WORKSHOP_LOW vec3(-4.2, WORKSHOP_FLOOR, -3.6)
#define WORKSHOP_HIGH vec3(4.2, 2.3, 4.4)

// Columns and rows of the temperature colour texture.
#define SCALE_COLUMNS 257
#define SCALE_ROWS 3

// Columns of the heat colour texture and the temperatures (K) of its ends.
#define HEAT_COLUMNS 512
#define HEAT_COLDEST 300.0
#define HEAT_HOTTEST 4300.0

// Texels of an edge of the mirror share texture.
#define MIRROR_SHARE_SIZE 32

// Veiling luminance (cd/m²) a lux at the eye and over square degrees: 10 (1 + (25 / 70)^4), see glare.frag.
#define GLARE_PER_SQUARE_DEGREE 10.163

// The section: weight of the metal (1 inside solid metal) at its outline.
#define SECTION_INSIDE 0.5

#ifdef __cplusplus
namespace meltpool {
#endif

struct ViewData {
    mat4 worldToClip;
    mat4 worldToEye;
    mat4 clipToDirection; // clip xy at the far plane (z = w = 1) to a world direction
    vec3 eye;             // world
    float pixelsPerUnit;  // pixels that one world unit covers at a depth of 1
    vec2 size;            // width and height, pixels
    vec2 corner;          // lower left corner in the frame buffer, pixels
    float arcSeen;        // share of the arc that the eye sees past the person's hands, 0..1
    float reserved;
    vec2 reserved2;
};

/// A block of the workpiece, which blocks the arc's light.
struct ShadowBox {
    vec3 low;        // model units
    float fullDepth; // model units of way through it after which no light is left
    vec3 high;
    float reserved;
};

/// A cylinder of the torch or of the filler, which pools mirror.
struct TorchPart {
    vec3 from; // middle of an end, world
    float radius;
    vec3 to;
    float reserved;
    vec3 colour; // linear reflectance
    float reserved2;
};

/// A plate, whose rolled faces are under mill scale.
struct RolledPlate {
    vec3 low; // model units
    float reserved;
    vec3 high;
    float reserved2;
    vec3 faces; // 1 for each axis that its rolled faces look along, else 0
    float reserved3;
};

/// An island of oxide on a pool.
struct OxideIsland {
    vec3 place;      ///< world, of the particle that carries it
    float perRadius; ///< 1 / radius of the ball about it, 1 / world units
    uint carrier;    ///< its number
    uint reserved, reserved2, reserved3;
};

struct OxideIslands {
    uint count;
    uint reserved, reserved2, reserved3;
    OxideIsland islands[OXIDE_MOST];
};

struct FrameData {
    ViewData views[MOST_VIEWS];
    mat4 modelToWorld;
    vec3 lamp;                    // position, world
    float modelUnit;              // length of a model unit in world units
    vec3 lampDirection;           // unit, world, from the model's origin: for highlights the lamp is infinitely far away
    float perCubeWidth;           // 1 / width of a classic cube in model units: scales frost and clouds
    float ambient;                // factors of Phong's model, like the next three
    float diffuse;
    float specular;
    float shininess;
    vec3 exposure;                // factor on all light, with the visor's transmittance
    float dullness;               // dullness of solid metal
    float coldest;                // lower end of the temperature colours
    float perTemperatureRange;    // 1 / (hottest - coldest)
    float solidus;                // K
    float perMushyRange;          // 1 / (liquidus - solidus); 0: the classic model
    vec3 boxMin;
    float pointRadius;            // radius of a drawn particle, world units
    vec3 boxMax;
    float viewCount;
    vec3 cutNormal; // world: parts with dot(cutNormal, position) > cutOffset are cut away
    float cutOffset;
    vec3 arc;                     // position, world
    float arcMinDistanceSquared;  // nearer surfaces are lit as from this distance, square model units
    vec3 arcLight;                // luminous intensity, 1 = white paper's luminance times a square model unit; 0: no arc
    float colourMode;             // ColourMode
    float scaleRow;               // row of the temperature colour texture
    int shadowBoxCount;
    float glowSoftening; // hot metal's light is compressed from about this on; 0: drawn at full brightness
    int torchPartCount;
    ShadowBox shadowBoxes[MOST_SHADOW_BOXES];
    TorchPart torchParts[MOST_TORCH_PARTS];
    vec3 seamAcross;              // 1 for each axis across the seam, else 0
    float groundHalf;             // model units from the seam up to which the plates are ground bright
    int rolledPartCount;
    float oxideRadius; // radius of an island, model units; 0: none
    vec2 reserved;
    RolledPlate rolledParts[MOST_ROLLED_PLATES];
    vec3 source;        // hottest place of the classic metal's flame, world
    float sourceReach;  // distance that its heat reaches, world units
    vec3 sourceLight;   // light of the place that it reaches; 0: no source
    float sourceShadow; // share of the lamp's light that its burner takes straight below it
};

struct MaterialData {
    vec3 solidColour;      // colour as displayed (sRGB)
    float solidMirror;     // share of the mirror image
    vec3 liquidColour;
    float liquidMirror;
    vec3 mirrorColour;     // linear colour of the mirror image
    float refractiveIndex; // index of translucent materials
    vec3 highlight;        // linear colour of the lamp's highlight
    float oxideTint;       // strength of the temper colours, 0..1
    vec3 absorption;       // absorption over the width of a classic cube
    float scattering;      // scattering over the width of a classic cube
    vec3 cleanReflectance; // reflectance of physical metal, linear: solid and bare
    float cleanEmissivity; // shares of a black body's light, as the next two
    vec3 liquidReflectance;
    float liquidEmissivity;
    float scaledEmissivity; // solid, under scale
    float solidRoughness;   // 0 mirror .. 1 dull
    float liquidRoughness;
    float rippleFrequency; // frequency in metal that froze, Hz
    float rippleHeight;    // model units
    float millScale;       // share of rolled faces, 0..1
    vec2 reserved2;
};

/// A straight line with round ends in the plane of a section, whose axes are the workpiece's z and y; model units.
struct SectionStroke {
    vec2 from;
    vec2 to;
    vec4 colour; // linear sRGB, cover
    float width;
    float reserved;
    vec2 reserved2;
};

#ifdef __cplusplus
static_assert(sizeof(SectionStroke) == 48);
static_assert(sizeof(ViewData) == 240);
static_assert(sizeof(FrameData) == 4 * 240 + 64 + (15 + 2 * MOST_SHADOW_BOXES + 3 * MOST_TORCH_PARTS + 3 * MOST_ROLLED_PLATES) * 16);
static_assert(sizeof(MaterialData) == 9 * 16);
} // namespace meltpool
#endif

#endif
