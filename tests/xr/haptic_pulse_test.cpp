// Tests the samples that a controller plays instead of a plain vibration.
#include "tests/support/catch.hpp"
#include "xr/haptic_pulse.hpp"

#include <algorithm>
#include <array>
#include <cmath>

using namespace meltpool::xr;

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
