// Tests scripted controllers through a real runtime: poses, trigger, buttons, switching off, vibration.
#include "core/weld/torch/torch_path.hpp"
#include "tests/support/catch.hpp"
#include "tests/xr/monado_run.hpp"

#include <optional>

using namespace meltpool;
using namespace meltpool::test;
using xr::Hand;

namespace {

/// Holds a focused headset whose pictures do not matter.
struct Hands {
    RemoteDriver driver{driverPort()};
    RemoteState state;
    std::unique_ptr<xr::Headset> headset;
    float mark = 0;

    Hands() {
        hiddenWindow();
        state.hands[0].pose.position = {-0.2f, 1.1f, -0.3f};
        state.hands[1].pose.position = {0.2f, 1.2f, -0.4f};
        driver.send(state);
        headset = std::make_unique<xr::Headset>(std::make_unique<xr::Instance>(),
                                                xr::HeadsetSettings{.resolutionScale = 0.3f, .samples = 1});
        REQUIRE(reach(*headset, xr::SessionMode::focused));
        step();
    }

    /// Sends the state, marked by the left thumbstick, without stepping a frame.
    void send() {
        mark = mark > 0.8f ? 0.1f : mark + 0.1f;
        state.hands[0].thumbstickX = mark;
        driver.send(state);
    }
    /// Returns true if the last sent state has arrived.
    bool arrived() { return std::abs(hand(Hand::left).scrollX - mark) < 0.01f; }
    /// Sends the state and steps frames until it has arrived.
    void step() {
        send();
        REQUIRE(stepUntil(*headset, [this] { return arrived(); }));
    }
    const xr::HandInput& hand(Hand which) { return headset->input().hand(which); }
};

/// Counts the presses that a button reports while it is held for six frames. An unanswered frame loses the report, and
/// the button is pressed again.
int edgesOfMenu(Hands& hands) {
    int edges = 0;
    bool answered = false;
    for (int attempt = 0; attempt < 20 && !answered; ++attempt) {
        hands.state.hands[1].b = false;
        hands.step();
        hands.state.hands[1].b = true;
        hands.send();
        edges = 0;
        answered = true;
        for (int held = 0; held < 6; held += hands.arrived() ? 1 : 0) {
            if (stepFrame(*hands.headset, {}).displayTime == 0) answered = false;
            edges += hands.hand(Hand::right).menu ? 1 : 0;
            if (!answered) break;
        }
    }
    CHECK(answered);
    return edges;
}

/// Plays five frames, each with `pulse` as its last call, then stops for five; returns the calls to the runtime. Empty
/// if it did not answer in one of them; the caller then plays them again.
std::optional<xr::Input::HapticCalls> playAndStop(xr::Headset& headset, const xr::HapticPulse& pulse) {
    int begun = 0;
    const auto play = [&] {
        ++begun;
        headset.play(Hand::right, {0.1f, 100.0f, 0.05f});
        headset.play(Hand::right, pulse);
    };
    const auto stop = [&] {
        ++begun;
        headset.play(Hand::right, {});
    };
    REQUIRE(stepFrames(headset, 2, {}, stop));
    begun = 0;
    const xr::Input::HapticCalls before = headset.hapticCalls();
    REQUIRE(stepFrames(headset, 5, {}, play));
    const xr::Input::HapticCalls played = headset.hapticCalls();
    REQUIRE(stepFrames(headset, 5, {}, stop));
    if (begun != 10) return std::nullopt;
    CHECK(played.stopped == before.stopped);
    xr::Input::HapticCalls calls = headset.hapticCalls();
    CHECK(calls.applied == played.applied);
    calls.applied -= before.applied;
    calls.stopped -= before.stopped;
    return calls;
}

} // namespace

TEST_CASE("a controller's grip pose, trigger and buttons arrive", "[runtime]") {
    Hands hands;
    CHECK(hands.headset->input().profile(Hand::right) == "/interaction_profiles/valve/index_controller");
    CHECK(hands.headset->input().profile(Hand::left) == "/interaction_profiles/valve/index_controller");
    CHECK(hands.headset->input().refused().empty());
    CHECK(hands.hand(Hand::right).present);
    CHECK(hands.hand(Hand::right).tracked);
    CHECK(hands.hand(Hand::right).trigger == 0.0f);

    hands.state.hands[1].trigger = 0.37f;
    hands.state.hands[0].squeeze = 0.8f;
    hands.state.hands[1].pose.orientation = glm::angleAxis(0.5f, glm::normalize(glm::vec3(1, 1, 0)));
    hands.step();
    CHECK(hands.hand(Hand::right).trigger == Approx(0.37f).margin(0.001));
    CHECK(hands.hand(Hand::left).squeeze == Approx(0.8f).margin(0.001));

    // The runtime may set the grip apart from the device's own origin, but rigidly: moving the device moves the grip
    // alike.
    const xr::Pose before = hands.hand(Hand::right).grip;
    const glm::vec3 way(0.05f, -0.02f, 0.08f);
    hands.state.hands[1].pose.position += way;
    hands.step();
    const xr::Pose after = hands.hand(Hand::right).grip;
    CHECK(glm::distance(after.position - before.position, way) < 1e-4f);
    CHECK(std::abs(glm::dot(after.orientation, before.orientation)) > 0.99999f);
    CHECK(glm::distance(after.position, hands.state.hands[1].pose.position) < 0.2f);

    CHECK(edgesOfMenu(hands) == 1); // one press, however long it is held
    CHECK(misuses() == "");
}

TEST_CASE("a controller that is switched off is told at once and comes back", "[runtime]") {
    Hands hands;
    hands.state.hands[1].trigger = 1.0f;
    hands.step();
    REQUIRE(hands.hand(Hand::right).tracked);
    const glm::vec3 last = hands.hand(Hand::right).grip.position;

    hands.state.hands[1].active = false;
    hands.step();
    int frames = 0; // frames after the one that brought the inactive controller
    for (; hands.hand(Hand::right).tracked && frames < 10; ++frames)
        REQUIRE(stepFrames(*hands.headset, 1));
    CHECK(frames <= 2);
    CHECK(glm::distance(hands.hand(Hand::right).grip.position, last) < 0.01f); // last known place
    CHECK(hands.hand(Hand::left).tracked);

    hands.state.hands[1].active = true;
    hands.step();
    CHECK(hands.hand(Hand::right).tracked);
    CHECK(misuses() == "");
}

TEST_CASE("the controller vibrates once a frame and is stopped once", "[runtime]") {
    Hands hands;
    xr::Headset& headset = *hands.headset;
    std::optional<xr::Input::HapticCalls> calls;
    for (int attempt = 0; attempt < 20 && !calls; ++attempt)
        calls = playAndStop(headset, {0.5f, 170.0f, 0.05f});
    REQUIRE(calls);
    CHECK(calls->applied == 5);
    CHECK(calls->stopped == 1);
    const unsigned applied = headset.hapticCalls().applied;
    headset.playTracker(0, {0.5f, 170.0f, 0.05f}); // no tracker is bound: no effect
    REQUIRE(stepFrames(headset, 1));
    CHECK(headset.hapticCalls().applied == applied);
    CHECK(misuses() == "");
}

TEST_CASE("a torch path held by the controller is read back along its whole way", "[runtime]") {
    Hands hands;
    std::vector<TorchSample> samples;
    for (int i = 0; i <= 40; ++i) {
        TorchSample sample;
        sample.time = 0.05 * i;
        sample.tip = glm::vec3(0.004f * float(i) - 0.08f, 0.95f + 0.001f * float(i), -0.4f);
        sample.orientation = glm::angleAxis(0.02f * float(i), glm::vec3(0, 1, 0));
        sample.trigger = i >= 10 && i < 30 ? 1.0f : 0.0f;
        samples.push_back(sample);
    }
    const std::filesystem::path file = runFolder() / "path.csv";
    writeTorchCsv(file, {samples, {}, {}});
    const TorchPath path = TorchPath::read(file);

    hands.state.hands[1].pose = {};
    hands.step();
    const xr::Pose gripInDevice = hands.hand(Hand::right).grip; // the runtime's own rigid offset
    for (double time = 0; time < path.duration(); time += 0.2) {
        const TorchSample wanted = path.sample(time);
        hands.state.hands[1].pose = xr::Pose{wanted.orientation, wanted.tip} * gripInDevice.inverse();
        hands.state.hands[1].trigger = wanted.trigger;
        hands.step();
        INFO("time " << time);
        CHECK(glm::distance(hands.hand(Hand::right).grip.position, wanted.tip) < 1e-4f);
        CHECK(std::abs(glm::dot(hands.hand(Hand::right).grip.orientation, wanted.orientation)) > 0.99999f);
        CHECK(hands.hand(Hand::right).trigger == wanted.trigger);
    }
    CHECK(misuses() == "");
}
