// Haptic feedback as a function of the tip's state.
#include "core/training/feedback/haptics.hpp"
#include "core/training/feedback/sound/short_circuits.hpp"
#include "tests/support/catch.hpp"

#include <cmath>

using namespace meltpool;

namespace {

TipFeel burning(float power, float stretch = 0, float liquid = 0) {
    TipFeel tip;
    tip.arc.action = ArcAction::burning;
    tip.arc.share = power;
    tip.arc.stretch = stretch;
    tip.arc.liquid = liquid;
    return tip;
}

TipFeel touched(float speed, float liquid = 0) {
    TipFeel tip;
    tip.sinceTouch = 0;
    tip.touchSpeed = speed;
    tip.arc.liquid = liquid;
    return tip;
}

/// Returns how often the pulse goes on or off within a second.
int changesInSecond(TipFeel tip) {
    int changes = 0;
    bool on = true;
    for (int i = 0; i < 1000; ++i) {
        tip.time = i * 0.001;
        const bool now = !feel(tip).silent();
        changes += now != on ? 1 : 0;
        on = now;
    }
    return changes;
}

} // namespace

TEST_CASE("nothing happens at the tip: silence") {
    CHECK(feel({}).silent());
    TipFeel longAgo;
    longAgo.sinceTouch = kKnockDuration;
    CHECK(feel(longAgo).silent());
}

TEST_CASE("the hum grows with power and sinks with a long arc and over a pool") {
    float last = 0;
    for (const float power : {0.1f, 0.4f, 0.7f, 1.0f}) {
        const Vibration pulse = feel(burning(power));
        CHECK(pulse.amplitude > last);
        CHECK(pulse.amplitude <= 1.0f);
        last = pulse.amplitude;
    }
    const Vibration right = feel(burning(1)), far = feel(burning(1, 0.5f)), pool = feel(burning(1, 0, 1));
    CHECK(far.amplitude < right.amplitude);
    CHECK(far.frequency < right.frequency);
    CHECK(pool.frequency < right.frequency);
    CHECK(pool.frequency > far.frequency);
    CHECK(right.duration > 1.0f / 72.0f); // no gap before the next frame's pulse
    CHECK(changesInSecond(burning(1)) == 0);
}

TEST_CASE("an arc about to break stutters nine times a second, an electrode in the pool twenty times") {
    TipFeel tip = burning(1, 1);
    tip.arc.action = ArcAction::breaking;
    CHECK(changesInSecond(tip) == 17); // nine half periods on and nine off, first on and last off
    tip.arc.action = ArcAction::shorting;
    CHECK(changesInSecond(tip) == 39);
}

TEST_CASE("a wire that shorts stutters with its short circuits, a pulse for each six") {
    TipFeel tip = burning(1);
    tip.arc.action = ArcAction::shorting;
    for (const float rate : {60.0f, 120.0f, 168.0f}) {
        tip.arc.shorts = rate;
        ShortCircuits shorts;
        int pulses = 0;
        bool on = false;
        for (int i = 0; i < 2000; ++i) {
            shorts.step(tip.arc, 0.001);
            tip.shorts = shorts.phase();
            tip.time = 0; // independent of the clock
            pulses += !feel(tip).silent() && !on ? 1 : 0;
            on = !feel(tip).silent();
        }
        CHECK(shorts.count() / 6 <= static_cast<std::uint64_t>(pulses));
        CHECK(static_cast<std::uint64_t>(pulses) <= shorts.count() / 6 + 1);
        CHECK(std::abs(static_cast<double>(shorts.count()) - 2 * static_cast<double>(rate)) <= 5);
    }
}

TEST_CASE("an open arc that drops bridge stutters, too, and one with few short circuits hums") {
    TipFeel tip = burning(1);
    tip.arc.shorts = 100;
    tip.shorts = 3.5; // in the second half of a beat of six
    CHECK(feel(tip).silent());
    tip.shorts = 1;
    CHECK_FALSE(feel(tip).silent());
    tip.shorts = 3.5;
    tip.arc.shorts = 5;
    CHECK_FALSE(feel(tip).silent());
}

TEST_CASE("a stubbed wire buzzes, lower and stronger than any hum") {
    TipFeel tip = burning(1);
    tip.arc.action = ArcAction::stubbed;
    CHECK(feel(tip).amplitude > feel(burning(1)).amplitude);
    CHECK(feel(tip).frequency < feel(burning(1, 1, 1)).frequency);
}

TEST_CASE("a touch knocks, harder when it was faster, duller on a pool, over any hum, and only while it lasts") {
    const Vibration soft = feel(touched(0.01f)), hard = feel(touched(1.0f)), pool = feel(touched(1.0f, 1));
    CHECK_FALSE(soft.silent());
    CHECK(hard.amplitude == 1.0f);
    CHECK(hard.amplitude > soft.amplitude);
    CHECK(hard.frequency == soft.frequency);
    CHECK(pool.amplitude < hard.amplitude);
    CHECK(pool.frequency < hard.frequency);
    TipFeel inArc = burning(1);
    inArc.sinceTouch = 0.01;
    inArc.touchSpeed = 1;
    CHECK(feel(inArc).amplitude == hard.amplitude);
    CHECK(feel(inArc).duration == Approx(kKnockDuration - 0.01));
    inArc.sinceTouch = kKnockDuration;
    CHECK(feel(inArc) == feel(burning(1)));
}

TEST_CASE("the same state feels the same") {
    const TipFeel tip = burning(0.6f, 0.4f, 0.2f);
    CHECK(feel(tip) == feel(tip));
}
