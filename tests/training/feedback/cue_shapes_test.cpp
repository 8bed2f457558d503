// Cues as drawn shapes: never over the pool for any eye, visible next to the workpiece, with the right direction.
#include "core/training/feedback/cue_shapes.hpp"

#include "core/render/line_of_sight.hpp"
#include "core/render/picture_target.hpp"
#include "core/render/renderer.hpp"
#include "core/scene/torch_model.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <array>
#include <cmath>

using namespace meltpool;

namespace {

/// Returns every cue, far off in the direction of `sign`.
CueList allCues(double sign, double share = 1.4) {
    CueList cues;
    for (const CuedQuantity& cued : cuedQuantities()) {
        Cue cue;
        cue.kind = cued.kind;
        cue.quantity = cued.quantity;
        cue.share = cue.offset = sign * share;
        cue.inner = 0.3;
        cue.zone = share < 0.3 ? BandZone::inside : BandZone::beyond;
        cues.add(cue);
    }
    for (const CueKind kind : {CueKind::seam, CueKind::arc}) {
        Cue cue;
        cue.kind = kind;
        cue.offset = sign;
        cue.zone = BandZone::beyond;
        cues.add(cue);
    }
    return cues;
}

WorkpieceParameters workpieceOf(WorkpieceKind kind) {
    WorkpieceParameters workpiece;
    workpiece.kind = static_cast<int>(kind);
    workpiece.spacingMm = 2;
    return workpiece;
}

/// Returns an eye over the welder's side of the seam; degrees as in a lesson's camera.
CueEye eyeAt(const glm::vec3& pool, float azimuth, float elevation, float distance) {
    const float a = glm::radians(azimuth), e = glm::radians(elevation);
    return {pool + distance * glm::vec3(std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)), {0, 1, 0}};
}

/// Returns points all over a marker's box, which encloses its shape.
std::vector<glm::vec3> pointsOf(const Marker& marker) {
    std::vector<glm::vec3> points;
    for (const float x : {-0.5F, 0.0F, 0.5F})
        for (const float y : {-0.5F, 0.0F, 0.5F})
            for (const float z : {-0.5F, 0.0F, 0.5F})
                points.emplace_back(marker.toWorld * glm::vec4(x, y, z, 1));
    return points;
}

constexpr CueNames kNames{
    {{"speed", "slower", "faster"}, {"angles"}, {"distance", "nearer", "farther"}, {"aim"}, {}, {}}};

struct Stage {
    explicit Stage(WorkpieceKind kind) : workpiece(workpieceOf(kind)), seam(seamOf(workpiece)) {
        pose.place = seam.begin() + (seam.closed() ? 0.1 : 0.4) * seam.length(); // near the top of a pipe
        pose.aim = 0.5e-3;
        pose.axis = -glm::vec3(seam.at(pose.place).up);
        pose.direction = 1;
        pose.from = seam.begin();
        pose.to = seam.end();
        blocks = makeWorkpiece(workpiece).blocks;
        const SeamFrame frame = seam.at(pose.place);
        pool = glm::vec3(frame.point + frame.across * pose.aim);
        up = glm::vec3(frame.up);
    }

    WorkpieceParameters workpiece;
    Seam seam;
    CuePose pose;
    std::vector<WorkpieceBlock> blocks;
    glm::vec3 pool, up;
};

} // namespace

TEST_CASE("no marker hides a part of the pool's disc from a camera or from either of two eyes", "[training]") {
    CueShapes shapes;
    const bool named = GENERATE(false, true);
    if (named) shapes.setNames(kNames);
    size_t drawn = 0;
    for (const WorkpieceKind kind : {WorkpieceKind::Plate, WorkpieceKind::Tee, WorkpieceKind::Pipe}) {
        Stage stage(kind);
        for (const int direction : {-1, 0, 1})
            for (const float azimuth : {-80.0F, -45.0F, 0.0F, 30.0F, 68.0F, 85.0F})
                for (const float elevation : {10.0F, 24.0F, 45.0F, 75.0F})
                    for (const float distance : {0.06F, 0.1F, 0.25F, 0.45F}) {
                        INFO("kind " << int(kind) << (named ? ", named" : "") << ", direction " << direction
                                     << ", eye at " << azimuth << " " << elevation << " " << distance);
                        stage.pose.direction = direction;
                        const CueEye eye = eyeAt(stage.pool, azimuth, elevation, distance);
                        const auto markers = shapes.build(allCues(direction < 0 ? -1 : 1), stage.seam, stage.pose, eye,
                                                          stage.blocks, glm::mat4(1));
                        drawn += markers.size();
                        CHECK(markers.size() >= 15);
                        // The eyes are 64 mm apart, at least 0.25 m away.
                        const glm::vec3 apart =
                            glm::normalize(glm::cross(eye.up, eye.position - stage.pool)) * (0.128F * distance);
                        int covering = 0;
                        for (const Marker& marker : markers)
                            for (const glm::vec3& point : pointsOf(marker))
                                for (const float side : {-1.0F, 0.0F, 1.0F})
                                    covering += coversDisc(eye.position + apart * side, point, stage.pool, stage.up,
                                                           static_cast<float>(kPoolDisc))
                                                    ? 1
                                                    : 0;
                        CHECK(covering == 0);
                    }
    }
    CHECK(drawn > 1000);
}

TEST_CASE("no corner of the board is in the table or behind the hand, seen from half a metre", "[training]") {
    const bool named = GENERATE(false, true);
    Stage stage(WorkpieceKind::Plate);
    const float table = makeWorkpiece(stage.workpiece).floorHeight;
    // An electrode holder ahead of the pool, whose handle goes off to the right and away from the person.
    stage.pose.axis = glm::normalize(glm::vec3(-0.26F, -0.97F, 0));
    const glm::vec3 neck = stage.pool - 0.06F * stage.pose.axis;
    const std::vector<Solid> handle{
        {.shape = SolidShape::cylinder, .toWorld = alongLine(neck, neck + glm::vec3(0.15F, 0.1F, -0.02F), 0.03F)}};
    const auto cornersHidden = [&](bool told) {
        CueShapes shapes;
        if (named) shapes.setNames(kNames);
        CueEye eye = eyeAt(stage.pool, 0, 48, 0.54F);
        if (told) {
            eye.table = glm::vec4(0, 1, 0, table);
            eye.hands = handle;
        }
        const auto markers = shapes.build(allCues(1), stage.seam, stage.pose, eye, stage.blocks, glm::mat4(1));
        int count = 0;
        for (const Marker& marker : markers.last(shapes.boardMarkers()))
            for (const glm::vec3& point : pointsOf(marker))
                count += point.y < table || standsBefore(handle[0], eye.position, point, 0) ? 1 : 0;
        return count;
    };
    CHECK(cornersHidden(false) > 0);
    CHECK(cornersHidden(true) == 0);
}

TEST_CASE("a field's word is its name, and beyond its band what the hand has to do", "[training]") {
    const Stage stage(WorkpieceKind::Plate);
    const CueEye eye = eyeAt(stage.pool, 0, 40, 0.3F);
    CueShapes shapes;
    shapes.setNames(kNames);
    const auto wordOf = [&](CueKind kind, const CueList& cues) {
        shapes.build(cues, stage.seam, stage.pose, eye, stage.blocks, glm::mat4(1));
        for (const CueLabel& label : shapes.labels())
            if (label.kind == kind) return kNames[static_cast<size_t>(kind)].shown(label.correction);
        return std::string_view();
    };
    CHECK(wordOf(CueKind::speed, allCues(1, 0)) == "speed");
    CHECK(wordOf(CueKind::speed, allCues(1)) == "slower");
    CHECK(wordOf(CueKind::speed, allCues(-1)) == "faster");
    CHECK(wordOf(CueKind::distance, allCues(1)) == "nearer");
    CHECK(wordOf(CueKind::distance, allCues(-1)) == "farther");
    CHECK(wordOf(CueKind::aim, allCues(1)) == "aim"); // a word would need the side
}

TEST_CASE("the test of covering tells what lies between the eye and the disc", "[training]") {
    const glm::vec3 eye(0, 0.1F, 0.1F), centre(0), up(0, 1, 0);
    CHECK(coversDisc(eye, {0, 0.05F, 0.05F}, centre, up, 8e-3F));
    CHECK(coversDisc(eye, {0.003F, 0.05F, 0.05F}, centre, up, 8e-3F));
    CHECK_FALSE(coversDisc(eye, {0.006F, 0.05F, 0.05F}, centre, up, 8e-3F)); // 12 mm from it on the plate
    CHECK_FALSE(coversDisc(eye, {0, -0.05F, -0.05F}, centre, up, 8e-3F));    // behind the disc
    CHECK_FALSE(coversDisc(eye, {0, 0.2F, 0.2F}, centre, up, 8e-3F));        // behind the eye
}

TEST_CASE("in a tee joint the board stands where no plate hides it, also from the camera of the lesson", "[training]") {
    CueShapes shapes;
    const Stage stage(WorkpieceKind::Tee);
    for (const float azimuth : {-60.0F, 0.0F, 30.0F, 68.0F}) {
        const CueEye eye = eyeAt(stage.pool, azimuth, 24, 0.09F);
        INFO(azimuth);
        for (const Marker& marker :
             shapes.build(allCues(1, 0), stage.seam, stage.pose, eye, stage.blocks, glm::mat4(1))) {
            const glm::vec3 middle(marker.toWorld[3]);
            bool hidden = false;
            for (int i = 1; i < 400; ++i) {
                const glm::vec3 at = glm::mix(eye.position, middle, static_cast<float>(i) / 400);
                for (const WorkpieceBlock& block : stage.blocks)
                    hidden = hidden ||
                             (glm::all(glm::greaterThan(at, block.low)) && glm::all(glm::lessThan(at, block.high)));
            }
            CHECK_FALSE(hidden);
        }
    }
}

TEST_CASE("where the picture ends beside the torch the board stands on the other side, and stays there", "[training]") {
    CueShapes shapes;
    const Stage stage(WorkpieceKind::Plate);
    CueEye eye = eyeAt(stage.pool, 0, 40, 0.1F);
    const auto middleOf = [&](float turn) {
        // The camera looks `turn` to the side of the pool.
        const glm::mat4 look = glm::lookAt(eye.position, stage.pool + glm::vec3(turn, 0, 0), eye.up);
        eye.toClip = glm::perspective(0.6F, 1.5F, 0.01F, 10.0F) * look;
        const auto markers = shapes.build(allCues(1, 0), stage.seam, stage.pose, eye, stage.blocks, glm::mat4(1));
        return (glm::vec3(markers.back().toWorld[3]) - stage.pool).x; // place of the arc's sign, over the board
    };
    CHECK(middleOf(0) > 5e-3F); // in the travel direction
    CHECK(middleOf(-0.035F) < -5e-3F);
    CHECK(middleOf(-0.02F) < -5e-3F); // still good on that side
}

TEST_CASE("marks move the way that the hand has gone, whichever way the picture is taken", "[training]") {
    const Stage stage(WorkpieceKind::Plate);
    const SeamFrame frame = stage.seam.at(stage.pose.place);
    const auto markOf = [&](const CueEye& eye, CueKind kind, double share, int direction) {
        CueList cues;
        Cue cue;
        cue.kind = kind;
        cue.quantity = kind == CueKind::angles ? TechniqueQuantity::travelAngle : TechniqueQuantity::aim;
        cue.share = share;
        cue.inner = 0.3;
        cue.zone = BandZone::between;
        cues.add(cue);
        CuePose pose = stage.pose;
        pose.direction = direction;
        CueShapes shapes;
        return glm::vec3(shapes.build(cues, stage.seam, pose, eye, {}, glm::mat4(1)).back().toWorld[3]);
    };
    for (const float azimuth : {-50.0F, 0.0F, 40.0F})
        for (const int direction : {-1, 1}) {
            INFO(azimuth << ", direction " << direction);
            const CueEye eye = eyeAt(stage.pool, azimuth, 40, 0.1F);
            const auto shift = [&](CueKind kind) {
                return markOf(eye, kind, 0.8, direction) - markOf(eye, kind, 0, direction);
            };
            const glm::vec3 ahead = glm::vec3(frame.tangent) * static_cast<float>(direction);
            CHECK(glm::dot(shift(CueKind::speed), ahead) > 7e-4F);                  // too fast: ahead
            CHECK(glm::dot(shift(CueKind::distance), glm::vec3(frame.up)) > 5e-4F); // too far: up
            CHECK(glm::dot(shift(CueKind::aim), glm::vec3(frame.across)) > 5e-4F);  // towards the welder
            CHECK(glm::dot(shift(CueKind::angles), ahead) < -7e-4F);                // pushes too much: leans back
        }
}

TEST_CASE("the seam's dashes lie on the line that the lesson wants aimed at", "[training]") {
    Stage stage(WorkpieceKind::Tee);
    CueList cues;
    Cue cue;
    cue.kind = CueKind::seam;
    cues.add(cue);
    const CueEye eye = eyeAt(stage.pool, 0, 40, 0.15F);
    CueShapes shapes;
    const std::span<const Marker> onSeam = shapes.build(cues, stage.seam, stage.pose, eye, stage.blocks, glm::mat4(1));
    const std::vector<Marker> before(onSeam.begin(), onSeam.end());
    REQUIRE(!before.empty());
    stage.pose.line = -0.5e-3;
    const std::span<const Marker> beside = shapes.build(cues, stage.seam, stage.pose, eye, stage.blocks, glm::mat4(1));
    REQUIRE(beside.size() == before.size());
    const glm::vec3 way(stage.pose.line * stage.seam.at(stage.pose.place).across);
    for (size_t i = 0; i < before.size(); ++i)
        CHECK(glm::distance(glm::vec3(beside[i].toWorld[3]), glm::vec3(before[i].toWorld[3]) + way) < 1e-7F);
}

TEST_CASE("the seam's dashes leave out what has been welded", "[training]") {
    Stage stage(WorkpieceKind::Tee);
    stage.pose.direction = 1;
    CueList cues;
    Cue cue;
    cue.kind = CueKind::seam;
    cues.add(cue);
    const CueEye eye = eyeAt(stage.pool, 0, 40, 0.15F);
    CueShapes shapes;
    const auto dashes = [&](const WeldedPlaces* welded) {
        return shapes.build(cues, stage.seam, stage.pose, eye, stage.blocks, glm::mat4(1), welded).size();
    };
    const size_t all = dashes(nullptr);
    REQUIRE(all > 4);
    WeldedPlaces welded(stage.seam);
    CHECK(dashes(&welded) == all);
    Technique technique(stage.seam);
    ArcState arc;
    arc.action = ArcAction::burning;
    TorchSample torch;
    const auto weldAt = [&](double place) {
        torch.time += 0.01;
        const SeamFrame frame = stage.seam.at(place);
        torch.tip = glm::vec3(frame.point + 1e-3 * frame.up);
        const glm::vec3 back(frame.up), right(frame.tangent);
        torch.orientation = glm::quat_cast(glm::mat3(right, glm::cross(back, right), back));
        technique.add(torch, arc);
        welded.update(technique);
    };
    weldAt(stage.pose.place + 14e-3);
    CHECK(dashes(&welded) < all);
    CHECK(dashes(&welded) > 0);
    for (double way = 8e-3; way < 40e-3; way += 0.5e-3)
        weldAt(stage.pose.place + way);
    CHECK(dashes(&welded) == 0);
    technique.reset(); // another attempt
    welded.update(technique);
    CHECK(dashes(&welded) == all);
}

namespace {

/// A plate under a torch, in a world of 25 units to the metre.
struct Scene {
    Scene() {
        torch.tip = stage.pool + glm::vec3(0, 2e-3F, 0);
        torch.orientation = glm::angleAxis(-glm::radians(90.0F), glm::vec3(1, 0, 0));
        ProcessSettings gmaw;
        gmaw.choose<Gmaw>();
        buildTorchModel(solids, torch, gmaw, {}, toWorld);
        const glm::mat4 plate =
            glm::scale(glm::translate(glm::mat4(1), glm::vec3(0, -3e-3F, 0)), glm::vec3(0.12F, 6e-3F, 0.06F));
        solids.push_back({SolidShape::box, toWorld * plate, glm::vec3(0.3F), 0.2F});
    }

    SceneView view(std::span<const Marker> markers) const {
        SceneView scene;
        scene.modelToWorld = toWorld;
        scene.solids = solids;
        scene.markers = markers;
        return scene;
    }

    Stage stage{WorkpieceKind::Plate};
    glm::mat4 toWorld = glm::scale(glm::mat4(1), glm::vec3(25));
    TorchSample torch;
    std::vector<Solid> solids;
};

View viewOf(const glm::vec3& eye, const glm::vec3& target, float aspect, float fieldOfView = 0.7854F) {
    const glm::mat4 look = glm::lookAt(eye, target, glm::vec3(0, 1, 0));
    return makeView(eye, glm::conjugate(glm::quat_cast(glm::mat3(look))), {fieldOfView}, aspect);
}

struct Differences {
    int inDisc = 0, pixelsOfDisc = 0, outside = 0;
};

/// Compares one view's column of two pictures; discs and rays are in world units.
Differences compare(const Image& with, const Image& without, const View& view, int from, int columns,
                    const glm::vec3& pool, const glm::vec3& up, float radius) {
    Differences found;
    const glm::mat4 toWorld = glm::inverse(view.eyeToClip * view.worldToEye);
    for (int y = 0; y < with.height; ++y)
        for (int x = 0; x < columns; ++x) {
            const auto at = static_cast<size_t>(y * with.width + from + x) * 3;
            const bool differs = !std::equal(&with.rgb[at], &with.rgb[at] + 3, &without.rgb[at]);
            const glm::vec4 clip(2 * (static_cast<float>(x) + 0.5F) / static_cast<float>(columns) - 1,
                                 1 - 2 * (static_cast<float>(y) + 0.5F) / static_cast<float>(with.height), 0, 1);
            const glm::vec4 point = toWorld * clip;
            const glm::vec3 way = glm::vec3(point) / point.w - view.eye;
            const float share = glm::dot(pool - view.eye, up) / glm::dot(way, up);
            const bool inDisc = share > 0 && glm::distance(view.eye + way * share, pool) < radius;
            found.pixelsOfDisc += inDisc ? 1 : 0;
            found.inDisc += inDisc && differs ? 1 : 0;
            found.outside += !inDisc && differs ? 1 : 0;
        }
    return found;
}

} // namespace

TEST_CASE("pictures with and without cues differ outside the pool's disc only, for a camera and for two eyes",
          "[training]") {
    const Scene scene;
    Renderer renderer(test::shaders());
    constexpr int kColumns = 320, kRows = 240;
    LookParameters look;
    look.showBox = look.showSource = false;
    const bool two = GENERATE(false, true);
    const float azimuth = GENERATE(0.0F, 50.0F);
    const float shade = GENERATE(0.0F, 11.0F); // cues are visible through the visor too
    INFO((two ? "two eyes" : "a camera") << ", azimuth " << azimuth << ", shade " << shade);
    look.visorShade = shade;
    const CueEye eye = eyeAt(scene.stage.pool, azimuth, 35, two ? 0.35F : 0.09F);
    const glm::vec3 right = glm::normalize(glm::cross(eye.up, eye.position - scene.stage.pool));
    std::vector<View> views;
    for (const float side : two ? std::vector<float>{-0.032F, 0.032F} : std::vector<float>{0})
        views.push_back(viewOf(25.0F * (eye.position + right * side), 25.0F * scene.stage.pool, float(kColumns) / kRows,
                               two ? 0.4F : 0.7854F));
    const PictureTarget target(kColumns * int(views.size()), kRows);
    const auto picture = [&](std::span<const Marker> markers) {
        renderer.draw(scene.view(markers), look, views, target.target(), nullptr);
        CHECK(glGetError() == GL_NO_ERROR);
        return target.read();
    };
    CueShapes shapes;
    const Image without = picture({});
    const Image with =
        picture(shapes.build(allCues(1), scene.stage.seam, scene.stage.pose, eye, scene.stage.blocks, scene.toWorld));
    for (size_t i = 0; i < views.size(); ++i) {
        INFO("view " << i);
        const Differences found = compare(with, without, views[i], int(i) * kColumns, kColumns,
                                          25.0F * scene.stage.pool, scene.stage.up, 25 * static_cast<float>(kPoolDisc));
        CHECK(found.pixelsOfDisc > 100);
        CHECK(found.inDisc == 0);
        CHECK(found.outside > 300);
    }
}

TEST_CASE("a marker lets as much through as its opacity says", "[training]") {
    test::context();
    const PictureTarget target(32, 32);
    Renderer renderer(test::shaders());
    LookParameters look;
    look.showBox = look.showSource = look.showSky = false;
    const View view = viewOf({0, 0, 3}, {0, 0, 0}, 1);
    const auto middle = [&](float opacity) {
        Marker marker;
        marker.toWorld = glm::scale(glm::mat4(1), glm::vec3(2));
        marker.colour = {1, 0, 0};
        marker.opacity = opacity;
        SceneView scene;
        scene.markers = {&marker, 1};
        renderer.draw(scene, look, {&view, 1}, target.target(), nullptr);
        return int(target.read().rgb[(16 * 32 + 16) * 3]);
    };
    CHECK(middle(1) > 250);
    CHECK(middle(0) < 60);
    CHECK(middle(0.4F) > middle(0) + 30);
    CHECK(middle(0.4F) < middle(1) - 30);
}

TEST_CASE("markers drawn over a picture are where its own would be, in a target of another size too", "[training]") {
    test::context();
    const PictureTarget small(32, 32), large(64, 64);
    Renderer renderer(test::shaders());
    LookParameters look;
    look.showBox = look.showSource = look.showSky = false;
    const View view = viewOf({0, 0, 3}, {0, 0, 0}, 1);
    Marker marker;
    marker.toWorld = glm::translate(glm::mat4(1), glm::vec3(0.5F, 0, 0));
    marker.colour = {1, 0, 0};
    SceneView scene;
    scene.markers = {&marker, 1};
    const auto redAt = [](const PictureTarget& target, int x, int y) {
        const Image image = target.read();
        return int(image.rgb[static_cast<size_t>(y * image.width + x) * 3]);
    };
    renderer.draw(scene, look, {&view, 1}, large.target(), nullptr);
    CHECK(redAt(large, 44, 32) > 200);
    scene.markers = {};
    renderer.draw(scene, look, {&view, 1}, large.target(), nullptr);
    CHECK(redAt(large, 44, 32) < 60);
    renderer.draw(scene, look, {&view, 1}, small.target(), nullptr);
    renderer.drawOver({&marker, 1}, large.target());
    CHECK(redAt(large, 44, 32) > 200);
    CHECK(redAt(large, 20, 32) < 60);
}
