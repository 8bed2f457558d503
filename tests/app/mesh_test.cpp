// The exported weld mesh of `run --mesh`, read by a reader in this file and by assimp.
#include "app/export/gltf.hpp"
#include "app/export/ply.hpp"
#include "core/base/text.hpp"
#include "tests/app/program.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <cstring>
#include <map>

using namespace meltpool;
using meltpool::test::containsText;
using meltpool::test::runMeltpool;

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Contents of a mesh file, in the file's own unit.
struct ReadMesh {
    std::vector<glm::vec3> positions, normals, colours;
    std::vector<std::uint32_t> indices;
};

template <class T>
T numberAt(const std::string& bytes, size_t offset) {
    T value{};
    REQUIRE(offset + sizeof value <= bytes.size());
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

/// Reads `count` vectors of three `T`, `stride` bytes apart.
template <class T>
std::vector<glm::vec3> vectorsAt(const std::string& bytes, size_t offset, size_t count, size_t stride, float scale) {
    std::vector<glm::vec3> values(count);
    for (size_t i = 0; i < count; ++i)
        for (int axis = 0; axis < 3; ++axis)
            values[i][axis] =
                scale *
                static_cast<float>(numberAt<T>(bytes, offset + i * stride + static_cast<size_t>(axis) * sizeof(T)));
    return values;
}

/// Returns a file's document and its buffer; the first chunk is JSON, the second binary.
std::pair<Json, std::string> splitGlb(const std::string& bytes) {
    REQUIRE(bytes.substr(0, 4) == "glTF");
    REQUIRE(numberAt<std::uint32_t>(bytes, 4) == 2);
    REQUIRE(numberAt<std::uint32_t>(bytes, 8) == bytes.size());
    const size_t json = numberAt<std::uint32_t>(bytes, 12);
    REQUIRE(bytes.substr(16, 4) == "JSON");
    REQUIRE(json % 4 == 0);
    const size_t binary = numberAt<std::uint32_t>(bytes, 20 + json);
    REQUIRE(bytes.substr(24 + json, 4) == std::string("BIN\0", 4));
    REQUIRE(binary % 4 == 0);
    REQUIRE(28 + json + binary == bytes.size());
    return {Json::parse(bytes.substr(20, json)), bytes.substr(28 + json)};
}

/// Returns the only mesh of a document, found by its accessors.
ReadMesh readGltf(const Json& gltf, const std::string& buffer) {
    CHECK(gltf.at("asset").at("version") == "2.0");
    CHECK(gltf.at("buffers")[0].at("byteLength").get<size_t>() <= buffer.size());
    const Json& primitive = gltf.at("meshes")[0].at("primitives")[0];
    const auto accessor = [&](const Json& number) { return gltf.at("accessors").at(number.get<size_t>()); };
    const auto offset = [&](const Json& each) {
        const Json& view = gltf.at("bufferViews").at(each.at("bufferView").get<size_t>());
        CHECK(view.at("byteOffset").get<size_t>() % 4 == 0);
        CHECK(view.at("byteOffset").get<size_t>() + view.at("byteLength").get<size_t>() <= buffer.size());
        return view.at("byteOffset").get<size_t>();
    };
    const Json position = accessor(primitive.at("attributes").at("POSITION"));
    const Json normal = accessor(primitive.at("attributes").at("NORMAL"));
    const Json colour = accessor(primitive.at("attributes").at("COLOR_0"));
    const Json index = accessor(primitive.at("indices"));
    const auto count = position.at("count").get<size_t>();
    CHECK(normal.at("count") == count);
    CHECK(colour.at("count") == count);
    CHECK(colour.at("normalized") == true);
    ReadMesh solid;
    solid.positions = vectorsAt<float>(buffer, offset(position), count, 12, 1);
    solid.normals = vectorsAt<float>(buffer, offset(normal), count, 12, 1);
    solid.colours = vectorsAt<std::uint16_t>(buffer, offset(colour), count, 8, 1 / 65535.0F);
    for (size_t i = 0; i < index.at("count").get<size_t>(); ++i)
        solid.indices.push_back(numberAt<std::uint32_t>(buffer, offset(index) + 4 * i));
    glm::vec3 low = solid.positions.front(), high = low;
    for (const glm::vec3& p : solid.positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    for (int axis = 0; axis < 3; ++axis) { // equal to the last bit, as the specification demands
        CHECK(position.at("min").at(static_cast<size_t>(axis)).get<float>() == low[axis]);
        CHECK(position.at("max").at(static_cast<size_t>(axis)).get<float>() == high[axis]);
    }
    return solid;
}

size_t countIn(const std::string& header, const std::string& element) {
    const size_t at = header.find("element " + element + " ");
    REQUIRE(at != std::string::npos);
    return std::stoul(header.substr(at + element.size() + 9));
}

ReadMesh readPly(const std::string& bytes) {
    const std::string end = "end_header\n";
    const size_t body = bytes.find(end) + end.size();
    const std::string header = bytes.substr(0, body);
    REQUIRE(header.starts_with("ply\nformat binary_little_endian 1.0\n"));
    const size_t vertices = countIn(header, "vertex"), faces = countIn(header, "face");
    constexpr size_t kVertex = 27, kFace = 13;
    REQUIRE(bytes.size() == body + vertices * kVertex + faces * kFace);
    ReadMesh solid;
    solid.positions = vectorsAt<float>(bytes, body, vertices, kVertex, 1);
    solid.normals = vectorsAt<float>(bytes, body + 12, vertices, kVertex, 1);
    solid.colours = vectorsAt<std::uint8_t>(bytes, body + 24, vertices, kVertex, 1 / 255.0F);
    for (size_t i = 0; i < faces; ++i) {
        const size_t face = body + vertices * kVertex + i * kFace;
        REQUIRE(bytes[face] == 3);
        for (size_t j = 0; j < 3; ++j)
            solid.indices.push_back(numberAt<std::uint32_t>(bytes, face + 1 + 4 * j));
    }
    return solid;
}

/// Checks that the solid is closed and that every index and number is in range. Returns the volume.
double checkSolid(const ReadMesh& solid) {
    std::map<std::pair<unsigned, unsigned>, int> sides;
    double volume = 0;
    REQUIRE(solid.indices.size() % 3 == 0);
    for (size_t i = 0; i < solid.indices.size(); ++i) {
        REQUIRE(solid.indices[i] < solid.positions.size());
        ++sides[{solid.indices[i], solid.indices[i % 3 == 2 ? i - 2 : i + 1]}];
        if (i % 3 != 2) continue;
        const auto corner = [&](size_t j) { return glm::dvec3(solid.positions[solid.indices[i - j]]); };
        volume += glm::dot(corner(2), glm::cross(corner(1), corner(0))) / 6;
    }
    size_t open = 0;
    for (const auto& [side, count] : sides)
        open += count != 1 || !sides.contains({side.second, side.first});
    CHECK(open == 0);
    for (const glm::vec3& normal : solid.normals)
        REQUIRE(glm::length(normal) == Approx(1).margin(1e-3));
    for (const glm::vec3& colour : solid.colours)
        REQUIRE((glm::all(glm::greaterThanEqual(colour, glm::vec3(0))) &&
                 glm::all(glm::lessThanEqual(colour, glm::vec3(1)))));
    return volume;
}

/// A box from the origin to (0.02, 0.01, 0.04) m, its corners grey and one of them red.
ColouredMesh redCorneredBox() {
    ColouredMesh box;
    const glm::vec3 size(0.02F, 0.01F, 0.04F);
    for (unsigned i = 0; i < 8; ++i) {
        const glm::vec3 corner(i & 1U, i >> 1 & 1U, i >> 2);
        box.mesh.vertices.push_back({corner * size, 300, glm::normalize(corner - 0.5F), 0});
        box.colours.push_back(i == 7 ? glm::vec3(1, 0, 0) : glm::vec3(0.5F));
    }
    box.mesh.indices = {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                        2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6};
    box.notes = {"tee", "2026-03-01T12:00:00Z", "0.1.0 (abc)"};
    return box;
}

bool succeeds(const std::string& command) {
    return std::system((command + " >/dev/null 2>&1").c_str()) == 0;
}

std::string outputOf(const std::string& command) {
    const fs::path kept = test::scratchFolder("assimp-output") / "text";
    CHECK(std::system((command + " >'" + kept.string() + "' 2>&1").c_str()) == 0);
    return readTextFile(kept);
}

/// Checks that another library finds vertices, faces and colours in the file.
void checkWithAssimp(const fs::path& file, const ReadMesh& solid) {
    if (!succeeds("command -v assimp")) {
        if (std::getenv("CI") != nullptr) FAIL("assimp is missing; expected the package assimp-utils");
        WARN("assimp is missing: nobody else has read " << file.filename());
        return;
    }
    const std::string told = outputOf("assimp info '" + file.string() + "' --raw");
    INFO(told);
    const auto number = [&](const std::string& name) {
        const size_t at = told.find(name);
        return at == std::string::npos ? 0 : std::strtoul(told.c_str() + at + name.size(), nullptr, 10);
    };
    CHECK(number("Vertices:") == solid.positions.size());
    CHECK(number("Faces:") == solid.indices.size() / 3);
    // A coloured vertex of a Wavefront file has six numbers.
    const fs::path copy = test::scratchFolder("assimp-copy") / "copy.obj";
    CHECK(succeeds("assimp export '" + file.string() + "' '" + copy.string() + "'"));
    const std::string text = readTextFile(copy);
    const size_t line = text.find("\nv ") + 1;
    const std::string vertex = text.substr(line, text.find('\n', line) - line);
    INFO(vertex);
    CHECK(splitText(trimText(vertex.substr(2)), ' ').size() >= 6);
}

} // namespace

TEST_CASE("a box comes back from glTF with its numbers", "[app]") {
    const ColouredMesh box = redCorneredBox();
    const auto [gltf, buffer] = splitGlb(glbOf(box));
    const ReadMesh solid = readGltf(gltf, buffer);
    CHECK(checkSolid(solid) == Approx(0.02 * 0.01 * 0.04));
    CHECK(solid.indices == box.mesh.indices);
    CHECK(solid.positions[7] == glm::vec3(0.02F, 0.01F, 0.04F));
    CHECK(solid.colours[7] == glm::vec3(1, 0, 0));
    CHECK(solid.colours[0].g == Approx(0.5).margin(1e-4)); // linear value
    const Json& extras = gltf.at("asset").at("extras");
    CHECK(extras.at("lesson") == "tee");
    CHECK(extras.at("date") == "2026-03-01T12:00:00Z");
    CHECK(extras.at("program") == "0.1.0 (abc)");
    CHECK(extras.at("unit") == "m");

    const Json text = Json::parse(gltfOf(box));
    const std::string uri = text.at("buffers")[0].at("uri");
    const std::string prefix = "data:application/octet-stream;base64,";
    REQUIRE(uri.starts_with(prefix));
    CHECK(uri.size() - prefix.size() == (text.at("buffers")[0].at("byteLength").get<size_t>() + 2) / 3 * 4);
    CHECK(text.at("accessors") == gltf.at("accessors"));
}

TEST_CASE("a box comes back from PLY in millimetres and displayed colours", "[app]") {
    ColouredMesh box = redCorneredBox();
    box.notes.lesson = "of two\nlines";
    const std::string bytes = plyOf(box);
    const ReadMesh solid = readPly(bytes);
    CHECK(checkSolid(solid) == Approx(20 * 10 * 40));
    CHECK(solid.colours[7] == glm::vec3(1, 0, 0));
    CHECK(solid.colours[0].g == Approx(188 / 255.0).margin(1e-3)); // half of the light in sRGB
    CHECK_THAT(bytes.substr(0, 300), containsText("comment unit mm") && containsText("lesson of two lines,"));
}

TEST_CASE("another library reads both formats", "[app]") {
    const ColouredMesh box = redCorneredBox();
    const fs::path folder = test::scratchFolder("box");
    writeTextFileAtomically(folder / "box.glb", glbOf(box));
    writeTextFileAtomically(folder / "box.gltf", gltfOf(box));
    writeTextFileAtomically(folder / "box.ply", plyOf(box));
    for (const char* name : {"box.glb", "box.gltf", "box.ply"}) {
        INFO(name);
        checkWithAssimp(folder / name, {box.colours, {}, {}, box.mesh.indices});
    }
}

TEST_CASE("a weld's run leaves its mesh, which another library reads", "[app]") {
    const auto folder = test::scratchFolder("mesh");
    const fs::path file = folder / "out" / "weld.glb"; // the run makes this folder
    const fs::path torch = folder / "short.toml";
    writeTextFileAtomically(torch, "start_mm = [-2, 3, 0]\n"
                                   "[[move]]\nkind = 'arc_on'\n"
                                   "[[move]]\nkind = 'line'\nto_mm = [2, 3, 0]\nspeed_mm_s = 6\n");
    const test::Outcome outcome =
        runMeltpool("run gmaw-bead --size 160x120 --pictures 0 --seconds 0.4 --set length_mm=24 --set width_mm=20 "
                    "--set thickness_mm=4 --set cells=24 --torch '" +
                    torch.string() + "' --out '" + (folder / "out").string() + "' --mesh '" + file.string() + "'");
    INFO(outcome.errors);
    REQUIRE(outcome.code == 0);
    CHECK_THAT(outcome.output, containsText("weld.glb"));
    const auto [gltf, buffer] = splitGlb(readTextFile(file));
    const ReadMesh solid = readGltf(gltf, buffer);
    CHECK(checkSolid(solid) * 1e9 == Approx(1920).epsilon(0.08)); // mm³, deposit included
    CHECK(gltf.at("asset").at("extras").at("lesson") == "gmaw-bead");
    glm::vec3 darkest(1), brightest(0);
    for (const glm::vec3& colour : solid.colours) {
        darkest = glm::min(darkest, colour);
        brightest = glm::max(brightest, colour);
    }
    CHECK(brightest.r > darkest.r + 0.1F); // pool and plate differ
    checkWithAssimp(file, solid);
}

TEST_CASE("the classic metal's run leaves its mesh too", "[app]") {
    const auto folder = test::scratchFolder("classic-mesh");
    for (const char* name : {"cube.ply", "cube.gltf"}) {
        INFO(name);
        const test::Outcome outcome =
            runMeltpool("run classic --size 160x120 --set cells=24 --set particles=2744 --set support_radius=0.1 "
                        "--seconds 0.1 --pictures 0 --out '" +
                        (folder / "out").string() + "' --mesh '" + (folder / name).string() + "'");
        INFO(outcome.errors);
        REQUIRE(outcome.code == 0);
    }
    const ReadMesh solid = readPly(readTextFile(folder / "cube.ply"));
    CHECK(checkSolid(solid) > 1000); // mm³
    checkWithAssimp(folder / "cube.ply", solid);
    checkWithAssimp(folder / "cube.gltf", solid);
}

TEST_CASE("a mesh that cannot be written is refused before the run, and told after it", "[app]") {
    const auto folder = test::scratchFolder("mesh-refused");
    const std::string quick =
        "run classic --size 160x120 --set cells=24 --set particles=64 --seconds 0.1 --pictures 0 ";
    const std::string out = "--out '" + (folder / "out").string() + "' ";
    for (const char* name : {"weld.stl", "weld", "weld.ply.gz", ".ply"}) {
        INFO(name);
        const test::Outcome outcome = runMeltpool(quick + out + "--mesh " + name);
        CHECK(outcome.code == 2);
        CHECK_THAT(outcome.errors,
                   containsText(name) && containsText("expected a file that ends in .glb, .gltf or .ply"));
        CHECK_FALSE(fs::exists(folder / "out"));
    }
    const test::Outcome nowhere = runMeltpool(quick + out + "--mesh /no/such/folder/weld.ply");
    CHECK(nowhere.code == 2);
    CHECK_THAT(nowhere.errors, containsText("/no/such/folder/weld.ply") && containsText("expected"));
    fs::create_directories(folder / "folder.glb");
    const test::Outcome taken = runMeltpool(quick + out + "--mesh '" + (folder / "folder.glb").string() + "'");
    CHECK(taken.code == 2);
    // The size in KiB is enough for the record's rows and too small for a mesh. The picture before it is the smallest.
    const test::Outcome full = runMeltpool(
        "run classic --size 16x16 --set cells=24 --set particles=2744 --set support_radius=0.1 --seconds 0.05 "
        "--pictures 0 " +
            out + "--mesh '" + (folder / "weld.gltf").string() + "'",
        "ulimit -f 24;");
    CHECK(full.code == 1);
    CHECK_THAT(full.errors, containsText("weld.gltf: cannot be written to its end"));
    CHECK_FALSE(fs::exists(folder / "weld.gltf"));
    CHECK(Json::parse(readTextFile(folder / "out" / "result.json")).at("finished") == false);
}
