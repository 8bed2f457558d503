#version 450 core
// Empty pass: the benchmark measures the cost of a dispatch itself.
layout(local_size_x = 64) in;
void main() {}
