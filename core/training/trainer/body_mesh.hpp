// The bodies of a metal as a mesh for files and other programs.
#pragma once

#include "core/surface/mesh_copy.hpp"
#include "core/training/trainer/lesson_metal.hpp"

namespace meltpool {

/// The outside of every body that the metal is now: closed, in m, turned as it lies in the workshop with y upwards.
/// Hollows inside are left out (outerBodies()). Waits for the GPU.
///
/// Metal whose particles lie on a lattice gets a grid that follows their spacing, and not that of the pictures: in a
/// grid much finer than the particles, these do not reach each other and the metal is a sponge of inner walls. Other
/// metal has the surface `shown`, closed at its box. Throws RuntimeFault when the mesh does not fit its buffers.
MeshCopy bodyMesh(gl::ShaderLibrary& shaders, const LessonMetal& metal, const SurfaceParameters& shown);

/// The parameters of such a surface around particles this far apart in this box, both in one unit.
SurfaceParameters bodySurface(float spacing, glm::vec3 boxMin, glm::vec3 boxMax);

} // namespace meltpool
