#include "app/export/mesh_file.hpp"

#include "app/export/gltf.hpp"
#include "app/export/ply.hpp"
#include "app/platform/program_info.hpp"
#include "core/base/error.hpp"
#include "core/base/moment.hpp"
#include "core/base/output_file.hpp"
#include "core/base/text.hpp"
#include "core/render/surface_colours.hpp"
#include "core/training/trainer/body_mesh.hpp"

namespace meltpool {

namespace {

std::vector<glm::vec2> heatsOf(const MeshCopy& mesh) {
    std::vector<glm::vec2> heats;
    heats.reserve(mesh.vertices.size());
    for (size_t i = 0; i < mesh.vertices.size(); ++i)
        heats.emplace_back(mesh.vertices[i].temperature, mesh.peaks.empty() ? 0.0F : mesh.peaks[i]);
    return heats;
}

std::string bytesOf(const ColouredMesh& mesh, MeshFormat format) {
    switch (format) {
    case MeshFormat::Glb:
        return glbOf(mesh);
    case MeshFormat::Gltf:
        return gltfOf(mesh);
    case MeshFormat::Ply:
        break;
    }
    return plyOf(mesh);
}

} // namespace

MeshFormat meshFormat(const std::filesystem::path& file) {
    const std::filesystem::path ending = file.extension();
    if (ending == ".glb") return MeshFormat::Glb;
    if (ending == ".gltf") return MeshFormat::Gltf;
    if (ending == ".ply") return MeshFormat::Ply;
    throw InputError(file, 0, "is no name of a mesh; expected a file that ends in .glb, .gltf or .ply");
}

void writeMesh(gl::ShaderLibrary& shaders, LessonScene& scene, const std::filesystem::path& file) {
    const MeshFormat format = meshFormat(file);
    ColouredMesh coloured;
    const Trainer& trainer = scene.trainer();
    coloured.mesh = bodyMesh(shaders, trainer.metal(), trainer.lesson().surface);
    if (coloured.mesh.indices.empty())
        throw RuntimeFault(printable(file.string(), 200) + ": no metal is left whose surface could be written");
    const std::vector<glm::vec2> heats = heatsOf(coloured.mesh);
    coloured.colours = surfaceColours(shaders, scene.view(), trainer.lesson().look, heats);
    coloured.notes = {printable(trainer.lesson().key, 200), utcSecond(momentNow()), programBuild()};
    writeFile(file, bytesOf(coloured, format));
}

} // namespace meltpool
