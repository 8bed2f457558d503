#include "tests/xr/trainee.hpp"

#include "app/headset/workshop_placing.hpp"
#include "core/base/text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/places.hpp"
#include "tests/xr/desk_window.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

namespace meltpool::test {

using nlohmann::json;

namespace {

namespace fs = std::filesystem;

HandGeometry measureHand() {
    hiddenWindow();
    RemoteDriver driver(driverPort());
    RemoteState state;
    driver.send(state);
    xr::Headset headset(std::make_unique<xr::Instance>(), {.resolutionScale = 0.3f, .samples = 1});
    reach(headset, xr::SessionMode::focused);
    const auto tracked = [&] { return headset.input().hand(xr::Hand::right).tracked; };
    REQUIRE(stepUntil(headset, tracked));
    REQUIRE(stepFrames(headset, 5));
    REQUIRE(tracked());
    const xr::HandInput& hand = headset.input().hand(xr::Hand::right);
    return {hand.grip, hand.aim};
}

/// Returns the panel's pose in the session's space, from the program's telemetry.
xr::Pose panelPose(const json& row) {
    const json& pose = row["headset"]["panel_pose"];
    const auto at = [&](size_t i) { return pose[i].get<float>(); };
    return {glm::quat(at(3), at(4), at(5), at(6)), {at(0), at(1), at(2)}};
}

} // namespace

const HandGeometry& handGeometry() {
    static const HandGeometry measured = measureHand();
    return measured;
}

fs::path smallLesson(const fs::path& folder) {
    fs::create_directories(folder);
    const fs::path file = folder / "small.toml";
    const fs::path paths = test::sourceFolder() / "app" / "data" / "paths" / "classic-corner.toml";
    writeTextFileAtomically(
        file, "title = \"Small\"\ntext = \"Small.\"\nmodel = \"classic\"\ntorch = \"" + paths.string() +
                  "\"\n[start]\nparticles = 4096\n"
                  // Molten metal stays molten: the window's figures lag a step or two and must show this metal.
                  "[metal]\nsolidify_rate = 0\n[surface]\ncells = 32\n[[picture]]\nname = \"metal\"\n");
    return file;
}

fs::path plateLesson(const fs::path& folder) {
    fs::create_directories(folder);
    const fs::path file = folder / "plate.toml";
    const fs::path paths = test::sourceFolder() / "app" / "data" / "paths" / "bead-on-plate.toml";
    writeTextFileAtomically(file, "title = \"Plate\"\ntext = \"Plate.\"\nmodel = \"weld\"\ntorch = \"" +
                                      paths.string() +
                                      "\"\n[workpiece]\nworkpiece = \"plate\"\nmetal = \"s235\"\nlength_mm = 24\n"
                                      "width_mm = 20\nthickness_mm = 4\nspacing_mm = 1\n[process]\nprocess = \"gmaw\"\n"
                                      "voltage = 20\nwire_diameter_mm = 1.2\n"
                                      "wire_feed_m_min = 4.5\n[surface]\ncells = 28\n[[picture]]\nname = \"metal\"\n");
    return file;
}

Trainee::Trainee() {
    state.hands[0].pose.position = {-0.3f, 1.0f, -0.2f};
    aim({0.06f, 0.06f, 0.06f}, 0);
}

glm::vec3 Trainee::inRoom(const glm::vec3& place) const {
    return workpiece().toWorkshop(place) - glm::vec3(0, 0, Workshop::kReach);
}

void Trainee::lookDown() {
    state.head.position = {0, 1.55f, -0.02f};
    state.head.orientation = glm::angleAxis(-0.75f, glm::vec3(1, 0, 0));
    send();
}

void Trainee::take(std::string_view process) {
    ProcessSettings settings;
    const auto& names = AllProcesses::kNames;
    settings.kind = static_cast<int>(std::find(names.begin(), names.end(), process) - names.begin());
    REQUIRE(settings.kind < int(names.size()));
    torch = torchGeometry(settings);
}

void Trainee::aim(const glm::vec3& place, float trigger) {
    const xr::Pose tip{glm::quat_cast(workpiece().turn) * held, inRoom(place)};
    const xr::Pose grip = tip * xr::Pose{torch.tipOrientation(), torch.tip()}.inverse();
    state.hands[hand].pose = grip * handGeometry().grip.inverse();
    state.hands[hand].trigger = trigger;
    send();
}

bool Trainee::strike(TrainerProcess& trainer, const glm::vec3& place, const std::function<bool(const json&)>& done) {
    return pullUntil(
        trainer, [&](float trigger) { aim(place, trigger); }, done);
}

bool Trainee::pull(TrainerProcess& trainer, const std::function<bool(const json&)>& done) {
    const auto hold = [&](float trigger) {
        state.hands[hand].trigger = trigger;
        send();
    };
    return pullUntil(trainer, hold, done);
}

bool Trainee::pullUntil(TrainerProcess& trainer, const std::function<void(float)>& hold,
                        const std::function<bool(const json&)>& done) {
    bool pulled = state.hands[hand].trigger > 0;
    return trainer.waitFor(done, [&] {
        const json row = trainer.now();
        const bool locked = row["headset"]["trigger_locked"] == true;
        if (locked == !pulled) return;
        pulled = !locked;
        hold(pulled ? 1.0f : 0.0f);
    });
}

void Trainee::point(const glm::vec3& from, const glm::vec3& target, float trigger) {
    const glm::vec3 z = glm::normalize(from - target), x = glm::normalize(glm::cross(glm::vec3(0, 1, 0), z));
    const xr::Pose ray{glm::quat_cast(glm::mat3(x, glm::cross(z, x), z)), from};
    pointer().pose = ray * handGeometry().aim.inverse();
    pointer().trigger = trigger;
    send();
}

void Trainee::pointAtPixel(TrainerProcess& trainer, float x, float y, float trigger) {
    const xr::Pose panel = panelPose(trainer.now()); // 900 x 1100 pixels, 0.6 m wide
    point(panel * glm::vec3(0.1f, -0.1f, 0.5f), panel * glm::vec3((x - 450) / 1500, (550 - y) / 1500, 0), trigger);
}

void Trainee::pointAtControl(TrainerProcess& trainer, const std::string& name, float trigger) {
    const json places = trainer.now()["headset"]["places"];
    if (!places.contains(name)) { // the press removed the control
        pointer().trigger = trigger;
        return send();
    }
    const json& place = places[name];
    pointAtPixel(trainer, place[0].get<float>() + place[2].get<float>() / 2,
                 place[1].get<float>() + place[3].get<float>() / 2, trigger);
}

void Trainee::scrollTo(TrainerProcess& trainer, const std::string& name) {
    const auto inSight = [&](const json& row) {
        const json& places = row["headset"]["places"];
        return places.contains(name) && places[name][1] > 30 && places[name][1] < 1030;
    };
    // A test that pauses scrolls too far, so there is more than one turn of both ways.
    for (const float way : {-1.0f, 1.0f, -1.0f, 1.0f, -1.0f, 1.0f}) {
        pointAtPixel(trainer, 450, 550, 0);
        passFrames(trainer, 2);
        pointer().thumbstickY = inSight(trainer.now()) ? 0.0f : way;
        send();
        // A panel is at its end if its controls do not move for many frames.
        json last;
        long long moved = trainer.now()["frame"];
        const bool there = trainer.waitFor([&](const json& row) {
            if (row["headset"]["places"] != last) moved = row["frame"];
            last = row["headset"]["places"];
            return inSight(row) || row["frame"] > moved + 40;
        });
        pointer().thumbstickY = 0;
        send();
        passFrames(trainer, 3);
        if (there && inSight(trainer.now())) return;
    }
    FAIL("the panel has no control " << name);
}

void Trainee::press(TrainerProcess& trainer, const std::string& name, const std::function<bool(const json&)>& done) {
    for (int attempt = 0; attempt < 5; ++attempt) {
        scrollTo(trainer, name);
        for (const float trigger : {0.0f, 1.0f, 0.0f}) {
            pointAtControl(trainer, name, trigger);
            passFrames(trainer, 4);
        }
        if (comesTrue(trainer, 60, done)) return;
    }
    keepPicture(screenshot(), "no-press.png");
    FAIL("presses of " << name << " do nothing; page " << trainer.now()["page"] << ", headset "
                       << trainer.now()["headset"].dump());
}

void Trainee::showPanel(TrainerProcess& trainer, bool open) {
    const auto isSo = [open](const json& row) { return row["headset"]["panel"] == open; };
    for (int attempt = 0; attempt < 5 && !isSo(trainer.now()); ++attempt) {
        pointer().b = true;
        send();
        comesTrue(trainer, 60, isSo);
        pointer().b = false;
        send();
        passFrames(trainer, 4);
    }
    REQUIRE(isSo(trainer.now()));
}

void Trainee::holdStick(TrainerProcess& trainer) {
    state.hands[0].thumbstickClick = true;
    send();
    sleepFor(WorkshopPlacing::kHold + 0.2);
    passFrames(trainer, 4);
    state.hands[0].thumbstickClick = false;
    send();
    passFrames(trainer, 2);
}

void Trainee::letGo(TrainerProcess& trainer) {
    state.hands[hand].trigger = 0;
    send();
    REQUIRE(trainer.waitFor(ready));
}

bool running(const json& row) {
    return row["headset"]["state"] == "running" && row["page"] == "running";
}

bool ready(const json& row) {
    return running(row) && row["headset"]["tracked"] == true && row["headset"]["trigger_locked"] == false;
}

namespace {

/// Counts frames with the headset in use, from the first given row to the last.
class FramesInUse {
  public:
    long long passed(const json& row) {
        const bool inUse = row["headset"]["state"] == "running";
        const long long frame = row["frame"];
        if (inUse && last_ >= 0) passed_ += frame - last_;
        last_ = inUse ? frame : -1;
        return passed_;
    }

  private:
    long long last_ = -1, passed_ = 0;
};

} // namespace

void passFrames(TrainerProcess& trainer, long long count) {
    FramesInUse frames;
    const long long before = trainer.now()["frame"];
    // The frame of the next row may have begun before now, those after it have not.
    CHECK(trainer.waitFor([&](const json& row) { return row["frame"] > before && frames.passed(row) >= count; }));
}

bool comesTrue(TrainerProcess& trainer, long long count, const std::function<bool(const json&)>& done) {
    FramesInUse frames;
    bool came = false;
    CHECK(trainer.waitFor([&](const json& row) {
        came = done(row);
        return came || frames.passed(row) >= count;
    }));
    return came;
}

namespace {

/// Takes pictures a few frames apart until two are alike.
Image settled(TrainerProcess& trainer, const std::function<Image()>& take) {
    Image last, now = take();
    const bool same = waitUntil([&] {
        last = std::move(now);
        passFrames(trainer, 6);
        now = take();
        return compareImages(last, now, 24).farPixels < 1e-3;
    });
    CHECK(same);
    return now;
}

} // namespace

Image settledEye(TrainerProcess& trainer, int eye) {
    return settled(trainer, [eye] { return shownEye(screenshot(), eye); });
}

Image settledWindow(TrainerProcess& trainer) {
    return settled(trainer, [] { return windowPicture("Meltpool"); });
}

bool eyeComesTo(TrainerProcess& trainer, int eye, const Image& other, const std::function<bool(double)>& wanted) {
    return waitUntil([&] {
        passFrames(trainer, 2);
        return wanted(compareImages(other, shownEye(screenshot(), eye), 24).farPixels);
    });
}

void sleepFor(double seconds) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

} // namespace meltpool::test
