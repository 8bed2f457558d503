// Reflection of rough metal: the lobe of Walter et al. 2007 ("Microfacet models for refraction through rough surfaces",
// GGX) and its share of an even room's light.
#ifndef MELTPOOL_RENDER_REFLECTANCE_GLSL
#define MELTPOOL_RENDER_REFLECTANCE_GLSL

#include "shared/render.h"

layout(binding = MIRROR_SHARE_UNIT) uniform sampler2D mirrorShares;

// See core/render/look/mirror_shares.hpp.
vec2 roomShares(float roughness, float cosine) {
    const float last = float(MIRROR_SHARE_SIZE - 1);
    return textureLod(mirrorShares, (vec2(cosine, roughness) * last + 0.5) / float(MIRROR_SHARE_SIZE), 0.0).rg;
}

// The shares for a surface so smooth that no facet hides another.
vec2 smoothShares(float cosine) {
    float off = 1.0 - cosine;
    float grazing = off * off * off * off * off;
    return vec2(1.0 - grazing, grazing);
}

// Share of an even room's light that metal of this reflectance mirrors. The lobe counts light that meets one facet;
// light that meets several is added to the same lobe (Fdez-Aguera 2019, "A multiple-scattering microfacet model for
// real-time image-based lighting"), so that a perfect mirror of any roughness loses nothing.
vec3 mirroredShare(vec3 reflectance, vec2 shares) {
    return (reflectance * shares.x + shares.y) * (1.0 + reflectance * (1.0 / (shares.x + shares.y) - 1.0));
}

// Level of the environment that is its mirror image in a surface of this roughness, see ENVIRONMENT_LEVELS. At least 1:
// a sharper image would show the triangles.
float roomLevel(float roughness) {
    return max(float(ENVIRONMENT_LEVELS - 1) * pow(roughness, 2.0 / 3.0), 1.0);
}

// The lobe times the cosine at the surface for reflectance 1: light mirrored towards the eye for each unit of light that
// falls on a surface facing the lamp. `alpha`: width, the roughness squared. Geometry term: Hammon 2017, "PBR diffuse
// lighting for GGX+Smith microsurfaces".
float mirrorLobe(float halfCosine, float lampCosine, float eyeCosine, float alpha) {
    float square = alpha * alpha;
    float d = halfCosine * halfCosine * (square - 1.0) + 1.0;
    float hidden = mix(2.0 * lampCosine * eyeCosine, lampCosine + eyeCosine, alpha);
    return square * lampCosine / (6.2831853 * d * d * max(hidden, 1e-4));
}

#endif
