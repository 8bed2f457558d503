// Wax: light scatters inside and comes out in a warm colour; thin parts are translucent. Molten wax is clear, amber and
// glossy.
#version 450 core
#extension GL_GOOGLE_include_directive : require
#include "render/translucent.glsl"

void main() {
    vec3 n = normalize(normal);
    vec3 along = normalize(way);
    vec3 lamp = normalize(toLamp);
    MeltShares share = meltShares(temperature);
    Passage p = passThrough(along, n, material.refractiveIndex);

    // Scattering softens the edge of the shadow and colours it: red light scatters farthest.
    float facing = dot(n, lamp);
    vec3 wrap = vec3(0.55, 0.36, 0.20);
    vec3 soft = max((facing + wrap) / (1.0 + wrap), 0.0);
    vec3 wax = materialColour(share.colour);
    vec3 skin = wax * (frame.ambient * mix(vec3(1.0), skyLight(n), 0.5) + frame.diffuse * soft);

    // Light from the other side: room and lamp, absorbed over the thickness, so that edges and drops are warmer and
    // brighter than the thick body.
    vec3 through = exp(-material.absorption * p.distance);
    float against = 0.5 + 1.5 * pow(max(dot(along, lamp), 0.0), 3.0) + 0.5 * max(-facing, 0.0);
    vec3 room = 0.5 * (skyLight(along) + skyLight(vec3(0.0, 1.0, 0.0)));
    vec3 glowing = through * (room + frame.diffuse * against) * toLinear(vec3(1.0, 0.78, 0.50));
    vec3 solid = skin + 0.55 * glowing;

    vec3 clear = environmentAt(p.exitDirection, 1.0) * exp(-material.absorption * 0.3 * p.distance);
    vec3 molten = 0.55 * skin + 0.5 * clear + 0.6 * glowing;
    vec3 body = mix(solid, molten, share.mirror);

    float cosine = max(-dot(along, n), 0.0);
    vec3 mirrored = reflect(along, n);
    vec3 image = environmentAt(mirrored, 1.0 + 3.0 * (1.0 - share.mirror));
    float shininess = mix(0.35, 1.5, share.mirror) * frame.shininess;
    float highlight = frame.specular * mix(0.22, 0.9, share.mirror) * pow(max(dot(mirrored, lamp), 0.0), shininess);
    float mirror = mirrorShare(cosine, material.refractiveIndex) * mix(0.6, 1.0, share.mirror);
    colour = finish(mix(body, image, mirror) + highlight, 1.0);
}
