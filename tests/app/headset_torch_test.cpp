// The torch in the hand: movements that no hand makes extinguish the arc first.
#include "app/headset/tracked_torch.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <vector>

using namespace meltpool;

namespace {

constexpr double kFrame = 1.0 / 60;

xr::HandInput handAt(const glm::vec3& place, float trigger, bool tracked = true) {
    xr::HandInput hand;
    hand.present = hand.tracked = tracked;
    hand.grip.position = place;
    hand.trigger = trigger;
    return hand;
}

/// A torch that welds, and every sample of its steps, two a frame.
struct TrackedWeld {
    TrackedTorch torch;
    Workshop workshop;
    WorkpiecePlace place{0.9f, 1.0f, 0.0f};
    std::vector<TorchSample> samples;

    void frame(const xr::HandInput& hand) {
        torch.update(hand, {}, workshop, kFrame);
        for (int step = 0; step < 2; ++step)
            samples.push_back(torch.next(place, step, 2));
    }
    void burn() {
        frame(handAt({0, 1, 0}, 0));
        for (int i = 0; i < 3; ++i)
            frame(handAt({0.001f * float(i), 1, 0}, 1));
        REQUIRE(samples.back().trigger == 1.0f);
    }
    /// Checks that the arc never burns between two steps that no hand motion connects, remains out with the trigger
    /// pulled at `then`, and strikes again after the trigger's release.
    void checkOutUntilLetGo(const glm::vec3& then) {
        for (int i = 0; i < 4; ++i)
            frame(handAt(then, 1));
        const glm::vec3 there = place.toWorkpiece(torch.tip().position);
        CHECK(samples.back().trigger == 0.0f);
        CHECK(glm::distance(samples.back().tip, there) < 1e-5f);
        for (size_t i = 1; i < samples.size(); ++i) {
            const bool burns = samples[i - 1].trigger > 0 || samples[i].trigger > 0;
            const float limit = TrackedTorch::kFastestHand * float(kFrame) / 2;
            INFO("step " << i);
            CHECK((!burns || glm::distance(samples[i - 1].tip, samples[i].tip) < limit));
            // Each sample is at either end of a jump, never between them.
            CHECK((glm::distance(samples[i].tip, samples[i - 1].tip) < limit ||
                   glm::distance(samples[i].tip, there) < 1e-5f));
        }
        frame(handAt(then, 0));
        frame(handAt(then, 1));
        CHECK(samples.back().trigger == 1.0f);
    }
};

} // namespace

TEST_CASE("a recentre puts the arc out before the torch is elsewhere", "[app]") {
    TrackedWeld weld;
    weld.burn();
    weld.torch.putOut(ArcOut::recentred);
    weld.workshop.place({{1, 0, 0, 0}, {0.2f, 1.6f, 0.6f}}, 0.9f, true);
    const glm::vec3 hand(0.003f, 1, 0);
    for (int i = 0; i < 4; ++i)
        weld.frame(handAt(hand, 1));
    const glm::vec3 there = weld.place.toWorkpiece(weld.torch.tip().position);
    CHECK(glm::distance(weld.samples.back().tip, there) < 1e-5f);
    CHECK(glm::distance(weld.samples[7].tip, there) > 0.1f);
    CHECK(weld.samples[8].tip == weld.samples[7].tip); // the arc ended where it burned
    CHECK(weld.samples[8].trigger == 0.0f);
    for (size_t i = 9; i < weld.samples.size(); ++i) {
        CHECK(glm::distance(weld.samples[i].tip, there) < 1e-5f);
        CHECK(weld.samples[i].trigger == 0.0f);
    }
}

TEST_CASE("zoom puts the arc out before the torch is elsewhere", "[app]") {
    TrackedWeld weld;
    weld.burn();
    weld.torch.putOut(ArcOut::zoomed);
    weld.place = WorkpiecePlace(0.9f, 4.0f, 0.0f);
    weld.checkOutUntilLetGo({0.002f, 1, 0});
    CHECK(weld.torch.triggerLock().locked() == false);
}

TEST_CASE("a jump that no hand makes puts the arc out, a fast hand does not", "[app]") {
    TrackedWeld weld;
    weld.burn();
    SECTION("a jump") {
        weld.checkOutUntilLetGo({0.172f, 1, 0});
    }
    SECTION("a fast hand, 2 m/s") {
        weld.frame(handAt({0.002f + 2.0f / 60, 1, 0}, 1));
        CHECK(weld.samples.back().trigger == 1.0f);
        CHECK(glm::distance(weld.samples.back().tip, weld.samples[weld.samples.size() - 2].tip) ==
              Approx(1.0 / 60).epsilon(0.01));
    }
    SECTION("a jump with the trigger let go is no reason to keep the arc out") {
        weld.frame(handAt({0.002f, 1, 0}, 0));
        weld.frame(handAt({0.4f, 1, 0}, 1));
        CHECK(weld.samples.back().trigger == 1.0f);
        CHECK(weld.samples[weld.samples.size() - 2].tip.x == Approx(0.4f)); // no intermediate step
    }
}

TEST_CASE("a torch that comes back with its trigger pulled stays out, wherever it was lost", "[app]") {
    TrackedWeld weld;
    weld.burn();
    weld.frame(handAt({0, 1, 0}, 0, false));
    CHECK(weld.samples.back().trigger == 0.0f);
    CHECK(weld.torch.triggerLock().reason() == ArcOut::torchLost);
    weld.checkOutUntilLetGo({0.002f, 1, 0.3f});
}
