// What is seen of the arc is what is heard of it: a burst of spatter for each short circuit.
#include "core/training/feedback/sight.hpp"
#include "tests/support/catch.hpp"

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

} // namespace

TEST_CASE("each short circuit that is heard is seen to throw spatter, and none that is not", "[effects]") {
    ProcessSettings process;
    process.choose<Gmaw>();
    SoundSource sound;
    Sight sight;
    const WorkpieceBlock plate{{-0.05F, -0.006F, -0.025F}, {0.05F, 0, 0.025F}};
    SceneView metal;
    metal.blocks = {&plate, 1};
    metal.boxMin = {-0.05F, -0.012F, -0.025F};
    metal.boxMax = {0.05F, 0.014F, 0.025F};
    sight.open(metal);
    constexpr double kStep = 1.0 / 90;
    std::uint64_t number = 0;
    size_t heard = 0;
    const auto weld = [&](const ArcState& arc, int steps) {
        for (int i = 0; i < steps; ++i) {
            TorchSample torch;
            torch.time = double(++number) * kStep;
            torch.tip = {0, 0.003F, 0};
            torch.trigger = 1;
            sound.step(process, arc, torch, kStep, 1000);
            heard += sound.last().shortCount;
            sight.step(process, sound.last(), torch, number);
        }
    };
    weld(dipping(84), 180);
    CHECK(heard == sound.shorts().count());
    CHECK(heard > 150);
    CHECK(sight.effects().spatter().bursts() == heard + 1); // and the strike
    weld({}, 90);
    CHECK(sight.effects().spatter().bursts() == heard + 1);
    sight.reset(); // a seek
    CHECK(sight.view().sparks.empty());
    weld(dipping(84), 2);
    CHECK_FALSE(sight.view().sparks.empty());
}
