// Agreement of the visible and the audible arc: a burst of spatter for each short circuit.
#include "core/training/feedback/arc_appearance.hpp"
#include "tests/support/catch.hpp"

#include <algorithm>
#include <vector>

using namespace meltpool;

namespace {

ArcState dipping(float rate) {
    ArcState arc;
    arc.action = ArcAction::shorting;
    arc.shorts = rate;
    arc.voltage = 18;
    arc.current = 130;
    arc.distance = 0.015F;
    arc.extension = 0.015F;
    return arc;
}

constexpr double kStep = 1.0 / 90;

/// A weld over a plate, heard and seen.
class Weld {
  public:
    explicit Weld(ShortCircuitKind kind) {
        process_.choose<Gmaw>().shortCircuits = static_cast<int>(kind);
        SceneView metal;
        metal.blocks = {&plate_, 1};
        metal.boxMin = {-0.05F, -0.012F, -0.025F};
        metal.boxMax = {0.05F, 0.014F, 0.025F};
        sight_.open(metal);
    }

    void run(const ArcState& arc, int steps) {
        for (int i = 0; i < steps; ++i) {
            TorchSample torch;
            torch.time = double(++number_) * kStep;
            torch.tip = {0, 0.003F, 0};
            torch.trigger = 1;
            sound_.step(process_, arc, torch, kStep, 1000);
            heard += sound_.last().shortCount;
            for (const ShortCircuit& each : sound_.last().shortCircuits())
                power = std::max(power, each.power);
            sight_.step(process_, sound_.last(), torch, number_);
        }
    }

    size_t counted() const { return sound_.shorts().count(); }
    size_t bursts() const { return sight_.effects().spatter().bursts(); }

    size_t heard = 0;
    float power = 0; ///< W, the greatest of a short circuit's end

  private:
    WorkpieceBlock plate_{{-0.05F, -0.006F, -0.025F}, {0.05F, 0, 0.025F}};
    ProcessSettings process_;
    SoundSource sound_;
    ArcAppearance sight_;
    std::uint64_t number_ = 0;
};

} // namespace

TEST_CASE("each short circuit that is heard is seen to throw spatter, and none that is not", "[effects]") {
    Weld weld(ShortCircuitKind::ordinary);
    weld.run(dipping(84), 180);
    CHECK(weld.heard == weld.counted());
    CHECK(weld.heard > 150);
    CHECK(weld.bursts() == weld.heard);
    const size_t heard = weld.heard;
    weld.run({}, 90);
    CHECK(weld.bursts() == heard);
}

TEST_CASE("a machine that controls its short circuits is heard and throws nothing", "[effects]") {
    Weld weld(ShortCircuitKind::controlled);
    weld.run(dipping(70), 180);
    CHECK(weld.heard > 130);
    CHECK(weld.power < 18.0F * 60.0F); // an ordinary one has 18 V times 130 A
    CHECK(weld.bursts() == 0);
}

TEST_CASE("after a seek the spatter that is born is the same", "[effects]") {
    ProcessSettings process;
    process.choose<Gmaw>();
    SoundSource sound;
    ArcAppearance whole, sought;
    std::uint64_t born = 0;
    for (std::uint64_t number = 1; number <= 400; ++number) {
        TorchSample torch;
        torch.time = double(number) * kStep;
        sound.step(process, dipping(84), torch, kStep, 1000);
        whole.step(process, sound.last(), torch, number);
        if (number > 100) sought.step(process, sound.last(), torch, number);
        if (number == 150) {
            sought.reset();
            born = whole.effects().spatter().born();
        }
    }
    CHECK(whole.effects().spatter().born() - born == sought.effects().spatter().born());
    // Without ground all drops end by cooling: those of the last second are all in flight.
    const ArcEffectsView a = whole.view(), b = sought.view();
    std::vector<Spark> first(a.sparks.begin(), a.sparks.end()), second(b.sparks.begin(), b.sparks.end());
    REQUIRE(first.size() == second.size());
    REQUIRE(first.size() > 20);
    const auto before = [](const Spark& left, const Spark& right) { return left.place.x < right.place.x; };
    std::sort(first.begin(), first.end(), before);
    std::sort(second.begin(), second.end(), before);
    for (size_t i = 0; i < first.size(); ++i) {
        CHECK(first[i].place == second[i].place);
        CHECK(first[i].kelvin == second[i].kelvin);
    }
}
