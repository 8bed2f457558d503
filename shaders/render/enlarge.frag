// A finished picture over the whole viewport, which may have more pixels: displayed values, so that the filter works on
// the values that the eye sees.
#version 450 core

layout(location = 0) in vec2 place; // -1..1
layout(location = 0) out vec4 colour;
layout(binding = 0) uniform sampler2D picture;

void main() { colour = texture(picture, 0.5 * place + 0.5); }
