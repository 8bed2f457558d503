// Converts the bodies of a metal to a mesh for files and other programs.
#pragma once

#include "core/surface/mesh_copy.hpp"
#include "core/training/trainer/lesson_metal.hpp"

namespace meltpool {

/// The outside of every present body of the metal: closed, in m, turned as it is in the workshop with y upwards.
/// Hollows inside are left out (outerBodies()). Waits for the GPU.
///
/// Metal with particles on a lattice gets a grid that follows their spacing, not that of the pictures: in a grid much
/// finer than the particles, these do not reach each other and the metal is a sponge of inner walls. Other metal has
/// the surface `shown`, closed at its box. Throws RuntimeFault if the mesh does not fit its buffers.
MeshCopy bodyMesh(gl::ShaderLibrary& shaders, const LessonMetal& metal, const SurfaceParameters& shown);

/// Parameters of such a surface, for this particle spacing and box, both in one unit.
SurfaceParameters bodySurface(float spacing, glm::vec3 boxMin, glm::vec3 boxMax);

} // namespace meltpool
