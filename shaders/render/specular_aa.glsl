// Calm highlights: where the normal varies within a pixel, the lobe is as wide as its normals together (Tokuyoshi and
// Kaplanyan 2019, "Improved geometric specular antialiasing").
#ifndef MELTPOOL_RENDER_SPECULAR_AA_GLSL
#define MELTPOOL_RENDER_SPECULAR_AA_GLSL

// Variance of the pixel's filter, pixels², and the most that is added to alpha²: as engines have them, about 1/(2 pi) and 0.1
// to 0.2.
const float kPixelVariance = 0.15;
const float kMostAdded = 0.15;

// Roughness with the pixel's own: alpha² += min(2 variance, limit). `n`: unit. Call where derivatives are defined.
float calmRoughness(float roughness, vec3 n) {
    vec3 dx = dFdx(n), dy = dFdy(n);
    float added = min(2.0 * kPixelVariance * (dot(dx, dx) + dot(dy, dy)), kMostAdded);
    float square = roughness * roughness;
    return min(sqrt(sqrt(square * square + added)), 1.0);
}

#endif
