// The torch at the desk: what the technique measures of it is what mouse, wheel and keys have set.
#include "app/session/desk_torch.hpp"
#include "core/training/lesson.hpp"
#include "tests/support/catch.hpp"

#include <numbers>

namespace meltpool {

namespace {

constexpr double kStep = 1.0 / 100;
constexpr int kSteps = 3; // of a frame

Lesson shipped(const char* name) {
    return findLesson(name, std::filesystem::path(MELTPOOL_SOURCE_FOLDER) / "app" / "data" / "lessons");
}

/// A desk that is welded at, with the technique that measures it.
struct Desk {
    explicit Desk(const char* name)
        : lesson(shipped(name)), technique(seamOf(lesson.workpiece), lesson.technique->settings()) {
        torch.begin(lesson);
    }
    void frame(const InputFrame& input = {}, bool welds = true) {
        torch.update(input, view, parameters);
        for (int i = 0; i < kSteps; ++i) {
            last = torch.next(i, kSteps, kStep, 0, welds ? 1.0F : 0.0F);
            last.time = time += kStep;
            ArcState arc;
            arc.action = welds ? ArcAction::burning : ArcAction::out;
            arc.distance = static_cast<float>(torch.pose().distance);
            arc.length = arc.distance;
            technique.add(last, arc);
        }
    }
    void frames(int count, const InputFrame& input = {}) {
        for (int i = 0; i < count; ++i)
            frame(input);
    }

    Lesson lesson;
    DeskTorch torch;
    Technique technique;
    ControlParameters parameters;
    glm::mat3 view{1, 0, 0, 0, 0, 1, 0, 1, 0}; ///< from above: x to the right, the welder's side (+z) up the screen
    TorchSample last;
    double time = 0;
};

InputFrame pressed(Key key, int times = 1) {
    InputFrame input;
    input.pressed.assign(static_cast<size_t>(times), key);
    return input;
}

double degrees(double radians) {
    return radians * 180 / std::numbers::pi;
}

} // namespace

TEST_CASE("a guided desk torch is measured as it is held, on plate, tee and under each process") {
    for (const char* name : {"gmaw-bead", "tee-fillet", "gtaw-bead", "smaw-bead"}) {
        INFO(name);
        Desk desk(name);
        REQUIRE(desk.torch.leads());
        const TechniqueBands& bands = *desk.lesson.technique;
        desk.parameters.guideSpeed = 6;
        desk.frames(60, {});
        CHECK(desk.torch.guided()); // which is kept with the score
        const TechniqueValues& now = desk.technique.now();
        CHECK(now[TechniqueQuantity::travelSpeed] == Approx(6e-3).epsilon(0.01));
        for (const TechniqueQuantity quantity : {TechniqueQuantity::workAngle, TechniqueQuantity::travelAngle}) {
            const TechniqueBand* band = bands.find(quantity);
            REQUIRE(band != nullptr); // it begins as the lesson asks for
            CHECK(degrees(now[quantity]) == Approx(band->ideal).margin(0.1));
        }
        CHECK(now[TechniqueQuantity::aim] * 1e3 == Approx(0).margin(0.01));
        desk.frame(pressed(Key::right, 5));
        desk.frame(pressed(Key::down, 7));
        desk.frames(10, {});
        CHECK(degrees(now[TechniqueQuantity::travelAngle]) ==
              Approx(bands.find(TechniqueQuantity::travelAngle)->ideal + 5).margin(0.1));
        CHECK(degrees(now[TechniqueQuantity::workAngle]) ==
              Approx(bands.find(TechniqueQuantity::workAngle)->ideal + 7).margin(0.1));
        CHECK(desk.torch.pose().distance * 1e3 == Approx(bands.find(TechniqueQuantity::distance)->ideal));
        InputFrame wheel;
        wheel.scroll = 4;
        desk.frame(wheel);
        CHECK(desk.torch.pose().distance * 1e3 == Approx(bands.find(TechniqueQuantity::distance)->ideal + 2));
    }
}

TEST_CASE("a desk torch keeps its distance from the plate at every angle") {
    Desk desk("gmaw-bead");
    const double stickOut = double(desk.lesson.process.of<Gmaw>().stickOutMm) * 1e-3;
    for (int i = 0; i < 20; ++i) {
        desk.frame(pressed(i % 2 == 0 ? Key::left : Key::up, 2), false);
        // Along the torch's axis from the wire's end down to the plate.
        const double toPlate = double(desk.last.tip.y) / -double(desk.last.axis().y);
        CHECK(toPlate + stickOut == Approx(desk.torch.pose().distance).margin(1e-6));
    }
}

TEST_CASE("the mouse leads the torch along and across the seam as they lie on the screen") {
    Desk desk("gmaw-bead");
    const DeskPose before = desk.torch.pose();
    InputFrame right, up;
    right.mouseMove = {100, 0};
    up.mouseMove = {0, -100};
    desk.frame(right, false);
    CHECK((desk.torch.pose().place - before.place) * 1e3 == Approx(double(desk.parameters.torchMouse)));
    CHECK(desk.torch.pose().aim == Approx(0).margin(1e-9));
    desk.frame(up, false);
    CHECK(desk.torch.pose().aim * 1e3 == Approx(double(desk.parameters.torchMouse)));
    desk.view = {-1, 0, 0, 0, 0, 1, 0, -1, 0}; // from the other side
    desk.frame(right, false);
    CHECK(desk.torch.pose().place == Approx(before.place).margin(1e-9));
    desk.frame(up, false);
    CHECK(desk.torch.pose().aim == Approx(0).margin(1e-9));
    desk.view = {0, 0, 1, 0, 1, 0, -1, 0, 0}; // along the seam: up goes on
    desk.frame(up, false);
    CHECK((desk.torch.pose().place - before.place) * 1e3 == Approx(double(desk.parameters.torchMouse)));
}

TEST_CASE("steps of a frame go on evenly, whether hand or guide leads") {
    Desk desk("gmaw-bead");
    desk.parameters.guideSpeed = GENERATE(0.0F, 6.0F);
    InputFrame right;
    right.mouseMove = {9, 0};
    desk.frames(5, right);
    std::vector<double> ways;
    desk.torch.update(right, desk.view, desk.parameters);
    double last = double(desk.last.tip.x);
    for (int i = 0; i < kSteps; ++i) {
        const double x = double(desk.torch.next(i, kSteps, kStep, 0, 1).tip.x);
        ways.push_back(x - last);
        last = x;
    }
    for (const double way : ways)
        CHECK(way == Approx(ways[0]).epsilon(0.01));
    CHECK(ways[0] > 0);
}

TEST_CASE(
    "a rod is dipped by its key and goes back, and the tip of a covered electrode goes down with what burns off") {
    Desk desk("gtaw-rod");
    REQUIRE(desk.torch.holdsRod());
    InputFrame dip;
    dip.held[static_cast<size_t>(Key::r)] = true;
    desk.frame();
    REQUIRE(desk.last.rod);
    const float rest = desk.last.rod->tip.y;
    desk.frames(20, dip);
    CHECK(desk.last.rod->tip.y < 0); // in the pool
    CHECK(desk.last.rod->feed > 0);
    desk.frames(20);
    CHECK(desk.last.rod->tip.y == Approx(rest).margin(1e-5));
    CHECK(desk.last.rod->feed == 0);

    Desk stick("smaw-bead");
    CHECK_FALSE(stick.torch.holdsRod());
    stick.frame();
    const glm::vec3 tip = stick.last.tip;
    const TorchSample burnt = stick.torch.next(0, 1, kStep, 0.05F, 1);
    CHECK(glm::length(burnt.tip - tip - burnt.axis() * 0.05F) < 1e-5F);
}

TEST_CASE("a lesson of the classic model has no seam to lead a torch along") {
    DeskTorch torch;
    torch.begin(shipped("classic"));
    CHECK_FALSE(torch.leads());
    torch.update({}, glm::mat3(1), {});
}

} // namespace meltpool
