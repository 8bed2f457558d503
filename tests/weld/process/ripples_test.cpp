// The frequency of ripples that each process leaves in a freezing pool.
#include "core/weld/process/processes.hpp"
#include "core/weld/process/shielding_gas.hpp"
#include "tests/support/catch.hpp"

#include <array>
#include <cmath>

using namespace meltpool;

namespace {

template <class P>
FreezingRipples of() {
    ProcessSettings settings;
    settings.choose<P>();
    return equipmentOf(settings).ripples;
}

FreezingRipples ofWire(float feedMPerMin) {
    ProcessSettings settings;
    GmawSettings& gmaw = settings.choose<Gmaw>();
    gmaw.wireDiameterMm = 1.2F;
    gmaw.wireFeedMPerMin = feedMPerMin;
    return equipmentOf(settings).ripples;
}

} // namespace

TEST_CASE("dip transfer, spray, stick and TIG have ripples of their own, within what beads have") {
    const std::array all{ofWire(4.5F), ofWire(10), of<Smaw>(), of<Gtaw>(), of<Flame>()};
    for (size_t i = 0; i < all.size(); ++i) {
        CHECK(all[i].frequency >= 4);
        CHECK(all[i].frequency <= 16);
        CHECK(all[i].height > 0.4F);
        CHECK(all[i].height < 2); // height below 50 um
        for (size_t j = 0; j < i; ++j)
            CHECK(std::abs(all[i].frequency - all[j].frequency) > 0.9F);
    }
    CHECK(ofWire(10).frequency > ofWire(4.5F).frequency);
    CHECK(ofWire(10).height < ofWire(4.5F).height);
}

TEST_CASE("with more wire dip transfer turns into spray without a step, where the heat does") {
    float before = ofWire(3).frequency;
    CHECK(before == ofWire(4).frequency);
    for (float feed = 3; feed < 12; feed += 0.05F) {
        const float now = ofWire(feed).frequency;
        CHECK(now >= before);
        CHECK(now - before < 1.5F);
        before = now;
    }
    CHECK(before == ofWire(14).frequency);
    CHECK(sprayShare(200, 1.2, shieldingGas(GasKind::arCo2)) == 0);
    CHECK(sprayShare(300, 1.2, shieldingGas(GasKind::arCo2)) == 1);
}
