#include "app/export/ply.hpp"

#include "app/export/little_endian.hpp"
#include "core/base/text.hpp"

#include <cmath>

namespace meltpool {

namespace {

constexpr float kPerMetre = 1000; // mm
constexpr size_t kMostNoteBytes = 200;

/// Share as displayed, by IEC 61966-2-1.
float shownShare(float light) {
    return light <= 0.0031308F ? 12.92F * light : 1.055F * std::pow(light, 1 / 2.4F) - 0.055F;
}

std::string header(const ColouredMesh& coloured) {
    const auto note = [](const std::string& text) { return printable(text, kMostNoteBytes); };
    const MeshNotes& notes = coloured.notes;
    std::string text = "ply\nformat binary_little_endian 1.0\n";
    text += "comment Meltpool " + note(notes.program) + ", lesson " + note(notes.lesson) + ", " + note(notes.date);
    text += std::string("\ncomment unit mm; ") + kMeshAxes;
    text += "\nelement vertex " + std::to_string(coloured.mesh.vertices.size()) + "\n";
    for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
        text += std::string("property float ") + name + "\n";
    for (const char* name : {"red", "green", "blue"})
        text += std::string("property uchar ") + name + "\n";
    text += "element face " + std::to_string(coloured.mesh.indices.size() / 3) + "\n";
    return text + "property list uchar int vertex_indices\nend_header\n";
}

} // namespace

std::string plyOf(const ColouredMesh& coloured) {
    const MeshCopy& mesh = coloured.mesh;
    std::string bytes = header(coloured);
    bytes.reserve(bytes.size() + mesh.vertices.size() * 27 + mesh.indices.size() / 3 * 13);
    for (size_t i = 0; i < mesh.vertices.size(); ++i) {
        appendFloats(bytes, mesh.vertices[i].position * kPerMetre);
        appendFloats(bytes, mesh.vertices[i].normal);
        for (int part = 0; part < 3; ++part)
            appendBytes(bytes, shareOf(shownShare(coloured.colours[i][part]), 255), 1);
    }
    for (size_t i = 0; i < mesh.indices.size(); ++i) {
        if (i % 3 == 0) appendBytes(bytes, 3, 1);
        appendBytes(bytes, mesh.indices[i], 4);
    }
    return bytes;
}

} // namespace meltpool
