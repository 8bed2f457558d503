// Writes only the depth.
#version 450 core

void main() {
}
