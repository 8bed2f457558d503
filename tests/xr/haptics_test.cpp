// What the hand feels, as a function of the tip's state.
#include "tests/support/catch.hpp"
#include "xr/haptics.hpp"

#include <array>
#include <cmath>

using namespace meltpool::xr;

namespace {

TipState burning(float power, float distance, float steady) {
    TipState tip;
    tip.arc = true;
    tip.power = power;
    tip.distance = distance;
    tip.steadyDistance = steady;
    return tip;
}

} // namespace

TEST_CASE("nothing happens at the tip: silence") {
    CHECK(feel({}).silent());
    TipState pressedButCold;
    pressedButCold.power = 1; // a button alone moves nothing
    CHECK(feel(pressedButCold).silent());
    CHECK(feel(burning(0, 0.003f, 0.003f)).silent());
}

TEST_CASE("the hum grows with power and sinks with a long arc") {
    float last = 0;
    for (const float power : {0.1f, 0.4f, 0.7f, 1.0f}) {
        const HapticPulse pulse = feel(burning(power, 0.003f, 0.003f));
        CHECK(pulse.amplitude > last);
        CHECK(pulse.amplitude <= 1.0f);
        last = pulse.amplitude;
    }
    const HapticPulse right = feel(burning(1, 0.003f, 0.003f)), far = feel(burning(1, 0.006f, 0.003f));
    CHECK(far.amplitude < right.amplitude);
    CHECK(far.frequency < right.frequency);
    CHECK(right.duration > 1.0f / 72.0f); // no gap before the next frame's pulse
}

TEST_CASE("an arc about to break stutters nine times a second") {
    TipState tip = burning(1, 0.003f * kBreakingDistance, 0.003f);
    int changes = 0;
    bool on = true;
    for (int i = 0; i < 1000; ++i) {
        tip.time = i * 0.001;
        const bool now = !feel(tip).silent();
        changes += now != on ? 1 : 0;
        on = now;
    }
    CHECK(changes == 17); // nine halves on, nine off, starting with on and ending with off
    tip.distance = 0.003f;
    for (int i = 0; i < 1000; ++i) {
        tip.time = i * 0.001;
        CHECK_FALSE(feel(tip).silent());
    }
}

TEST_CASE("a touch knocks, harder when it was faster, over any hum") {
    TipState soft, hard = burning(1, 0, 0.003f);
    soft.touchBegan = hard.touchBegan = true;
    soft.approachSpeed = 0.01f;
    hard.approachSpeed = 1.0f;
    CHECK_FALSE(feel(soft).silent());
    CHECK(feel(hard).amplitude == 1.0f);
    CHECK(feel(hard).amplitude > feel(soft).amplitude);
    CHECK(feel(hard).frequency == feel(soft).frequency);
}

TEST_CASE("the same state feels the same") {
    const TipState tip = burning(0.6f, 0.004f, 0.003f);
    CHECK(feel(tip) == feel(tip));
}

TEST_CASE("PCM samples have the pulse's amplitude and frequency and join at their phase") {
    const HapticPulse pulse{0.5f, 100.0f, 0.05f};
    std::array<float, 2000> samples{};
    synthesize(pulse, 2000.0f, 0.0, samples);
    int crossings = 0;
    float largest = 0;
    for (size_t i = 1; i < samples.size(); ++i) {
        crossings += (samples[i - 1] < 0) != (samples[i] < 0) ? 1 : 0;
        largest = std::max(largest, std::abs(samples[i]));
    }
    CHECK(crossings == Approx(200).margin(2));
    CHECK(largest == Approx(0.5f).margin(0.001));
    std::array<float, 10> later{};
    synthesize(pulse, 2000.0f, 2.0 * 3.14159265358979 * 100.0 * 7.0 / 2000.0, later);
    for (size_t i = 0; i < later.size(); ++i)
        CHECK(later[i] == Approx(samples[i + 7]).margin(1e-4));
}
