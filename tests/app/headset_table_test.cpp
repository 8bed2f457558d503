// Things on the headset's table: the holders go with the workpiece, and the machine leaves room for the panel.
#include "app/headset/panel_pointer.hpp"
#include "app/headset/workshop_scene.hpp"
#include "core/training/lesson/lesson.hpp"
#include "core/training/trainer/classic_model.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/places.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <filesystem>
#include <vector>

using namespace meltpool;

namespace {

/// Returns the corners of the holders' boxes in the workshop, as the headset draws them.
std::vector<glm::vec3> holderCorners(const Workpiece& piece, const WorkpiecePlace& place,
                                     const HeadsetParameters& parameters) {
    std::vector<Solid> holders;
    addHolders(holders, glm::scale(glm::mat4(1), glm::vec3(1 / kClassicUnit)), piece, place.overTable / place.zoom);
    ProcessSettings process;
    WorkshopScene scene;
    HandsView hands;
    hands.process = &process;
    hands.holders = holders;
    hands.toolsToWorkshop = place.modelToWorkshop(kClassicUnit);
    scene.build(parameters, hands);
    std::vector<glm::vec3> corners;
    for (const Solid& solid : scene.furniture().last(holders.size()))
        for (const float x : {-0.5f, 0.5f})
            for (const float y : {-0.5f, 0.5f})
                for (const float z : {-0.5f, 0.5f})
                    corners.emplace_back(solid.toWorld * glm::vec4(x, y, z, 1));
    return corners;
}

/// Returns the distance (m, in the workpiece's own size) from the nearest of these corners to the workpiece's box.
float toPiece(std::span<const glm::vec3> corners, const Workpiece& piece, const WorkpiecePlace& place) {
    float nearest = 1e9f;
    for (const glm::vec3& corner : corners) {
        const glm::vec3 at = place.toWorkpiece(corner);
        nearest = std::min(nearest, glm::distance(at, glm::clamp(at, piece.bodyLow, piece.bodyHigh)));
    }
    return nearest;
}

glm::vec3 eyesOver(const HeadsetParameters& parameters) {
    return {0, parameters.tableHeight + Workshop::kDrop, Workshop::kReach};
}

/// Returns the number of places of the panel that are inside a solid on the table.
int insideSolids(const xr::Pose& panel, std::span<const Solid> solids, float tableTop) {
    const xr::PanelShape shape;
    const float height = shape.width * float(shape.heightPixels) / float(shape.widthPixels);
    int inside = 0;
    for (const Solid& solid : solids) {
        if (solid.toWorld[3].y <= tableTop) continue;
        const glm::mat4 toSolid = glm::inverse(solid.toWorld);
        for (float x = -0.5f; x <= 0.5f; x += 0.02f)
            for (float y = -0.5f; y <= 0.5f; y += 0.02f) {
                const glm::vec3 at = toSolid * glm::vec4(panel * glm::vec3(x * shape.width, y * height, 0), 1);
                inside += glm::all(glm::lessThan(glm::abs(at), glm::vec3(0.5f))) ? 1 : 0;
            }
    }
    return inside;
}

} // namespace

TEST_CASE("clamps and posts touch the workpiece and the table wherever the person's height brings both", "[app]") {
    size_t held = 0;
    for (const auto& entry : std::filesystem::directory_iterator(test::sourceFolder() / "app" / "data" / "lessons")) {
        if (entry.path().extension() != ".toml") continue;
        const Lesson lesson = readLesson(entry.path());
        if (lesson.model != LessonModel::Weld) continue;
        const Workpiece piece = makeWorkpiece(lesson.workpiece);
        for (const float zoom : {1.0f, 3.0f}) {
            HeadsetParameters low, high;
            low.tableHeight = 0.7f;
            high.tableHeight = 1.15f;
            const Fixture fixture = beforeFace(fixtureOf(lesson.workpiece));
            const WorkpiecePlace lowPlace(low.tableHeight, zoom, piece.floorHeight, fixture);
            const WorkpiecePlace highPlace(high.tableHeight, zoom, piece.floorHeight, fixture);
            const std::vector<glm::vec3> below = holderCorners(piece, lowPlace, low);
            const std::vector<glm::vec3> above = holderCorners(piece, highPlace, high);
            if (below.empty()) continue; // a thick block lies by its weight
            ++held;
            INFO(entry.path().filename() << ", zoom " << zoom);
            CHECK(toPiece(below, piece, lowPlace) < 3e-3f);
            CHECK(toPiece(above, piece, highPlace) < 3e-3f);
            float lowest = 1e9f;
            for (const glm::vec3& corner : above)
                lowest = std::min(lowest, corner.y);
            CHECK(lowest == Approx(high.tableHeight).margin(2e-3));
            REQUIRE(above.size() == below.size());
            const glm::vec3 moved = highPlace.toWorkshop(glm::vec3(0)) - lowPlace.toWorkshop(glm::vec3(0));
            for (size_t i = 0; i < above.size(); ++i)
                CHECK(glm::distance(above[i] - below[i], moved) < 1e-4f);
        }
    }
    CHECK(held > 10);
}

TEST_CASE("the panel is never inside the machine, which is on the side of the torch's hand", "[app]") {
    for (const xr::Hand hand : {xr::Hand::right, xr::Hand::left})
        for (const bool aside : {false, true}) {
            HeadsetParameters parameters;
            ProcessSettings process;
            process.choose<Gmaw>();
            WorkshopScene scene;
            HandsView hands;
            hands.process = &process;
            PanelPointer panel(parameters);
            panel.show();
            for (int i = 0; i < 3; ++i)
                panel.move(aside, eyesOver(parameters), hand, 10);
            hands.machineRight = panel.side() < 0;
            CHECK(hands.machineRight == (hand == xr::Hand::right));
            scene.build(parameters, hands);
            INFO((hand == xr::Hand::right ? "right" : "left") << (aside ? ", aside" : ", in front"));
            CHECK(insideSolids(panel.pose(), scene.furniture(), parameters.tableHeight) == 0);
            // On the side of the machine this panel would be inside it.
            if (!aside) continue;
            hands.machineRight = !hands.machineRight;
            scene.build(parameters, hands);
            CHECK(insideSolids(panel.pose(), scene.furniture(), parameters.tableHeight) > 20);
        }
}

TEST_CASE("what hides the cues is torch and hands, not the room, with much detail and with little", "[app]") {
    const HeadsetParameters parameters;
    ProcessSettings process;
    process.choose<Gmaw>();
    for (const bool fine : {false, true}) {
        WorkshopScene scene;
        HandsView hands;
        (fine ? hands.process : hands.plainly) = &process;
        hands.torch = true;
        hands.tip.position = {0, parameters.tableHeight + 0.1f, 0};
        scene.build(parameters, hands);
        INFO((fine ? "much" : "little") << " detail");
        REQUIRE_FALSE(scene.hands().empty());
        CHECK(scene.fittings().empty() != fine);
        for (const Solid& solid : scene.hands())
            CHECK(glm::length(glm::vec3(solid.toWorld[0])) < 0.2f);
    }
}

TEST_CASE("the panel and the machine change sides with the torch's hand without meeting", "[app]") {
    const HeadsetParameters parameters;
    ProcessSettings process;
    process.choose<Gmaw>();
    WorkshopScene scene;
    HandsView hands;
    hands.process = &process;
    PanelPointer panel(parameters);
    panel.show();
    const auto pass = [&](xr::Hand hand, int frames) {
        for (int frame = 0; frame < frames; ++frame) {
            panel.move(true, eyesOver(parameters), hand, 1.0 / 60);
            hands.machineRight = panel.side() < 0;
            scene.build(parameters, hands);
            INFO("frame " << frame << ", panel at " << panel.pose().position.x << " m");
            CHECK(insideSolids(panel.pose(), scene.furniture(), parameters.tableHeight) == 0);
        }
    };
    pass(xr::Hand::right, 60);
    CHECK(panel.pose().position.x < -0.4f);
    pass(xr::Hand::left, 60);
    CHECK(panel.pose().position.x > 0.4f);
    CHECK_FALSE(hands.machineRight);
}

TEST_CASE("handle and cable of a demonstration's torch lead to the side of the person's hand", "[app]") {
    HeadsetParameters parameters;
    ProcessSettings process;
    process.kind = GENERATE(range(0, int(AllProcesses::kCount)));
    const bool right = GENERATE(true, false);
    const float zoom = GENERATE(1.0f, 3.0f);
    INFO(AllProcesses::kNames[static_cast<size_t>(process.kind)] << (right ? ", right" : ", left") << ", " << zoom);
    const WorkpiecePlace place(parameters.tableHeight, zoom, 0);
    TorchSample torch;
    torch.tip = {0, 3e-3f, 0};
    torch.orientation = glm::angleAxis(-1.5707963f, glm::vec3(1, 0, 0));
    WorkshopScene scene;
    HandsView hands;
    hands.process = &process;
    hands.demonstrated = &torch;
    hands.workpieceToWorkshop = place.modelToWorkshop(1);
    hands.rightHand = right;
    scene.build(parameters, hands);
    const float side = right ? 1.0f : -1.0f, tip = place.toWorkshop(torch.tip).y;
    float toSide = 0, toOther = 0, lowest = 1e9f;
    for (const Solid& solid : scene.fittings()) {
        const glm::vec3 middle(solid.toWorld[3]);
        toSide = std::max(toSide, side * middle.x);
        toOther = std::max(toOther, -side * middle.x);
        lowest = std::min(lowest, middle.y);
    }
    CHECK(toSide > 0.6f); // over the table's edge
    CHECK(toOther < 0.1f * zoom);
    CHECK(lowest < tip - 0.15f); // and down
}
