// Ice: a clear rim that refracts the background, a cloudy core with bubbles and cracks, frost on the solid surface but not
// on the wet one.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/translucent.glsl"

const int kSteps = 4;

// Optical depths along a ray through the body.
struct Clouds {
    float milk;  // milky core
    float flaws; // bubbles and cracks
};

Clouds clouds(vec3 from, vec3 along, float thickness) {
    vec2 sum = vec2(0.0); // depths of milk and flaws
    float step1 = thickness / float(kSteps);
    for (int i = 0; i < kSteps; ++i) {
        float s = (float(i) + 0.5) * step1;
        vec3 at = from + along * s;
        float deep = min(s, thickness - s);
        // Ice freezes from the outside inwards and drives the air to its core, in upright threads.
        vec4 coarse = texture(noise, at * vec3(0.32, 0.12, 0.32));
        vec4 fine = texture(noise, at * vec3(1.15, 0.5, 1.15) + 0.3);
        sum.x += smoothstep(0.05, 0.30, deep) * smoothstep(0.40, 0.72, coarse.r * 0.6 + fine.r * 0.4) * step1;
        // A crack is a thin sheet; a few are scattered through the ice.
        float crack = smoothstep(0.014, 0.0, abs(coarse.g - 0.5)) * smoothstep(0.45, 0.75, coarse.b);
        float bubble = smoothstep(0.82, 0.90, fine.a);
        sum.y += (0.5 * crack + bubble) * smoothstep(0.0, 0.08, deep) * step1;
    }
    return Clouds(sum.x, sum.y);
}

void main() {
    vec3 at = place * frame.perCubeWidth;
    vec3 n = normalize(normal);
    vec3 along = normalize(way);
    vec3 lamp = normalize(toLamp);
    float wet = meltShares(temperature).mirror;
    // Solid ice is never flat: a grain that shows in highlights.
    vec3 bump = texture(noise, at * 0.3).rgb - 0.5;
    vec3 grain = texture(noise, at * 2.6).rgb - 0.5;
    n = normalize(n + (bump * 0.22 + grain * 0.10) * (1.0 - 0.85 * wet));

    Passage p = passThrough(along, n, material.refractiveIndex);
    float level = 2.0 * (1.0 - wet);
    vec3 behind = environmentAt(p.exitDirection, level) * exp(-material.absorption * p.distance);

    mat3 toModel = transpose(mat3(frame.modelToWorld)); // the inverse, but for a scale that normalising removes
    Clouds depth = clouds(at, normalize(toModel * p.inside), p.distance);
    vec3 sky = skyLight(n);
    float lit = frame.ambient + frame.diffuse * (0.35 + 0.65 * max(dot(n, lamp), 0.0));
    vec3 white = (0.55 * lit + 0.5 * sky) * vec3(0.82, 0.93, 1.0);
    vec3 body = mix(behind, white, 1.0 - exp(-(depth.milk * material.scattering) * 1.6));
    body = mix(body, white * 1.35, 1.0 - exp(-(depth.flaws * material.scattering) * 4.0));

    // Frost: a thin white film in patches, denser at grazing angles.
    float cosine = max(-dot(along, n), 0.0);
    float patchy = 0.6 * bump.r + 0.4 * grain.g + 0.5;
    float frost = (1.0 - wet) * clamp(0.10 + 0.5 * (patchy - 0.42) + 0.35 * pow(1.0 - cosine, 2.0), 0.04, 0.6);
    body = mix(body, white * 1.1, frost);

    vec3 mirrored = reflect(along, n);
    vec3 image = environmentAt(mirrored, 1.0 + 2.0 * (1.0 - wet));
    float shininess = frame.shininess * (0.5 + 2.0 * wet);
    float highlight = frame.specular * pow(max(dot(mirrored, lamp), 0.0), shininess);
    colour = finish(mix(body, image, mirrorShare(cosine, material.refractiveIndex)) + highlight, 1.0);
}
