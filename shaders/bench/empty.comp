#version 450 core
// Does nothing: the benchmark measures what a dispatch itself costs.
layout(local_size_x = 64) in;
void main() {}
