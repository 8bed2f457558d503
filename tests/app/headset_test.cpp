// The headset's workshop, held torch and visor: geometry and time without an OpenXR runtime.
#include "app/headset/tip_measuring.hpp"
#include "app/headset/torch_selector.hpp"
#include "app/headset/tracked_torch.hpp"
#include "app/headset/visor.hpp"
#include "app/headset/workshop.hpp"
#include "app/headset/workshop_scene.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <algorithm>
#include <array>

using namespace meltpool;

namespace {

xr::Pose headAt(const glm::vec3& place, float yaw, float pitch) {
    return {glm::angleAxis(yaw, glm::vec3(0, 1, 0)) * glm::angleAxis(pitch, glm::vec3(1, 0, 0)), place};
}

xr::HandInput handAt(const glm::vec3& place, bool tracked = true) {
    xr::HandInput hand;
    hand.present = true;
    hand.tracked = tracked;
    hand.grip.position = place;
    hand.trigger = 1.0f;
    return hand;
}

} // namespace

TEST_CASE("recentre brings the workpiece in front of the eyes and keeps the world upright") {
    const float yaw = GENERATE(0.0f, 0.7f, 3.0f, -2.0f), pitch = GENERATE(0.0f, -0.9f);
    const xr::Pose head = headAt({1.3f, 1.7f, -2.1f}, yaw, pitch);
    Workshop workshop;
    CHECK(workshop.place(head, 0.8f, true) == 0.8f);
    const xr::Pose seen = workshop.toWorkshop(head);
    CHECK(glm::distance(seen.position, glm::vec3(0, 1.7f, Workshop::kReach)) < 1e-4f);
    const glm::vec3 forward = seen.forward();
    CHECK(std::abs(forward.x) < 1e-4f); // the head looks along -z, with its former pitch
    CHECK(forward.z < 0);
    CHECK(forward.y == Approx(std::sin(pitch)).margin(1e-4));
    const glm::vec3 up = workshop.toWorkshop(xr::Pose{}).orientation * glm::vec3(0, 1, 0);
    CHECK(glm::distance(up, glm::vec3(0, 1, 0)) < 1e-5f);
    const xr::Pose back = workshop.toSession(seen);
    CHECK(glm::distance(back.position, head.position) < 1e-4f);
}

TEST_CASE("the table's height fits the eyes of a person who stands or sits, unless a height is set") {
    Workshop workshop;
    for (const float eyes : {1.15f, 1.44f, 1.63f, 1.83f}) {
        const xr::Pose head = headAt({0.3f, eyes, -1}, 0.4f, 0);
        CHECK(workshop.place(head, std::nullopt, true) == Approx(eyes - Workshop::kDrop));
        CHECK(workshop.toWorkshop(head).position.y == Approx(eyes)); // the floor is the real one
        CHECK(workshop.place(head, 0.7f, true) == 0.7f);
        CHECK(workshop.toWorkshop(head).position.y == Approx(eyes));
    }
    CHECK(workshop.place(headAt({0, 0.3f, 0}, 0, 0), std::nullopt, true) == Workshop::kLowest);
    CHECK(workshop.place(headAt({0, 2.4f, 0}, 0, 0), std::nullopt, true) == Workshop::kHighest);
}

TEST_CASE("without a known floor the table comes to the person") {
    Workshop workshop;
    const xr::Pose head = headAt({0, 0.1f, 0}, 0, 0);
    const auto set = GENERATE(std::optional<float>(), std::optional<float>(0.7f));
    const float table = workshop.place(head, set, false);
    CHECK(table == set.value_or(kUsualTableHeight));
    CHECK(workshop.toWorkshop(head).position.y == Approx(table + Workshop::kDrop));
}

TEST_CASE("a positioner holds vertical and overhead pieces before the face") {
    CHECK(beforeFace({}).overTable == 0);
    WorkpieceParameters workpiece;
    workpiece.kind = static_cast<int>(WorkpieceKind::Tee);
    const auto over = [&](WeldPosition position) {
        workpiece.position = static_cast<int>(position);
        return beforeFace(fixtureOf(workpiece)).overTable;
    };
    CHECK(over(WeldPosition::f2) == 0);
    CHECK(over(WeldPosition::f1) == 0);
    CHECK(over(WeldPosition::f3) > 0.1f);
    CHECK(over(WeldPosition::f3) < Workshop::kDrop);
    CHECK(over(WeldPosition::f4) > Workshop::kDrop + 0.1f);
}

TEST_CASE("the workpiece rests on the table at every zoom") {
    HeadsetParameters parameters;
    parameters.zoom = GENERATE(1.0f, 4.0f, 10.0f);
    const WorkpiecePlace place(parameters.tableHeight, parameters.zoom, -0.02f);
    CHECK(place.toWorkshop({0, -0.02f, 0}).y == Approx(parameters.tableHeight));
    const glm::vec3 point(0.01f, 0.02f, -0.03f);
    CHECK(glm::distance(place.toWorkpiece(place.toWorkshop(point)), point) < 1e-6f);
    const glm::vec4 drawn = place.modelToWorkshop(0.04f) * glm::vec4(point / 0.04f, 1.0f);
    CHECK(glm::distance(glm::vec3(drawn), place.toWorkshop(point)) < 1e-6f);
}

TEST_CASE("the hand holds the lesson's torch at its tip, and table, machine and clamps are furniture") {
    HeadsetParameters parameters;
    ProcessSettings process;
    process.choose<Gmaw>();
    WorkshopScene scene;
    HandsView hands;
    hands.torch = true;
    hands.tip.position = {0.1f, 1.0f, 0.1f};
    hands.holder.hold.position = {0.05f, 1.15f, 0.2f};
    const size_t plain = scene.build(parameters, hands).size();
    CHECK(plain > 15); // includes the table
    CHECK(scene.fittings().empty());
    hands.process = &process;
    const std::span<const Solid> torch = scene.build(parameters, hands);
    CHECK(torch.size() < 10); // the first solids throw shadows and are mirrored
    const glm::vec3 wireEnd = torch.front().toWorld * glm::vec4(0, 0, -0.5f, 1);
    CHECK(glm::distance(wireEnd, hands.tip.position) < 1e-5f);
    REQUIRE(scene.fittings().size() > 15);
    float nearest = 1;
    for (const Solid& solid : scene.fittings())
        nearest = std::min(nearest, glm::distance(glm::vec3(solid.toWorld[3]), hands.holder.hold.position));
    CHECK(nearest < 0.05f); // the glove is near
    // While another torch welds the hand is there without a torch.
    const size_t withTorch = scene.fittings().size();
    hands.laidAside = true;
    CHECK(scene.build(parameters, hands).empty());
    CHECK(scene.fittings().size() > 5);
    CHECK(scene.fittings().size() < withTorch);
    hands.laidAside = false;
    scene.build(parameters, hands);
    const size_t standing = scene.furniture().size();
    CHECK(standing > 20);
    const std::array<Solid, 2> holders{};
    hands.holders = holders;
    scene.build(parameters, hands);
    CHECK(scene.furniture().size() == standing + 2);
    hands.holders = {};
    process.choose<Flame>(); // no machine
    scene.build(parameters, hands);
    CHECK(scene.furniture().size() < standing);
}

TEST_CASE("a workpiece in position is turned in the workshop, and the torch back into its frame") {
    const HeadsetParameters parameters;
    for (const auto& [kind, position] : {std::pair(WorkpieceKind::Plate, WeldPosition::g2),
                                         {WorkpieceKind::Butt, WeldPosition::g3},
                                         {WorkpieceKind::Tee, WeldPosition::f3},
                                         {WorkpieceKind::Tee, WeldPosition::f4}}) {
        WorkpieceParameters workpiece;
        workpiece.kind = static_cast<int>(kind);
        workpiece.position = static_cast<int>(position);
        const Fixture held = fixtureOf(workpiece);
        INFO(positionNames()[static_cast<size_t>(position)]);
        const WorkpiecePlace place(parameters.tableHeight, 2.0f, -0.03f, held);
        const glm::vec3 point(0.01f, 0.02f, -0.03f);
        CHECK(glm::distance(place.toWorkpiece(place.toWorkshop(point)), point) < 1e-6f);
        // A drop falls with the metal: down in the workshop is gravity's direction in the workpiece's frame.
        const glm::vec3 fallen = place.toWorkshop(point + 0.01f * held.down());
        CHECK(glm::distance(fallen, place.toWorkshop(point) - glm::vec3(0, 0.02f, 0)) < 1e-6f);
        // The scene's model already has this rotation.
        const glm::mat4 turned = glm::mat4(held.turn);
        const glm::vec4 drawn = place.modelToWorkshop(1.0f) * turned * glm::vec4(point, 1.0f);
        CHECK(glm::distance(glm::vec3(drawn), place.toWorkshop(point)) < 1e-6f);
        CHECK(place.origin.y == Approx(parameters.tableHeight + held.overTable + 0.06f));
        TrackedTorch torch;
        torch.update(handAt({0.04f, 1, 0.1f}), {}, Workshop(), 0.0);
        const TorchSample sample = torch.sample(place);
        CHECK(glm::distance(place.toWorkshop(sample.tip), torch.tip().position) < 1e-6f);
        CHECK(glm::distance(held.turn * sample.axis(), glm::vec3(0, 0, -1)) < 1e-6f);
    }
}

TEST_CASE("the tip follows the calibration, and steps divide the frame's way evenly") {
    HeadsetParameters parameters;
    const WorkpiecePlace place(parameters.tableHeight, parameters.zoom, 0.0f);
    xr::TipCalibration calibration;
    calibration.offset = {0, 0, -0.15f};
    TrackedTorch torch;
    const Workshop workshop;
    torch.update(handAt({0, 1, 0}), calibration, workshop, 0.0);
    torch.update(handAt({0.04f, 1, 0}), calibration, workshop, 0.02);
    CHECK(torch.velocity().x == Approx(2.0f));
    CHECK(glm::distance(torch.tip().position, glm::vec3(0.04f, 1, -0.15f)) < 1e-6f);
    const TorchSample first = torch.next(place, 0, 2), second = torch.next(place, 1, 2);
    CHECK(place.toWorkshop(first.tip).x == Approx(0.02f));
    CHECK(place.toWorkshop(second.tip).x == Approx(0.04f));
    CHECK(first.trigger == 1.0f);
}

TEST_CASE("a slow frame lets no jump through: the tip's way counts, however long the frame was") {
    const Workshop workshop;
    const auto lockedAfter = [&](float way, double elapsed) {
        TrackedTorch torch;
        xr::HandInput hand = handAt({0, 1, 0});
        hand.trigger = 0;
        torch.update(hand, {}, workshop, 0.02);
        hand.trigger = 1;
        torch.update(hand, {}, workshop, 0.02);
        torch.update(handAt({way, 1, 0}), {}, workshop, elapsed);
        return torch.triggerLock().locked();
    };
    CHECK(lockedAfter(0.30f, 0.5));
    CHECK_FALSE(lockedAfter(0.10f, 0.5)); // a hand at 0.2 m/s
    CHECK_FALSE(lockedAfter(0.03f, 0.011));
}

TEST_CASE("losing the hand puts the arc out at once, and its return draws no line") {
    HeadsetParameters parameters;
    const WorkpiecePlace place(parameters.tableHeight, parameters.zoom, 0.0f);
    TrackedTorch torch;
    const Workshop workshop;
    CHECK_FALSE(torch.known());
    torch.update(handAt({0, 1, 0}), {}, workshop, 0.02);
    CHECK(torch.trigger() == 1.0f);
    const glm::vec3 last = torch.tip().position;
    torch.update(handAt({0.5f, 1, 0}, false), {}, workshop, 0.02);
    CHECK(torch.trigger() == 0.0f);
    CHECK(torch.next(place, 0, 1).trigger == 0.0f);
    CHECK(torch.tip().position == last);
    torch.update(handAt({0.5f, 1, 0}), {}, workshop, 0.02);
    CHECK(torch.trigger() == 0.0f); // the trigger has not been released
    CHECK(place.toWorkshop(torch.next(place, 0, 2).tip).x == Approx(0.5f).margin(1e-5));
    CHECK(torch.velocity() == glm::vec3(0.0f));
}

TEST_CASE("the visor is dark in the first frame of heat and clears after it") {
    HeadsetParameters parameters;
    Visor visor;
    CHECK(visor.darkness(parameters) == 0.0f);
    visor.update(true, 0.011);
    CHECK(visor.darkness(parameters) == 1.0f);
    visor.update(false, 0.1);
    CHECK(visor.darkness(parameters) == 1.0f);
    visor.update(false, 0.2);
    const float half = visor.darkness(parameters);
    CHECK(half > 0.0f);
    CHECK(half < 1.0f);
    visor.update(false, 1.0);
    CHECK(visor.darkness(parameters) == 0.0f);
    parameters.visor = false;
    visor.update(true, 0.011);
    CHECK(visor.darkness(parameters) == 0.0f);
}

TEST_CASE("the visor is a filter of its shade where metal shines, and dims where it does not") {
    HeadsetParameters parameters;
    parameters.visorShade = 11;
    parameters.visorShare = 0.25f;
    parameters.adaptation = false;
    Visor visor;
    LookParameters clear;
    visor.wear(parameters, true, clear);
    CHECK(clear.visorShade == 3.0f); // the filter's light state
    CHECK(clear.exposure == 1.0f);
    visor.update(true, 0.011);
    visor.update(parameters, {100, 1e-3, true, {0, 0, -1}}, {}, 0.011);
    LookParameters weld, classic;
    visor.wear(parameters, true, weld);
    CHECK(weld.visorShade == 11.0f);
    CHECK(weld.exposure == 1.0f);
    CHECK(visor.sentence(parameters).empty());
    visor.wear(parameters, false, classic);
    CHECK(classic.visorShade == 0.0f);
    CHECK(classic.exposure == 0.25f);
}

TEST_CASE("the visor is up while a result is read, and down again soon after") {
    HeadsetParameters parameters;
    parameters.adaptation = false;
    Visor visor;
    const auto shade = [&] {
        LookParameters look;
        visor.update(parameters, {}, look, 0.011);
        visor.wear(parameters, true, look);
        return look.visorShade;
    };
    CHECK(shade() == 3.0f);
    visor.read(true, Visor::kLifting / 2);
    CHECK(shade() == Approx(2.0f));
    visor.read(true, Visor::kLifting);
    CHECK(shade() == 0.0f);
    visor.read(false, Visor::kLifting);
    CHECK(shade() == 3.0f);
}

TEST_CASE("an eye without a visor is dazzled by the arc, and told so") {
    HeadsetParameters parameters;
    parameters.visor = false;
    Visor visor;
    const SeenArc arc{10, 1e-3, true, {0, 0, -1}};
    for (int i = 0; i < 90; ++i)
        visor.update(parameters, i < 36 ? SeenArc{} : arc, {}, 1.0 / 45);
    CHECK(visor.sentence(parameters) == "You looked into the arc without a visor for 1.2 s.");
    CHECK(visor.afterImage(parameters).strength > 0.8f);
    LookParameters look;
    visor.wear(parameters, true, look);
    CHECK(look.visorShade == 0.0f);
    CHECK(look.exposure < 0.9f);
    parameters.adaptation = false;
    CHECK(visor.sentence(parameters).empty());
    CHECK(visor.afterImage(parameters).strength == 0.0f);
}

namespace {

xr::TrackerInput trackerAt(const glm::vec3& place, bool tracked = true) {
    xr::TrackerInput tracker;
    tracker.role = "handheld_object";
    tracker.tracked = tracked;
    tracker.pose.position = place;
    return tracker;
}

constexpr double kTick = 0.02;

} // namespace

TEST_CASE("a tracker that is wanted holds the torch as soon as it is seen, and no arc strikes by that") {
    TorchSelector selector;
    xr::HandInput hand = handAt({0, 1, 0});
    std::vector<xr::TrackerInput> trackers{trackerAt({1, 1, 1}, false), trackerAt({2, 1, 1}, false)};
    selector.update(false, hand, trackers, kTick);
    CHECK(selector.holder() == TorchHolder::hand);
    CHECK(selector.torch().trigger == 1.0f);
    CHECK(selector.warning().empty());
    selector.update(true, hand, trackers, kTick);
    CHECK(selector.holder() == TorchHolder::hand);
    CHECK_THAT(std::string(selector.warning()), test::containsText("No tracker"));
    trackers[1].tracked = true;
    selector.update(true, hand, trackers, kTick);
    CHECK(selector.holder() == TorchHolder::tracker);
    CHECK(selector.tracker() == 1);
    CHECK(selector.changed());
    CHECK(selector.torch().grip.position == glm::vec3(2, 1, 1));
    selector.update(true, hand, trackers, kTick);
    CHECK_FALSE(selector.changed());
    hand.trigger = 0;
    selector.update(true, hand, trackers, kTick);
    trackers[1].trigger = 0.6f; // a switch on its pins
    trackers[0].tracked = true; // a better role appears, but the current one remains
    selector.update(true, hand, trackers, kTick);
    CHECK(selector.torch().trigger == 0.6f);
    CHECK(selector.tracker() == 1);
    hand.trigger = 1;
    selector.update(true, hand, trackers, kTick);
    CHECK(selector.torch().trigger == 1.0f);
    selector.update(false, hand, trackers, kTick);
    CHECK(selector.holder() == TorchHolder::hand);
    CHECK(selector.changed());
}

TEST_CASE("a tracker out of sight puts the arc out at once, and gives the torch to the hand after a while") {
    TorchSelector selector;
    TrackedTorch torch;
    const Workshop workshop;
    xr::HandInput hand = handAt({0, 1, 0});
    hand.trigger = 0;
    std::vector<xr::TrackerInput> trackers{trackerAt({1, 1, 1})};
    const auto frame = [&](double elapsed = kTick) {
        selector.update(true, hand, trackers, elapsed);
        if (selector.changed()) torch.putOut(ArcOut::holderChanged);
        torch.update(selector.torch(), {}, workshop, elapsed);
    };
    frame();
    hand.trigger = 1;
    frame();
    CHECK(torch.trigger() == 1.0f);
    trackers[0].tracked = false;
    frame();
    CHECK(torch.trigger() == 0.0f);
    CHECK(selector.holder() == TorchHolder::tracker);
    CHECK_THAT(std::string(selector.warning()), test::containsText("arc is out"));
    frame(TorchSelector::kPatience);
    CHECK(selector.holder() == TorchHolder::hand);
    CHECK(torch.tip().position.x == Approx(0));
    CHECK(torch.velocity() == glm::vec3(0.0f)); // the motion from the tracker to the hand has no velocity
    CHECK(torch.trigger() == 0.0f);
    CHECK_THAT(std::string(selector.warning()), test::containsText("the controller is the torch"));
    hand.trigger = 0;
    frame();
    hand.trigger = 1;
    frame();
    CHECK(torch.trigger() == 1.0f);
    trackers[0].tracked = true;
    frame();
    CHECK(selector.holder() == TorchHolder::tracker);
    CHECK(torch.trigger() == 0.0f);
    CHECK(torch.tip().position.x == Approx(1));
}

TEST_CASE("measuring finds tip and direction of a torch on whatever holds it, and keeps them") {
    const std::filesystem::path file = test::scratchFolder("measuring") / "new" / "torch-tip-tracker.txt";
    CalibrationFile calibration(file);
    TipMeasuring measuring;
    CHECK(measuring.report().empty());
    const glm::vec3 offset(0.02f, -0.05f, -0.2f), point(0.1f, 0.9f, -0.3f);
    xr::HandInput torch = handAt({0, 0, 0});
    const auto run = [&](TipMeasuring::Task task, const auto& poseAt) {
        measuring.begin(task);
        double time = 0;
        while (measuring.underWay() && time < 60) {
            torch.grip = poseAt(time);
            const auto found = measuring.gather(torch, calibration.tip(), 1.0 / 90);
            if (found) measuring.kept(calibration.keep(*found, calibration.tip()));
            time += 1.0 / 90;
        }
        return time;
    };
    const auto swing = [&](double time) {
        const auto t = static_cast<float>(time);
        const glm::quat q = glm::angleAxis(0.6f * std::sin(2 * t), glm::vec3(1, 0, 0)) *
                            glm::angleAxis(0.6f * std::sin(3 * t), glm::vec3(0, 1, 0)) *
                            glm::angleAxis(0.6f * std::sin(t), glm::vec3(0, 0, 1));
        return xr::Pose{q, point - q * offset};
    };
    // The hand that pressed the button reaches the dent only after three seconds.
    const auto late = [&](double time) { return time < 3 ? xr::Pose{{1, 0, 0, 0}, {1, 1, 1}} : swing(time); };
    CHECK(run(TipMeasuring::Task::pivot, late) == Approx(17).margin(0.1));
    CHECK_THAT(measuring.report(), test::containsText("was found"));
    CHECK(glm::distance(xr::readCalibration(file).offset, offset) < 1e-4f);
    // The torch stands upright only after three seconds; then its -y points down.
    const auto stand = [&](double time) {
        return xr::Pose{glm::angleAxis(time < 3 ? 1.0f : 0.0f, glm::vec3(1, 0, 0)), {0, 1, 0}};
    };
    CHECK(run(TipMeasuring::Task::axis, stand) == Approx(8).margin(0.1));
    const xr::TipCalibration kept = xr::readCalibration(file);
    CHECK(glm::distance(kept.orientation * glm::vec3(0, 0, -1), glm::vec3(0, -1, 0)) < 1e-4f);
    CHECK(glm::distance(kept.offset, offset) < 1e-4f);
    torch.tracked = false;
    CHECK(run(TipMeasuring::Task::pivot, swing) == Approx(35).margin(1.1));
    CHECK_THAT(measuring.report(), test::containsText("not found"));
    CHECK(glm::distance(calibration.tip().offset, offset) < 1e-4f);
    CalibrationFile other(file); // another program finds another place but leaves the old direction
    xr::TipCalibration elsewhere = other.tip();
    elsewhere.offset.x += 0.01f;
    xr::TipCalibration turned = calibration.tip();
    turned.pointAlong({0, 0, 1});
    CHECK(calibration.keep(turned, calibration.tip()).empty());
    CHECK(other.keep(elsewhere, other.tip()).empty());
    CHECK(xr::readCalibration(file).offset == elsewhere.offset);
    CHECK(glm::distance(other.tip().orientation * glm::vec3(0, 0, -1), glm::vec3(0, 0, 1)) < 1e-4f);
    CHECK(calibration.keep(kept, calibration.tip()).empty());
    CHECK(glm::distance(xr::readCalibration(file).offset, elsewhere.offset) < 1e-6f); // not measured by this program
    CHECK(calibration.measured());
    measuring.begin(TipMeasuring::Task::axis);
    measuring.forgotten(calibration.forget());
    CHECK_FALSE(measuring.underWay());
    CHECK_THAT(measuring.report(), test::containsText("its own tip"));
    CHECK_FALSE(calibration.measured());
    CHECK_FALSE(std::filesystem::exists(file));
    CHECK_FALSE(CalibrationFile(file).measured());
}
