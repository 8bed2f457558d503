// The finer torch and the hands: they follow the pose, remain behind the cylinders that shadow and reflection use, and
// leave the pool visible.
#include "core/render/frame_block.hpp"
#include "core/render/line_of_sight.hpp"
#include "core/render/solid_meshes.hpp"
#include "core/scene/torch_fittings.hpp"
#include "core/scene/torch_model.hpp"
#include "core/scene/workshop_furniture.hpp"
#include "core/weld/torch/torch_moves.hpp"
#include "tests/support/catch.hpp"

#include <glm/ext/matrix_transform.hpp>

#include <algorithm>

using namespace meltpool;

namespace {

ProcessSettings with(int kind) {
    ProcessSettings settings;
    settings.kind = kind;
    return settings;
}

TorchSample leaning() {
    TorchSample torch;
    torch.tip = {0.01f, 0.003f, -0.02f};
    torch.orientation = heldOrientation(0.9, 0.2, {1, 0, 0});
    return torch;
}

/// Returns the least distance of a shape's surface to a place.
float distanceTo(const SolidMeshes& meshes, const Solid& solid, glm::vec3 place) {
    const SolidMeshes::Range range = meshes.shapes[static_cast<size_t>(solid.shape)];
    float least = 1e9f;
    for (int i = range.first; i < range.first + range.count; ++i) {
        const SolidVertex& vertex = meshes.vertices[meshes.indices[static_cast<size_t>(i)]];
        least = std::min(least, glm::distance(glm::vec3(solid.toWorld * glm::vec4(vertex.position, 1)), place));
    }
    return least;
}

} // namespace

TEST_CASE("every shape is closed, looks outwards and fits into its box") {
    const SolidMeshes meshes = makeSolidMeshes();
    for (size_t shape = 0; shape < kSolidShapes; ++shape) {
        const SolidMeshes::Range range = meshes.shapes[shape];
        REQUIRE(range.count > 0);
        double volume = 0; // by the divergence theorem, positive if triangles face outwards
        for (int i = range.first; i < range.first + range.count; i += 3) {
            const auto at = [&](int corner) {
                return meshes.vertices[meshes.indices[static_cast<size_t>(i + corner)]];
            };
            const glm::vec3 a = at(0).position, b = at(1).position, c = at(2).position;
            const glm::vec3 face = glm::cross(b - a, c - a);
            volume += static_cast<double>(glm::dot(a, face)) / 6;
            if (glm::length(face) < 1e-7f) continue; // degenerate triangle at a pole
            CHECK(glm::dot(face, at(0).normal + at(1).normal + at(2).normal) > 0);
            for (int corner = 0; corner < 3; ++corner) {
                CHECK(glm::length(at(corner).normal) == Approx(1).margin(1e-4));
                if (static_cast<SolidShape>(shape) != SolidShape::bend)
                    CHECK(glm::all(glm::lessThanEqual(glm::abs(at(corner).position), glm::vec3(0.50001f))));
            }
        }
        const auto kind = static_cast<SolidShape>(shape);
        if (kind == SolidShape::slab || kind == SolidShape::chalk) continue; // these have a single face
        INFO("shape " << shape << ", volume " << volume);
        CHECK(volume > 0.05);
        CHECK(volume < (static_cast<SolidShape>(shape) == SolidShape::bend ? 3 : 1.0001));
    }
}

TEST_CASE("fittings move and turn with the torch, and none but its own head comes near the tip") {
    const SolidMeshes meshes = makeSolidMeshes();
    for (int kind = 0; kind < int(AllProcesses::kCount); ++kind) {
        const ProcessSettings process = with(kind);
        const TorchSample torch = leaning();
        TorchSurroundings around;
        around.cableEnd = kCableEnd;
        std::vector<Solid> solids, coarse;
        buildTorchFittings(solids, torch, process, around, glm::mat4(1));
        REQUIRE(solids.size() > 15);
        CHECK(solids.size() < 80);
        size_t near = 0;
        for (const Solid& solid : solids) {
            CHECK_FALSE(solid.coarse);
            const float away = distanceTo(meshes, solid, torch.tip);
            CHECK(away > 0.004f);
            near += away < 0.06f;
        }
        CHECK(near < 8);
        // The shadow and the pool's reflection use the torch's cylinders with and without fittings.
        SceneView scene;
        buildTorchModel(coarse, torch, process, {}, glm::mat4(1));
        scene.solids = coarse;
        const FrameData without = makeFrame(scene, {});
        scene.fittings = solids;
        CHECK(makeFrame(scene, {}).torchPartCount == without.torchPartCount);
        CHECK(without.torchPartCount >= 2);
        CHECK(std::any_of(coarse.begin(), coarse.end(), [](const Solid& solid) { return solid.coarse; }));
        if (traitsOf(process).torch == TorchShape::burner) continue; // all but the flame's burner
        CHECK(std::any_of(coarse.begin(), coarse.end(), [](const Solid& solid) { return !solid.coarse; }));
    }
}

TEST_CASE("a tracked hand takes the handle with it") {
    ProcessSettings gmaw;
    gmaw.choose<Gmaw>();
    TorchSurroundings around;
    const TorchSample torch = leaning();
    const SolidMeshes meshes = makeSolidMeshes();
    around.hand = TrackedHand{.place = torch.tip - torch.axis() * 0.2f + glm::vec3(0.1f, 0.02f, 0.05f)};
    std::vector<Solid> solids;
    buildTorchFittings(solids, torch, gmaw, around, glm::mat4(1));
    float nearest = 1e9f;
    for (const Solid& solid : solids)
        nearest = std::min(nearest, distanceTo(meshes, solid, around.hand->place));
    CHECK(nearest < 0.02f);
}

TEST_CASE("what stands before the tip is known") {
    Solid rod;
    rod.shape = SolidShape::cylinder;
    rod.toWorld = alongLine({-1, 0, 0.5f}, {1, 0, 0.5f}, 0.2f);
    CHECK(standsBefore(rod, {0, 0, 1}, {0, 0, 0}, 0.01f));
    CHECK_FALSE(standsBefore(rod, {0, 0.3f, 1}, {0, 0.3f, 0}, 0.01f));
    CHECK_FALSE(standsBefore(rod, {0, 0, 0.2f}, {0, 0, 0}, 0.01f)); // the eye is between both
    CHECK(standsBefore(rod, {0, 0.05f, 0.5f}, {0, 4, 0}, 0.01f));   // the eye is inside the solid
}

TEST_CASE("the machine shows the settings of its process") {
    ProcessSettings process;
    process.choose<Gmaw>().voltage = 23;
    CHECK(equipmentOf(process).displays[0].value == 23);
    std::vector<Solid> solids, others;
    addMachine(solids, glm::mat4(1), process);
    process.of<Gmaw>().voltage = 11.1f; // the digit 1 has fewer strokes
    addMachine(others, glm::mat4(1), process);
    const auto lit = [](const std::vector<Solid>& all) {
        return std::count_if(all.begin(), all.end(), [](const Solid& solid) { return solid.glow.r > 0; });
    };
    CHECK(lit(solids) > lit(others));
    CHECK(lit(others) > 5);
    process.choose<Flame>();
    others.clear();
    addMachine(others, glm::mat4(1), process);
    CHECK(others.empty());
}

TEST_CASE("the table stands on the floor, what holds the plate on the table, and none of it in the plate or the weld") {
    WorkpieceParameters parameters;
    const Workpiece piece = makeWorkpiece(parameters);
    std::vector<Solid> table, holders;
    const float top = piece.floorHeight;
    addTable(table, glm::translate(glm::mat4(1), {0, top, 0}), 0.9f);
    addHolders(holders, glm::mat4(1), piece, 0);
    REQUIRE_FALSE(holders.empty());
    const SolidMeshes meshes = makeSolidMeshes();
    const auto lowest = [&](const std::vector<Solid>& solids) {
        float low = 1e9f;
        for (const Solid& solid : solids)
            for (const float x : {-0.5f, 0.5f})
                for (const float y : {-0.5f, 0.5f})
                    for (const float z : {-0.5f, 0.5f})
                        low = std::min(low, (solid.toWorld * glm::vec4(x, y, z, 1)).y);
        return low;
    };
    std::erase_if(table, [](const Solid& solid) { return solid.shape == SolidShape::slab; });
    CHECK(lowest(table) == Approx(top - 0.9f).margin(1e-5));
    CHECK(lowest(holders) == Approx(top).margin(1e-5));
    for (const Solid& solid : holders) {
        const SolidMeshes::Range range = meshes.shapes[static_cast<size_t>(solid.shape)];
        for (int i = range.first; i < range.first + range.count; ++i) {
            const glm::vec3 at = solid.toWorld * glm::vec4(meshes.vertices[meshes.indices[size_t(i)]].position, 1);
            for (const WorkpieceBlock& block : piece.blocks)
                CHECK_FALSE((glm::all(glm::greaterThan(at, block.low + 1e-4f)) &&
                             glm::all(glm::lessThan(at, block.high - 1e-4f))));
            CHECK((at.y < piece.bodyHigh.y - 1e-5f || std::abs(at.z) > 0.005f)); // no part is over the seam
        }
    }
}
