// Part of the picture that the eye cannot see, at the nearest depth: nothing is drawn over it.
#version 450 core

layout(location = 0) in vec2 corner; // in the plane z = -1 of the eye
uniform mat4 eyeToClip;

void main() {
    vec4 place = eyeToClip * vec4(corner, -1.0, 1.0);
    gl_Position = vec4(place.xy, -place.w, place.w);
}
