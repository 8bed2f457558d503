// Lets somebody wear the headset who sees nothing but pictures of both eyes: reads orders from a file and answers each
// with a picture. Not among the ordinary tests: a person, or another program, has to write the orders.
//
// Needs XRT_COMPOSITOR_XCB_FULLSCREEN=1, so that each eye fills half of the screen (MELTPOOL_XR_SCREEN=1440x810x24):
//   MELTPOOL_XR_ORDERS=FOLDER tests/xr/run_on_monado.sh build/release/bin/test_xr_runtime "[orders]"
//
// Orders are lines of FOLDER/orders.txt, appended one by one. Pixels are those of the left eye's half of the picture,
// from its upper left corner. Lengths are mm to the right, upwards and towards the person; times are seconds.
//
//   head YAW PITCH          turns the head: degrees to the right, degrees upwards
//   lean RIGHT UP NEAR      moves the head
//   point X Y               points the torch hand's ray at what is seen there
//   reach X Y               holds the torch's tip 10 mm over the table or the workpiece seen there
//   tilt SIDE TRAVEL        leans the torch: degrees towards the person, degrees to the right
//   move RIGHT UP NEAR T    moves the torch's tip
//   weld RIGHT UP NEAR T    pulls the trigger, and moves the torch's tip in the metal's time
//   touch DOWN T            pulls the trigger, and dips the torch's tip by DOWN and back in the metal's time
//   pull T                  pulls the trigger, and lets it go after that time
//   hold, release           pulls the trigger, lets it go
//   stick Y T               pushes the torch hand's stick forwards (1) or back (-1)
//   button T, other T       presses the menu button of the torch's hand, of the other one
//   wait T                  waits
//   end                     ends the program
//
// FOLDER/answers.txt gets a line for each: picture and order, and "no such order" for others.
#include "core/base/text.hpp"
#include "core/weld/process/processes.hpp"
#include "tests/support/catch.hpp"
#include "tests/xr/trainee.hpp"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <array>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iomanip>
#include <optional>
#include <sstream>
#include <string>

using namespace meltpool;
using namespace meltpool::test;
using nlohmann::json;

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr float kMm = 1e-3F;
constexpr float kWide = 0.785398F;     // rad, half of the field of view across
constexpr float kOverTable = 10 * kMm; // of the tip after `reach`

/// Hands out the lines that have been appended to a file.
class OrderFile {
  public:
    explicit OrderFile(fs::path file) : file_(std::move(file)) { std::ofstream(file_, std::ios::app).flush(); }

    /// Waits for the next line and calls `meanwhile` ten times a second; empty after ten minutes without a line.
    std::optional<std::string> next(const std::function<void()>& meanwhile) {
        constexpr auto kPatient = std::chrono::minutes(10);
        for (const auto end = Clock::now() + kPatient; Clock::now() < end; sleepFor(0.1)) {
            meanwhile();
            const std::string text = readTextFile(file_);
            const size_t stop = text.find('\n', read_);
            if (stop == std::string::npos) continue;
            std::string line = text.substr(read_, stop - read_);
            read_ = stop + 1;
            if (!line.empty()) return line;
        }
        return std::nullopt;
    }

  private:
    fs::path file_;
    size_t read_ = 0;
};

/// The person in the headset: does what an order says.
class Wearer {
  public:
    Wearer(Trainee& trainee, TrainerProcess& trainer) : trainee_(trainee), trainer_(trainer) {
        const Image screen = screenshot();
        eye_ = {float(screen.width) / 2, float(screen.height)};
        const float high = std::atan(std::tan(kWide) * eye_.y / eye_.x);
        trainee_.state.ownEyes = true;
        trainee_.state.fov.fill({-kWide, kWide, high, -high});
        tilt(10, 0);
        lookTo(0, 0);
    }

    /// Returns false for an order that is none.
    bool does(const std::string& order) {
        std::istringstream words(order);
        std::string what;
        words >> what;
        std::array<float, 4> given{};
        size_t count = 0;
        while (count < given.size() && words >> given[count])
            ++count;
        takeLesson();
        return (count == 4 && movesTorch(what, given)) || (count < 4 && looks(what, given, count)) ||
               (count < 4 && acts(what, given, count));
    }

    /// Sways the head as a person's: one that lies still counts as put aside, and puts the workshop elsewhere next.
    void sway() {
        constexpr float kSway = 3 * kMm;
        swayed_ += 0.4F;
        RemoteState state = trainee_.state;
        state.head.position += kSway * glm::vec3(std::sin(swayed_), 0, std::sin(0.7F * swayed_));
        trainee_.driver.send(state);
    }

  private:
    /// Takes the torch of the lesson into the hand, and the height of its plate over the table: an electrode is longer
    /// than a nozzle.
    void takeLesson() {
        const json parameters = trainer_.now()["parameters"];
        const json workpiece = parameters.value("start", json::object());
        const auto size = [&](const char* key) { return std::stof(workpiece.value(key, "0")) * kMm; };
        trainee_.bottom = -size("thickness_mm") - size("room_below_mm");
        const json machine = parameters.value("simulation", json::object());
        if (machine.contains("electrode")) return trainee_.take(Smaw::kName);
        if (machine.contains("wire_feed_m_min")) return trainee_.take(Gmaw::kName);
        if (machine.contains("current")) trainee_.take(Gtaw::kName);
    }

    bool movesTorch(const std::string& what, const std::array<float, 4>& given) {
        const glm::vec3 way = glm::vec3(given[0], given[1], given[2]) * kMm;
        if (what == "move") return glide(way, given[3], false), true;
        if (what == "weld") return glide(way, given[3], true), true;
        return false;
    }

    bool looks(const std::string& what, const std::array<float, 4>& given, size_t count) {
        if (what == "head" && count == 2) return lookTo(given[0], given[1]), true;
        if (what == "lean" && count == 3) {
            trainee_.state.head.position += glm::vec3(given[0], given[1], given[2]) * kMm;
            return trainee_.send(), true;
        }
        if (what == "wait" && count == 1) return sleepFor(given[0]), true;
        return false;
    }

    bool acts(const std::string& what, const std::array<float, 4>& given, size_t count) {
        RemoteHand& torch = trainee_.state.hands[trainee_.hand];
        RemoteHand& other = trainee_.state.hands[1 - trainee_.hand];
        if (what == "point" && count == 2) return point(rayAt(given[0], given[1])), true;
        if (what == "reach" && count == 2) return reach(rayAt(given[0], given[1])), true;
        if (what == "tilt" && count == 2) return tilt(given[0], given[1]), holdTip(), true;
        if (what == "touch" && count == 2) return dip(given[0] * kMm, given[1]), true;
        if (what == "pull" && count == 1) return hold(torch.trigger, 1, given[0]), true;
        if (what == "stick" && count == 2) return hold(torch.thumbstickY, given[0], given[1]), true;
        if (what == "button" && count == 1) return press(torch.b, given[0]), true;
        if (what == "other" && count == 1) return press(other.b, given[0]), true;
        if ((what != "hold" && what != "release") || count != 0) return false;
        torch.trigger = what == "hold" ? 1.0F : 0.0F;
        return trainee_.send(), true;
    }

    void lookTo(float yaw, float pitch) {
        trainee_.state.head.orientation = glm::angleAxis(-glm::radians(yaw), glm::vec3(0, 1, 0)) *
                                          glm::angleAxis(glm::radians(pitch), glm::vec3(1, 0, 0));
        trainee_.send();
    }

    /// Returns the direction in which the left eye sees a pixel, in the session's space.
    glm::vec3 rayAt(float x, float y) const {
        const float wide = std::tan(kWide), high = wide * eye_.y / eye_.x;
        const glm::vec3 ray((2 * x / eye_.x - 1) * wide, (1 - 2 * y / eye_.y) * high, -1);
        return glm::normalize(trainee_.state.head.orientation * ray);
    }

    glm::vec3 leftEye() const { return trainee_.state.head * trainee_.state.eyes[0].position; }

    /// Points from beside the hip at the open panel, or at a place as far as a panel.
    void point(const glm::vec3& ray) {
        const json row = trainer_.now();
        float distance = 0.8F;
        if (row["headset"]["panel"] == true) {
            const json& pose = row["headset"]["panel_pose"];
            const auto at = [&](size_t i) { return pose[i].get<float>(); };
            const glm::vec3 facing = glm::quat(at(3), at(4), at(5), at(6)) * glm::vec3(0, 0, 1);
            const float along = glm::dot(ray, facing);
            const float away = glm::dot(glm::vec3(at(0), at(1), at(2)) - leftEye(), facing);
            if (away / along > 0.1F) distance = away / along;
        }
        const xr::Pose& head = trainee_.state.head;
        const glm::vec3 hip = head.position + glm::vec3(trainee_.hand == 1 ? 0.2F : -0.2F, -0.35F, -0.1F);
        trainee_.point(hip, leftEye() + ray * distance, 0);
    }

    void reach(const glm::vec3& ray) {
        const float top = trainee_.inRoom({}).y + kOverTable;
        if (ray.y > -0.05F) return; // no table there
        tip_ = leftEye() + ray * ((top - leftEye().y) / ray.y);
        holdTip();
    }

    void tilt(float side, float travel) {
        const glm::vec3 back =
            glm::normalize(glm::vec3(std::tan(glm::radians(travel)), 1, std::tan(glm::radians(side))));
        const glm::vec3 aside(trainee_.hand == 1 ? 0.75F : -0.75F, 0, 0.65F);
        const glm::vec3 down = -glm::normalize(aside - back * glm::dot(aside, back));
        trainee_.held = glm::quat_cast(glm::mat3(glm::cross(down, back), down, back));
    }

    void holdTip() { trainee_.aim((tip_ - trainee_.inRoom({})) / trainee_.zoom, torchTrigger()); }
    float torchTrigger() const { return trainee_.state.hands[trainee_.hand].trigger; }

    /// Moves the tip by `way` within `seconds` of real time, or of the metal's while the trigger is pulled.
    void glide(const glm::vec3& way, double seconds, bool welds) {
        const auto start = Clock::now();
        if (welds) trainee_.state.hands[trainee_.hand].trigger = 1;
        const double metal = metalTime();
        const glm::vec3 from = tip_;
        for (double share = 0; share < 1;) {
            const double real = std::chrono::duration<double>(Clock::now() - start).count();
            share = std::min((welds ? metalTime() - metal : real) / std::max(seconds, 0.05), 1.0);
            tip_ = from + way * float(share);
            holdTip();
            sleepFor(0.03);
            if (real > 10 * seconds + 60) break; // the metal stands still
        }
    }

    void dip(float depth, double seconds) {
        glide({0, -depth, 0}, seconds / 2, true);
        glide({0, depth, 0}, seconds / 2, true);
    }

    double metalTime() {
        const json row = trainer_.now();
        return row.contains("metal") && row["metal"].contains("time") ? row["metal"]["time"].get<double>() : 0;
    }

    void hold(float& part, float value, double seconds) {
        part = value;
        trainee_.send();
        sleepFor(seconds);
        part = 0;
        trainee_.send();
    }

    void press(bool& button, double seconds) {
        button = true;
        trainee_.send();
        sleepFor(seconds);
        button = false;
        trainee_.send();
    }

    Trainee& trainee_;
    TrainerProcess& trainer_;
    glm::vec2 eye_{0};                  ///< pixels of an eye's picture
    float swayed_ = 0;                  ///< rad
    glm::vec3 tip_{0.25F, 1.1F, -0.4F}; ///< of the torch, in the session's space
};

} // namespace

TEST_CASE("somebody wears the headset through a file of orders", "[by_hand][orders]") {
    const char* given = std::getenv("MELTPOOL_XR_ORDERS");
    REQUIRE(given != nullptr);
    const fs::path folder = given;
    handGeometry();
    Trainee trainee;
    trainee.zoom = 1;
    TrainerProcess trainer(runFolder() / "orders", {"--headset"}, "resolution_scale = 1\nsamples = 2\n", {},
                           "[sound]\ncaptions = true\n");
    REQUIRE(trainer.waitFor([](const json& row) { return row["headset"]["state"] == "running"; }));
    OrderFile orders(folder / "orders.txt");
    Wearer wearer(trainee, trainer);
    std::ofstream answers(folder / "answers.txt");
    int number = 0;
    for (std::string order = "begin"; order != "end";) {
        const bool done = order == "begin" || wearer.does(order);
        if (!trainer.alive()) break;
        passFrames(trainer, 6);
        std::ostringstream name;
        name << "eyes-" << std::setw(3) << std::setfill('0') << number++ << ".png";
        writePng(folder / name.str(), screenshot());
        answers << name.str() << ": " << order << (done ? "" : " (no such order)") << std::endl;
        order = orders.next([&] { wearer.sway(); }).value_or("end");
    }
    CHECK(trainer.stop() == 0);
}
