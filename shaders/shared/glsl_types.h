// Lets C++ and GLSL read the same struct definitions: GLSL's type names for C++.
#ifndef MELTPOOL_SHARED_GLSL_TYPES_H
#define MELTPOOL_SHARED_GLSL_TYPES_H

#ifdef __cplusplus
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace meltpool {
using glm::ivec2;
using glm::ivec3;
using glm::ivec4;
using glm::mat4;
using glm::uvec2;
using glm::uvec3;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using uint = unsigned int;
} // namespace meltpool
#endif

#endif
