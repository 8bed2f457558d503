// The weld as a file for other programs: glTF and PLY.
#pragma once

#include "core/training/trainer/lesson_scene.hpp"

#include <filesystem>

namespace meltpool {

enum class MeshFormat { Glb, Gltf, Ply };

/// Format by the ending of the name. Throws InputError for any other than .glb, .gltf and .ply.
MeshFormat meshFormat(const std::filesystem::path& file);

/// Writes the bodies of the scene's metal in its present state (bodyMesh()), with the colours of the lesson's look
/// (surfaceColours()), in the format of the file's ending. Waits for the GPU. Throws whatever writeFile() throws,
/// InputError for an unknown ending, RuntimeFault when there is no metal to show.
void writeMesh(gl::ShaderLibrary& shaders, LessonScene& scene, const std::filesystem::path& file);

} // namespace meltpool
