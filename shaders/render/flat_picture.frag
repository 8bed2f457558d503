// A flat picture in space, written as displayed values. Its colours are multiplied by their alpha. Four samples a pixel
// keep text readable where the window has fewer pixels than the picture.
#version 450 core

layout(location = 0) in vec2 place; // 0..1
layout(location = 0) out vec4 colour;
layout(binding = 0) uniform sampler2D picture;

uniform int decoded; // 1: the texture's displayed values are decoded into light

vec3 displayed(vec3 light) {
    return mix(12.92 * light, 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, step(vec3(0.0031308), light));
}

void main() {
    vec2 right = 0.25 * dFdx(place), up = 0.25 * dFdy(place);
    colour = 0.25 * (texture(picture, place + right + up) + texture(picture, place + right - up) +
                     texture(picture, place - right + up) + texture(picture, place - right - up));
    if (decoded == 1) colour.rgb = displayed(colour.rgb);
}
