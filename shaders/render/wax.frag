// Wax: light goes in, wanders and comes out warm; thin parts glow through. Molten wax is clear, amber and glossy.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/translucent.glsl"

void main() {
    vec3 n = normalize(normal);
    vec3 along = normalize(way);
    vec3 lamp = normalize(toLamp);
    vec2 share = meltShares(temperature);
    Passage p = passThrough(along, n, material.refractiveIndex);

    // Scattered light softens the shadow's edge and colours it: red travels farthest.
    float facing = dot(n, lamp);
    vec3 wrap = vec3(0.55, 0.36, 0.20);
    vec3 soft = max((facing + wrap) / (1.0 + wrap), 0.0);
    vec3 wax = materialColour(share.x);
    vec3 skin = wax * (frame.ambient * mix(vec3(1.0), skyLight(n), 0.5) + frame.diffuse * soft);

    // What wanders through from the other side: the room and the lamp, dimmed over the thickness, so that edges and
    // drops glow warmer and brighter than the thick body.
    vec3 through = exp(-material.absorption * p.distance);
    float against = 0.5 + 1.5 * pow(max(dot(along, lamp), 0.0), 3.0) + 0.5 * max(-facing, 0.0);
    vec3 room = 0.5 * (skyLight(along) + skyLight(vec3(0.0, 1.0, 0.0)));
    vec3 glowing = through * (room + frame.diffuse * against) * toLinear(vec3(1.0, 0.78, 0.50));
    vec3 solid = skin + 0.55 * glowing;

    vec3 clear = environmentAt(p.exitWay, 1.0) * exp(-material.absorption * 0.3 * p.distance);
    vec3 molten = 0.55 * skin + 0.5 * clear + 0.6 * glowing;
    vec3 body = mix(solid, molten, share.y);

    float cosine = max(-dot(along, n), 0.0);
    vec3 mirrored = reflect(along, n);
    vec3 image = environmentAt(mirrored, 1.0 + 3.0 * (1.0 - share.y));
    float shininess = mix(0.35, 1.5, share.y) * frame.shininess;
    float highlight = frame.specular * mix(0.22, 0.9, share.y) * pow(max(dot(mirrored, lamp), 0.0), shininess);
    float mirror = mirrorShare(cosine, material.refractiveIndex) * mix(0.6, 1.0, share.y);
    colour = finish(mix(body, image, mirror) + highlight, 1.0);
}
