// The torch in a tracked hand: one table of lengths gives the drawn torch and the place of its tip.
#include "core/render/solid_meshes.hpp"
#include "core/scene/torch_fittings.hpp"
#include "core/scene/torch_geometry.hpp"
#include "tests/support/catch.hpp"

#include <glm/geometric.hpp>

#include <algorithm>

using namespace meltpool;

namespace {

ProcessSettings with(int kind) {
    ProcessSettings settings;
    settings.kind = kind;
    return settings;
}

/// A hand somewhere in the room; its handle leads back along +z of its own frame.
struct Held {
    glm::quat turn = glm::normalize(glm::quat(0.8f, -0.4f, 0.3f, 0.1f));
    TrackedHand hand{{0.2f, 1.1f, 0.3f}, turn* glm::vec3(1, 0, 0), turn* glm::vec3(0, 0, 1), true};

    TorchSample torch(const TorchGeometry& geometry) const {
        TorchSample sample;
        sample.tip = hand.place + turn * geometry.tip();
        sample.orientation = turn * geometry.tipOrientation();
        return sample;
    }
    std::vector<Solid> drawn(const TorchSample& torch, const ProcessSettings& process) const {
        TorchSurroundings around;
        around.hand = hand;
        around.cableEnd = {-0.6f, 0.6f, 0};
        std::vector<Solid> solids;
        buildTorchFittings(solids, torch, process, around, glm::mat4(1));
        return solids;
    }
};

/// Returns the handle: the longest pill with its width.
Solid handleOf(const std::vector<Solid>& solids, float width) {
    Solid longest;
    longest.toWorld[2] = glm::vec4(0);
    for (const Solid& solid : solids)
        if (solid.shape == SolidShape::pill && std::abs(glm::length(solid.toWorld[0]) - width) < 1e-5f &&
            glm::length(solid.toWorld[2]) > glm::length(longest.toWorld[2]))
            longest = solid;
    return longest;
}

glm::vec3 wayOf(const Solid& solid) {
    return glm::normalize(glm::vec3(solid.toWorld[2]));
}

/// Returns the distance of a place from the solid's axis, between its ends.
float fromAxis(const Solid& solid, const glm::vec3& place) {
    const glm::vec3 off = place - glm::vec3(solid.toWorld[3]), way = wayOf(solid);
    const float half = 0.5f * glm::length(solid.toWorld[2]);
    return glm::length(off - way * std::clamp(glm::dot(off, way), -half, half));
}

float nearestTo(const glm::vec3& place, const std::vector<Solid>& solids) {
    static const SolidMeshes meshes = makeSolidMeshes();
    float least = 1e9f;
    for (const Solid& solid : solids) {
        const SolidMeshes::Range range = meshes.shapes[static_cast<size_t>(solid.shape)];
        for (int i = range.first; i < range.first + range.count; ++i) {
            const glm::vec3 at = meshes.vertices[meshes.indices[static_cast<size_t>(i)]].position;
            least = std::min(least, glm::distance(glm::vec3(solid.toWorld * glm::vec4(at, 1)), place));
        }
    }
    return least;
}

} // namespace

TEST_CASE("with its own tip each torch's handle runs through the hand, along its z, and the torch ends at the tip") {
    const Held held;
    for (int kind = 0; kind < int(AllProcesses::kCount); ++kind) {
        const ProcessSettings process = with(kind);
        INFO(AllProcesses::kNames[static_cast<size_t>(kind)]);
        const TorchGeometry geometry = torchGeometry(process);
        const TorchSample torch = held.torch(geometry);
        const std::vector<Solid> solids = held.drawn(torch, process);
        const Solid handle = handleOf(solids, geometry.handleWidth);
        REQUIRE(glm::length(handle.toWorld[2]) >= geometry.handle - 1e-5f);
        CHECK(fromAxis(handle, held.hand.place) < 1e-4f);
        CHECK(glm::distance(wayOf(handle), held.turn * glm::vec3(0, 0, 1)) < 1e-3f);
        // The hand is on the handle's middle, not at its end.
        CHECK(glm::distance(glm::vec3(handle.toWorld[3]), held.hand.place) < 0.25f * geometry.handle);
        CHECK(nearestTo(torch.tip, solids) == Approx(geometry.reach).margin(0.008));
        CHECK(std::acos(glm::dot(-torch.axis(), wayOf(handle))) == Approx(geometry.bend).margin(2e-3));
    }
}

TEST_CASE("lengths and angles are those of the trade's torches") {
    ProcessSettings process;
    process.choose<Gmaw>();
    const TorchGeometry gmaw = torchGeometry(process);
    CHECK(glm::degrees(gmaw.bend) == Approx(45));
    // In the torch's own frame the hand is 200 mm behind the tip and 87 mm aside.
    const glm::vec3 hand = glm::conjugate(gmaw.tipOrientation()) * -gmaw.tip();
    CHECK(glm::distance(hand, glm::vec3(0, -0.087f, 0.200f)) < 0.008f);
    process.choose<Smaw>();
    const TorchGeometry smaw = torchGeometry(process);
    CHECK(smaw.neck == Approx(0.338)); // the jaws hold the bare end of 350 mm
    CHECK(glm::degrees(smaw.bend) == Approx(72).margin(1));
    process.of<Smaw>().lengthMm = 250;
    CHECK(torchGeometry(process).neck == Approx(0.238));
    process.choose<Gtaw>();
    CHECK(glm::degrees(torchGeometry(process).bend) == Approx(70).margin(2));
    process.choose<SolderingIron>();
    CHECK(torchGeometry(process).bend == 0);
    CHECK(torchGeometry(process).tip().y == 0);
}

TEST_CASE("a tracked hand at the usual place draws the torch as it is drawn without one") {
    for (int kind = 0; kind < int(AllProcesses::kCount); ++kind) {
        const ProcessSettings process = with(kind);
        INFO(AllProcesses::kNames[static_cast<size_t>(kind)]);
        TorchSample torch;
        torch.orientation = glm::angleAxis(-1.2f, glm::vec3(1, 0, 0));
        TorchSurroundings around;
        std::vector<Solid> free, tracked;
        buildTorchFittings(free, torch, process, around, glm::mat4(1));
        const TorchGeometry geometry = torchGeometry(process);
        const Solid handle = handleOf(free, geometry.handleWidth);
        const glm::vec3 begin = glm::vec3(handle.toWorld[3]) - wayOf(handle) * 0.5f * glm::length(handle.toWorld[2]);
        around.hand = TrackedHand{.place = begin + wayOf(handle) * geometry.held()};
        buildTorchFittings(tracked, torch, process, around, glm::mat4(1));
        REQUIRE(tracked.size() == free.size());
        size_t same = 0;
        for (size_t i = 0; i < free.size(); ++i) {
            float differs = 0;
            for (int column = 0; column < 4; ++column)
                differs = std::max(differs, glm::distance(free[i].toWorld[column], tracked[i].toWorld[column]));
            same += differs < 1e-4f;
        }
        CHECK(same + 18 >= free.size()); // all but the glove and its arm
        CHECK(same > 20);
    }
}

TEST_CASE("a measured tip nearer than the neck is long shortens the torch and turns no handle backwards") {
    const Held held;
    for (int kind = 0; kind < int(AllProcesses::kCount); ++kind) {
        const ProcessSettings process = with(kind);
        const TorchGeometry geometry = torchGeometry(process);
        for (const float behind : {-0.02f, 0.03f, 0.06f, 0.09f, 0.12f})
            for (const float aside : {0.0f, 0.03f}) {
                INFO(AllProcesses::kNames[static_cast<size_t>(kind)] << ", " << behind << " m behind");
                TorchSample torch;
                torch.orientation = held.turn;
                torch.tip = held.hand.place - held.turn * glm::vec3(0, -aside, behind);
                const std::vector<Solid> solids = held.drawn(torch, process);
                const Solid handle = handleOf(solids, geometry.handleWidth);
                CHECK(glm::dot(wayOf(handle), -torch.axis()) > -0.31f);
                for (const Solid& solid : solids)
                    CHECK(glm::length(glm::vec3(solid.toWorld[3])) < 3); // finite
                if (behind > geometry.neck) CHECK(fromAxis(handle, held.hand.place) < 1e-3f);
                if (behind >= 0.06f && geometry.neck < 0.11f && aside == 0)
                    CHECK(fromAxis(handle, held.hand.place) < 1e-3f);
            }
    }
}

TEST_CASE("a hand that comes down with the electrode stays over the plate until the stub") {
    ProcessSettings process;
    process.choose<Smaw>();
    const TorchGeometry geometry = torchGeometry(process);
    const SolidMeshes meshes = makeSolidMeshes();
    const float used = static_cast<float>(equipmentOf(process).electrodeLength) - 0.05f; // the stub is left
    // The tip of a whole electrode: the plate's top is at y = 0, where the burnt one ends.
    const glm::quat upright = glm::angleAxis(-1.5707963f, glm::vec3(1, 0, 0));
    const glm::quat turn = upright * glm::conjugate(geometry.tipOrientation());
    const glm::vec3 tip(0, -used, 0), place = tip - turn * geometry.tip();
    std::vector<Solid> solids;
    addGlovedHand(solids,
                  gripOf({place, turn * glm::vec3(1, 0, 0), {0, 0, 1}, true}, turn * glm::vec3(0, 0, 1), tip, 0.017f),
                  glm::mat4(1));
    float lowest = 1;
    for (const Solid& solid : solids) {
        const SolidMeshes::Range range = meshes.shapes[static_cast<size_t>(solid.shape)];
        for (int i = range.first; i < range.first + range.count; ++i)
            lowest =
                std::min(lowest, (solid.toWorld * glm::vec4(meshes.vertices[meshes.indices[size_t(i)]].position, 1)).y);
    }
    INFO("the fist is at " << place.y << " m, its lowest place at " << lowest);
    CHECK(lowest > 0.005f);
    CHECK(place.y < 0.12f); // it has come down by the burnt length
}

TEST_CASE("the drawn forearm leads away from the tip, whatever the controller says") {
    const glm::vec3 tip(0, 0, 0);
    for (int i = 0; i < 60; ++i) {
        const auto a = static_cast<float>(i);
        const glm::vec3 place = 0.2f * glm::normalize(glm::vec3(std::sin(a), std::cos(2 * a), std::sin(3 * a) + 1.2f));
        const glm::vec3 way = glm::normalize(place + glm::vec3(0.02f, 0.05f, 0));
        const glm::vec3 forearm = glm::normalize(glm::vec3(std::cos(5 * a), std::sin(7 * a), std::cos(3 * a)));
        const HandGrip grip = gripOf({place, {0, 1, 0}, forearm, i % 2 == 0}, way, tip, 0.015f);
        CHECK(glm::dot(grip.arm, place) > -1e-4f);
        CHECK(glm::length(grip.arm) == Approx(1).margin(1e-4));
        CHECK(std::abs(glm::dot(grip.palm, way)) < 1e-4f);
    }
}
