// Tests the torch at the desk: the technique measures the values that mouse, wheel and keys have set.
#include "app/session/desk_torch.hpp"
#include "core/training/judging/stretch.hpp"
#include "core/training/lesson/lesson.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/places.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <numbers>

namespace meltpool {

namespace {

constexpr double kStep = 1.0 / 100;
constexpr int kSteps = 3; // steps a frame

Lesson shipped(const char* name) {
    return findLesson(name, test::sourceFolder() / "app" / "data" / "lessons");
}

/// Desk with a torch that welds, and the technique that measures it.
struct Desk {
    explicit Desk(const char* name)
        : lesson(shipped(name)), technique(seamOf(lesson.workpiece), lesson.technique->settings()) {
        torch.begin(lesson);
    }
    void frame(const InputFrame& input = {}, bool welds = true) {
        torch.update(input, {view, kSteps * kStep}, parameters, lesson.process);
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
    /// View from above: x to the right, the welder's side (+z) up the screen.
    glm::mat3 view{1, 0, 0, 0, 0, 1, 0, 1, 0};
    TorchSample last;
    double time = 0;
};

/// Distance of the demonstration in the shipped lessons, whose seams run along x, mm.
double distanceOfExpert(const Lesson& lesson) {
    if (!lesson.process.is<Gmaw>()) return lesson.technique->find(TechniqueQuantity::distance)->ideal;
    const TorchSample torch = lesson.torch.sample(lesson.torch.duration() / 2);
    REQUIRE(torch.trigger > 0);
    // The distance runs down the torch's axis to the height of the seam, in a corner to the plane across its bisector.
    const bool corner = lesson.workpiece.kind == static_cast<int>(WorkpieceKind::Tee);
    const glm::vec3 up = corner ? glm::normalize(glm::vec3(0, 1, 1)) : glm::vec3(0, 1, 0);
    return double(lesson.process.of<Gmaw>().stickOutMm) +
           1e3 * double(glm::dot(torch.tip, up) / -glm::dot(torch.axis(), up));
}

InputFrame pressed(Key key, int times = 1) {
    InputFrame input;
    input.pressed.assign(static_cast<size_t>(times), key);
    return input;
}

InputFrame struck(Key key) {
    InputFrame input = pressed(key);
    input.struck = input.pressed;
    return input;
}

double degrees(double radians) {
    return radians * 180 / std::numbers::pi;
}

/// Shift and the right arrow held down, which lead the torch along the seam.
InputFrame ledByKeys() {
    InputFrame input = pressed(Key::right);
    input.held.set(static_cast<size_t>(Key::right));
    input.held.set(static_cast<size_t>(Key::shift));
    return input;
}

/// True if the desk has held this quantity.
bool held(const Desk& desk, TechniqueQuantity quantity) {
    return desk.torch.held().test(static_cast<size_t>(quantity));
}

} // namespace

TEST_CASE("the desk holds what the hand does not lead while it welds") {
    Desk desk("gmaw-bead");
    InputFrame wheel;
    wheel.scroll = 2;
    desk.frame(wheel, false); // before the arc
    desk.frames(5);
    CHECK(desk.torch.held().all());

    InputFrame along;
    along.mouseMove = {10, 0};
    desk.frames(5, along);
    CHECK_FALSE(held(desk, TechniqueQuantity::travelSpeed));
    CHECK(held(desk, TechniqueQuantity::aim));
    CHECK(held(desk, TechniqueQuantity::distance));
    desk.frame(wheel);
    CHECK_FALSE(held(desk, TechniqueQuantity::distance));
    desk.frame(pressed(Key::right));
    CHECK_FALSE(held(desk, TechniqueQuantity::travelAngle));
    CHECK(held(desk, TechniqueQuantity::workAngle));
    desk.frame(pressed(Key::up));
    CHECK_FALSE(held(desk, TechniqueQuantity::workAngle));
    desk.torch.begin(desk.lesson); // another attempt
    CHECK(desk.torch.held().all());

    desk.parameters.guideSpeed = 6;
    desk.frames(5, along);
    CHECK(held(desk, TechniqueQuantity::travelSpeed));
}

TEST_CASE("dips of the rod and swings of the mouse are the hand's, swings of the desk are not") {
    Desk rod("gtaw-rod");
    rod.frames(5);
    CHECK(held(rod, TechniqueQuantity::rodFrequency));
    InputFrame dip;
    dip.held.set(static_cast<size_t>(Key::r));
    rod.frames(5, dip);
    CHECK_FALSE(held(rod, TechniqueQuantity::rodFrequency));
    CHECK(held(rod, TechniqueQuantity::rodAngle));

    Desk weave("tee-3f");
    InputFrame aside;
    aside.mouseMove = {7, 9}; // along and across
    weave.frames(5, aside);
    CHECK_FALSE(held(weave, TechniqueQuantity::weaveWidth));
    weave.frames(5, struck(Key::g));
    CHECK(held(weave, TechniqueQuantity::weaveWidth));
}

TEST_CASE("the desk swings its torch as the demonstration does, by a key, and fades no cue by it") {
    Desk plain("gmaw-bead");
    plain.frame(struck(Key::g));
    CHECK_FALSE(plain.torch.weave().on()); // its demonstration goes straight

    Desk desk("tee-3f"), straight("tee-3f");
    const Weave weave = *desk.lesson.torch.weave();
    CHECK(weave.width == Approx(4e-3));
    CHECK(weave.frequency == Approx(1.5).epsilon(0.03)); // a whole number of half swings
    desk.parameters.guideSpeed = straight.parameters.guideSpeed = 4;
    const SeamFrame seam = seamOf(desk.lesson.workpiece).at(0);
    const auto swing = [&] { return glm::dvec3(desk.last.tip - straight.last.tip); };
    const auto frame = [&](const InputFrame& input = {}) {
        desk.frame(input);
        straight.frame();
    };
    for (int i = 0; i < 10; ++i)
        frame();
    CHECK(glm::length(swing()) == 0);
    CHECK_FALSE(desk.torch.weave().swung());

    frame(struck(Key::g));
    double least = 1, most = -1;
    for (int i = 0; i < 100; ++i) {
        frame();
        least = std::min(least, glm::dot(swing(), seam.across));
        most = std::max(most, glm::dot(swing(), seam.across));
        CHECK(glm::dot(swing(), seam.tangent) == Approx(0).margin(1e-6));
        CHECK(glm::dot(swing(), glm::dvec3(desk.last.axis())) == Approx(0).margin(1e-6));
    }
    CHECK(desk.torch.weave().swung());
    CHECK(most == Approx(2e-3).epsilon(0.05));
    CHECK(least == Approx(-2e-3).epsilon(0.05));
    const auto& steps = desk.technique.steps();
    const auto found = analyseStretch(steps, desk.technique.settings(), 0)[steps.size() - 60].values;
    CHECK(found[TechniqueQuantity::weaveWidth] == Approx(weave.width).epsilon(0.1));
    CHECK(found[TechniqueQuantity::weaveFrequency] == Approx(weave.frequency).epsilon(0.05));
    CHECK(found[TechniqueQuantity::aim] == Approx(0).margin(0.15e-3));
    CHECK(desk.torch.held().all()); // nothing of it is the hand's

    frame(struck(Key::g));
    for (int i = 0; i < 20; ++i)
        frame();
    CHECK(glm::length(swing()) == 0); // the swing has ended in the middle
    desk.torch.begin(desk.lesson);
    CHECK_FALSE(desk.torch.weave().swung());
}

TEST_CASE("a torch that was put aside comes back when the hand leads it or welds, not by keys that were let go") {
    Desk desk("gmaw-bead");
    desk.frames(10, ledByKeys());
    desk.torch.putAside(); // the keys' speed would run on
    desk.frame({}, false);
    CHECK(desk.torch.aside());
    InputFrame mouse;
    mouse.mouseMove = {1, 0};
    desk.frame(mouse, false);
    CHECK_FALSE(desk.torch.aside());
    desk.torch.putAside();
    desk.frame({}, false);
    CHECK(desk.torch.aside());
    desk.frame();
    CHECK_FALSE(desk.torch.aside());
    desk.frame({}, false);
    CHECK_FALSE(desk.torch.aside()); // until it is put aside again
    desk.torch.putAside();
    desk.frame({}, false);
    desk.torch.begin(desk.lesson);
    CHECK_FALSE(desk.torch.aside());
}

TEST_CASE("a weld that is judged while trigger and keys are still held puts the torch aside once they are let go") {
    Desk desk("gmaw-bead");
    desk.frames(10, ledByKeys());
    desk.torch.putAside();
    desk.frames(5, ledByKeys());
    CHECK_FALSE(desk.torch.aside());
    desk.frame({}, false);
    CHECK(desk.torch.aside());
}

TEST_CASE("a guided desk torch is measured as it is held, on plate, tee and under each process") {
    for (const char* name : {"gmaw-bead", "tee-fillet", "gtaw-bead", "smaw-bead"}) {
        INFO(name);
        Desk desk(name);
        REQUIRE(desk.torch.leads());
        const TechniqueBands& bands = *desk.lesson.technique;
        desk.parameters.guideSpeed = 6;
        desk.frames(60, {});
        CHECK(desk.torch.guided()); // the score notes the guide
        const TechniqueValues& now = desk.technique.now();
        CHECK(now[TechniqueQuantity::travelSpeed] == Approx(6e-3).epsilon(0.01));
        for (const TechniqueQuantity quantity : {TechniqueQuantity::workAngle, TechniqueQuantity::travelAngle}) {
            const TechniqueBand* band = bands.find(quantity);
            REQUIRE(band != nullptr); // the torch begins at the lesson's ideal
            CHECK(degrees(now[quantity]) == Approx(band->ideal).margin(0.1));
        }
        REQUIRE(bands.find(TechniqueQuantity::aim) != nullptr);
        CHECK(now[TechniqueQuantity::aim] * 1e3 == Approx(bands.find(TechniqueQuantity::aim)->ideal).margin(0.01));
        desk.frame(pressed(Key::right, 5));
        desk.frame(pressed(Key::down, 7));
        desk.frames(10, {});
        CHECK(degrees(now[TechniqueQuantity::travelAngle]) ==
              Approx(bands.find(TechniqueQuantity::travelAngle)->ideal + 5).margin(0.1));
        CHECK(degrees(now[TechniqueQuantity::workAngle]) ==
              Approx(bands.find(TechniqueQuantity::workAngle)->ideal + 7).margin(0.1));
        const double distance = bands.find(TechniqueQuantity::distance)->ideal;
        CHECK(desk.torch.pose().distance * 1e3 == Approx(distance).margin(1e-3));
        InputFrame wheel;
        wheel.scroll = 4;
        desk.frame(wheel);
        CHECK(desk.torch.pose().distance * 1e3 == Approx(distance + 2).margin(1e-3));
    }
}

TEST_CASE("a contact tip begins at the asked distance and rises with the pool to the demonstration's height") {
    for (const char* name : {"gmaw-bead", "tee-fillet"}) {
        INFO(name);
        Desk desk(name);
        const bool corner = desk.lesson.workpiece.kind == static_cast<int>(WorkpieceKind::Tee);
        const glm::vec3 up = corner ? glm::normalize(glm::vec3(0, 1, 1)) : glm::vec3(0, 1, 0);
        const auto height = [&] {
            return double(desk.lesson.process.of<Gmaw>().stickOutMm) +
                   1e3 * double(glm::dot(desk.last.tip, up) / -glm::dot(desk.last.axis(), up));
        };
        const double ideal = desk.lesson.technique->find(TechniqueQuantity::distance)->ideal;
        desk.frame({}, false);
        CHECK(height() == Approx(ideal).margin(0.01));
        for (int i = 0; i < 100; ++i) // two seconds
            desk.frame();
        CHECK(height() == Approx(std::max(distanceOfExpert(desk.lesson), ideal)).margin(0.05));
    }
}

TEST_CASE("Shift and arrow keys lead the torch at an even speed, and alone the arrow keys lean it") {
    Desk desk("gmaw-bead");
    InputFrame held;
    held.held.set(size_t(Key::shift));
    held.held.set(size_t(Key::right));
    held.pressed = {Key::right};
    const DeskPose before = desk.torch.pose();
    desk.frames(60, held);
    CHECK(desk.torch.pose().travel == before.travel);
    CHECK(desk.technique.now()[TechniqueQuantity::travelSpeed] == Approx(8e-3).epsilon(0.01)); // as the lesson asks
    CHECK(desk.torch.held().test(size_t(TechniqueQuantity::travelSpeed)));
    CHECK_FALSE(desk.torch.guided());
    desk.frames(60);
    const double place = desk.torch.pose().place;
    desk.frames(5);
    CHECK(desk.torch.pose().place == Approx(place).margin(1e-6)); // it stands
    InputFrame up;
    up.held.set(size_t(Key::shift));
    up.held.set(size_t(Key::up));
    desk.frames(20, up);
    CHECK(std::abs(desk.torch.pose().aim - before.aim) > 1e-3);
}

TEST_CASE("keys and stick lead along the seam however it lies on the screen") {
    const auto led = [](float degrees, Key key, const glm::vec2& stick) {
        Desk desk("gmaw-bead");
        desk.view = glm::mat3(glm::rotate(glm::mat4(1), glm::radians(degrees), glm::vec3(0, 0, 1))) * desk.view;
        desk.frame();
        const DeskPose before = desk.torch.pose();
        InputFrame input;
        if (key != Key::count) input.held.set(size_t(key));
        input.held.set(size_t(Key::shift));
        input.gamepad.left = stick;
        desk.frames(20, input);
        return glm::dvec2(desk.torch.pose().place - before.place, desk.torch.pose().aim - before.aim) * 1e3;
    };
    for (const float degrees : {0.0F, 20.0F, -20.0F, 45.0F, 160.0F, 200.0F}) {
        INFO(degrees);
        const bool turned = degrees > 90;
        const glm::dvec2 right = led(degrees, Key::right, {});
        CHECK((turned ? -right.x : right.x) > 0.5);
        CHECK(right.y == 0);
        const glm::dvec2 up = led(degrees, Key::up, {});
        CHECK(up.x == 0);
        CHECK(std::abs(up.y) > 0.5);
    }
    const glm::dvec2 steep = led(85, Key::up, {});
    CHECK(steep.x > 0.5);
    CHECK(steep.y == 0);
    CHECK(led(85, Key::right, {}).x == 0);
    for (const float degrees : {0.0F, 15.0F, -25.0F}) {
        INFO(degrees);
        const glm::dvec2 right = led(degrees, Key::count, {1, 0});
        CHECK(right.x > 0.5);
        CHECK(right.y == 0);
    }
    CHECK(led(0, Key::count, {0.5, 0.5}).y > 0.1);
}

TEST_CASE("an electrode reaches the metal by wheel and page keys, a contact tip does not") {
    for (const char* name : {"gmaw-bead", "gtaw-bead", "smaw-bead", "smaw-tee"}) {
        INFO(name);
        Desk desk(name);
        InputFrame wheel;
        wheel.scroll = -1;
        for (int i = 0; i < 100; ++i)
            desk.frame(wheel, false);
        const bool tip = desk.lesson.process.is<Gmaw>();
        CHECK(desk.torch.pose().distance * 1e3 == Approx(tip ? 0.5 : -0.5));
        desk.frame(pressed(Key::pageUp, 4), false);
        CHECK(desk.torch.pose().distance * 1e3 == Approx(tip ? 2.5 : 1.5));
    }
}

TEST_CASE("a desk torch keeps its distance from the plate at every angle") {
    Desk desk("gmaw-bead");
    const double stickOut = double(desk.lesson.process.of<Gmaw>().stickOutMm) * 1e-3;
    for (int i = 0; i < 20; ++i) {
        desk.frame(pressed(i % 2 == 0 ? Key::left : Key::up, 2), false);
        // The distance runs along the torch's axis from the wire's end down to the plate.
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
    desk.view = {-1, 0, 0, 0, 0, 1, 0, -1, 0}; // view from the other side
    desk.frame(right, false);
    CHECK(desk.torch.pose().place == Approx(before.place).margin(1e-9));
    desk.frame(up, false);
    CHECK(desk.torch.pose().aim == Approx(0).margin(1e-9));
    desk.view = {0, 0, 1, 0, 1, 0, -1, 0, 0}; // view along the seam: up advances
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
    desk.torch.update(right, {desk.view, kSteps * kStep}, desk.parameters, desk.lesson.process);
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
    REQUIRE(desk.torch.hasRod());
    InputFrame dip;
    dip.held[static_cast<size_t>(Key::r)] = true;
    desk.frame();
    REQUIRE(desk.last.rod);
    const float rest = desk.last.rod->tip.y;
    desk.frames(20, dip);
    CHECK(desk.last.rod->tip.y < 0); // the rod is in the pool
    CHECK(desk.last.rod->feed > 0);
    desk.frames(20);
    CHECK(desk.last.rod->tip.y == Approx(rest).margin(1e-5));
    CHECK(desk.last.rod->feed == 0);

    CHECK_FALSE(Desk("gtaw-bead").torch.hasRod()); // a lesson without a rod

    // Dipped half of the time, the wire feeds as the demonstration's does, and rests where that rests.
    Desk solder("solder-joint");
    const RodHold shown = solder.lesson.torch.rod().value();
    solder.frame();
    const auto end = [&] { return solder.last.rod->tip; };
    const glm::vec3 resting = end();
    solder.frames(20, dip);
    CHECK(double(solder.last.rod->feed) == Approx(2 * shown.feed));
    CHECK(double(glm::distance(resting, end())) == Approx(shown.rest + shown.depth).margin(0.7e-3));

    Desk stick("smaw-bead");
    CHECK_FALSE(stick.torch.hasRod());
    stick.frame();
    const glm::vec3 tip = stick.last.tip;
    const TorchSample burnt = stick.torch.next(0, 1, kStep, 0.05F, 1);
    CHECK(glm::length(burnt.tip - tip - burnt.axis() * 0.05F) < 1e-5F);
}

TEST_CASE("a stick-out that is set anew leaves the contact tip where it is, and the wire's end goes with it") {
    Desk desk("gmaw-bead");
    desk.frames(3, {});
    const DeskPose pose = desk.torch.pose();
    const auto contactTip = [&] {
        const float stickOut = desk.lesson.process.of<Gmaw>().stickOutMm * 1e-3F;
        return desk.last.tip - desk.last.axis() * stickOut;
    };
    const glm::vec3 before = contactTip(), wire = desk.last.tip;
    desk.lesson.process.of<Gmaw>().stickOutMm += 6;
    desk.frames(3, {});
    CHECK(glm::distance(contactTip(), before) < 1e-6F);
    CHECK(glm::distance(desk.last.tip, wire) == Approx(6e-3F).epsilon(1e-3));
    CHECK(desk.torch.pose().distance == pose.distance); // the bar shows this distance
}

TEST_CASE("the guide stops where the torch can be led no farther") {
    Desk desk("gmaw-bead");
    desk.parameters.guideSpeed = 30;
    const Seam seam = seamOf(desk.lesson.workpiece);
    double last = -1;
    for (int i = 0; i < 200; ++i) {
        desk.frame();
        CHECK(double(desk.last.tip.x) >= last - 1e-9); // the torch is never pulled back
        last = double(desk.last.tip.x);
    }
    CHECK(desk.torch.pose().place == Approx(seam.end() + 10e-3).margin(1e-9));
}

TEST_CASE("a gamepad leads the torch: left stick on the screen, right stick leans it, shoulders lift it") {
    Desk desk("gmaw-bead");
    constexpr int kFrames = 10;
    constexpr double kSeconds = kFrames * kSteps * kStep;
    desk.frame();
    const DeskPose before = desk.torch.pose();
    InputFrame input;
    SECTION("along and across") {
        input.gamepad.left = {1, 0};
        desk.frames(kFrames, input);
        const double along = double(desk.parameters.gamepadSpeed) * 1e-3 * kSeconds;
        CHECK(desk.torch.pose().place - before.place == Approx(along));
        input.gamepad.left = {0, 0.5};
        desk.frames(kFrames, input);
        CHECK(desk.torch.pose().aim - before.aim == Approx(along / 2));
    }
    SECTION("leaning: the handle goes the stick's way on the screen") {
        const float along = -desk.last.axis().x;
        input.gamepad.right = {0.5, 0};
        desk.frames(kFrames, input);
        CHECK(desk.torch.pose().travel < before.travel);
        CHECK(-desk.last.axis().x > along);
        input.gamepad.right = {0, 0.5};
        const float across = -desk.last.axis().z;
        desk.frames(kFrames, input);
        CHECK(-desk.last.axis().z > across);
    }
    SECTION("distance") {
        input.gamepad.rightShoulder = true;
        desk.frames(kFrames, input);
        CHECK(desk.torch.pose().distance > before.distance + 1e-3);
        input.gamepad.rightShoulder = false;
        input.gamepad.leftShoulder = true;
        desk.frames(kFrames, input);
        CHECK(desk.torch.pose().distance == Approx(before.distance));
    }
}

TEST_CASE("a desk torch trembles like a hand where that is asked for, and alike each time") {
    Desk steady("gmaw-bead"), hand("gmaw-bead"), again("gmaw-bead");
    hand.parameters.tremor = again.parameters.tremor = 1;
    double sum = 0;
    constexpr int kFrames = 200;
    for (int i = 0; i < kFrames; ++i) {
        steady.frame();
        hand.frame();
        again.frame();
        REQUIRE(hand.last.tip == again.last.tip);
        const double off = double(hand.last.tip.z - steady.last.tip.z);
        sum += off * off;
    }
    CHECK(std::sqrt(sum / kFrames) == Approx(HandTremor::kPlace).epsilon(0.2));
    CHECK(hand.torch.pose().aim == steady.torch.pose().aim); // the hand's aim does not tremble
}

TEST_CASE("a lesson of the classic model has no seam to lead a torch along") {
    DeskTorch torch;
    torch.begin(shipped("classic"));
    CHECK_FALSE(torch.leads());
    torch.update({}, {}, {}, {});
}

} // namespace meltpool
