#include "app/export/gltf.hpp"

#include "app/export/little_endian.hpp"

#include <glm/common.hpp>
#include <nlohmann/json.hpp>

#include <array>

namespace meltpool {

namespace {

using Json = nlohmann::json;

// Numbers of the specification.
constexpr int kFloat = 5126, kUnsignedShort = 5123, kUnsignedInt = 5125;
constexpr int kVertexAttributes = 34962, kElements = 34963;
constexpr std::uint32_t kMagic = 0x46546C67, kVersion = 2, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

/// Binary buffer and the views into it.
struct Blob {
    std::string bytes;
    Json views = Json::array();

    /// Adds the view of the bytes appended since `begin`; returns its number.
    size_t endView(size_t begin, int target) {
        views.push_back(
            {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", bytes.size() - begin}, {"target", target}});
        return views.size() - 1;
    }
};

Json accessor(size_t view, int componentType, size_t count, const char* type) {
    return {{"bufferView", view}, {"componentType", componentType}, {"count", count}, {"type", type}};
}

Json listOf(const glm::vec3& v) {
    return {v.x, v.y, v.z};
}

Json addPositions(Blob& blob, const MeshCopy& mesh) {
    const size_t begin = blob.bytes.size();
    glm::vec3 low = mesh.vertices.front().position, high = low;
    for (const SurfaceVertex& vertex : mesh.vertices) {
        appendFloats(blob.bytes, vertex.position);
        low = glm::min(low, vertex.position);
        high = glm::max(high, vertex.position);
    }
    Json positions = accessor(blob.endView(begin, kVertexAttributes), kFloat, mesh.vertices.size(), "VEC3");
    positions["min"] = listOf(low);
    positions["max"] = listOf(high);
    return positions;
}

Json addNormals(Blob& blob, const MeshCopy& mesh) {
    const size_t begin = blob.bytes.size();
    for (const SurfaceVertex& vertex : mesh.vertices)
        appendFloats(blob.bytes, vertex.normal);
    return accessor(blob.endView(begin, kVertexAttributes), kFloat, mesh.vertices.size(), "VEC3");
}

/// Adds colours with a fourth component: every vertex has to begin at a multiple of four bytes.
Json addColours(Blob& blob, const ColouredMesh& coloured) {
    constexpr float kMost = 65535;
    const size_t begin = blob.bytes.size();
    for (const glm::vec3& colour : coloured.colours) {
        for (int part = 0; part < 3; ++part)
            appendBytes(blob.bytes, shareOf(colour[part], kMost), 2);
        appendBytes(blob.bytes, shareOf(1, kMost), 2);
    }
    Json colours = accessor(blob.endView(begin, kVertexAttributes), kUnsignedShort, coloured.colours.size(), "VEC4");
    colours["normalized"] = true;
    return colours;
}

Json addIndices(Blob& blob, const MeshCopy& mesh) {
    const size_t begin = blob.bytes.size();
    for (const std::uint32_t index : mesh.indices)
        appendBytes(blob.bytes, index, 4);
    return accessor(blob.endView(begin, kElements), kUnsignedInt, mesh.indices.size(), "SCALAR");
}

/// Document without its buffer.
Json document(const ColouredMesh& coloured, Blob& blob) {
    const MeshNotes& notes = coloured.notes;
    Json gltf;
    gltf["asset"] = {{"version", "2.0"},
                     {"generator", "Meltpool " + notes.program},
                     {"extras",
                      {{"lesson", notes.lesson},
                       {"date", notes.date},
                       {"program", notes.program},
                       {"unit", "m"},
                       {"axes", kMeshAxes}}}};
    gltf["accessors"] = Json::array({addPositions(blob, coloured.mesh), addNormals(blob, coloured.mesh),
                                     addColours(blob, coloured), addIndices(blob, coloured.mesh)});
    gltf["bufferViews"] = blob.views;
    const Json dull = {{"metallicFactor", 0.0}, {"roughnessFactor", 0.6}};
    gltf["materials"] = Json::array({{{"name", "metal"}, {"pbrMetallicRoughness", dull}}});
    const Json primitive = {
        {"attributes", {{"POSITION", 0}, {"NORMAL", 1}, {"COLOR_0", 2}}}, {"indices", 3}, {"material", 0}, {"mode", 4}};
    gltf["meshes"] = Json::array({{{"name", notes.lesson}, {"primitives", Json::array({primitive})}}});
    gltf["nodes"] = Json::array({{{"name", notes.lesson}, {"mesh", 0}}});
    gltf["scenes"] = Json::array({{{"nodes", Json::array({0})}}});
    gltf["scene"] = 0;
    return gltf;
}

/// A lesson's name may come from a file's name, which need not be UTF-8.
std::string textOf(const Json& value) {
    return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Pads `text` to a multiple of four bytes.
std::string padded(std::string text, char filler) {
    text.resize((text.size() + 3) / 4 * 4, filler);
    return text;
}

void appendChunk(std::string& bytes, std::uint32_t type, const std::string& content) {
    appendBytes(bytes, static_cast<std::uint32_t>(content.size()), 4);
    appendBytes(bytes, type, 4);
    bytes += content;
}

/// Base64 by RFC 4648.
std::string base64(const std::string& bytes) {
    constexpr const char* kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (size_t j = 0; j < 3; ++j)
            group = group << 8 | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0U);
        for (size_t j = 0; j < 4; ++j)
            text += i + j <= bytes.size() ? kLetters[group >> (18 - 6 * j) & 63U] : '=';
    }
    return text;
}

} // namespace

std::string glbOf(const ColouredMesh& coloured) {
    Blob blob;
    Json gltf = document(coloured, blob);
    gltf["buffers"] = Json::array({{{"byteLength", blob.bytes.size()}}});
    const std::string json = padded(textOf(gltf), ' '), binary = padded(std::move(blob.bytes), '\0');
    std::string bytes;
    bytes.reserve(json.size() + binary.size() + 28);
    appendBytes(bytes, kMagic, 4);
    appendBytes(bytes, kVersion, 4);
    appendBytes(bytes, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + binary.size()), 4);
    appendChunk(bytes, kJsonChunk, json);
    appendChunk(bytes, kBinaryChunk, binary);
    return bytes;
}

std::string gltfOf(const ColouredMesh& coloured) {
    Blob blob;
    Json gltf = document(coloured, blob);
    gltf["buffers"] = Json::array(
        {{{"byteLength", blob.bytes.size()}, {"uri", "data:application/octet-stream;base64," + base64(blob.bytes)}}});
    return textOf(gltf);
}

} // namespace meltpool
