// The record of a run: a torch path that reads back to the same bits, and what happens on a full disk.
#include "core/base/error.hpp"
#include "core/training/telemetry.hpp"
#include "core/weld/torch/torch_csv.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

using namespace meltpool;

namespace {

TorchSample sampleAt(int i) {
    const float f = static_cast<float>(i);
    const glm::quat q = glm::normalize(glm::quat(1.0f, 0.1f * f, 0.2f, -0.3f));
    return {i / 60.0, {0.001f * f, 0.02f, -0.003f}, q, static_cast<float>(i % 2)};
}

} // namespace

TEST_CASE("telemetry is a torch recording with the metal's figures behind", "[training]") {
    const auto file = test::scratchFolder("telemetry") / "telemetry.csv";
    {
        Telemetry telemetry(file);
        for (int i = 1; i <= 100; ++i) {
            MetalStatistics metal;
            metal.molten = static_cast<size_t>(i);
            metal.maxTemperature = 0.5;
            telemetry.add(sampleAt(i), metal);
        }
        telemetry.flush();
    }
    const TorchRecording recording = readTorchCsv(file);
    REQUIRE(recording.samples.size() == 100);
    REQUIRE(recording.furtherColumns.front() == "molten");
    for (int i = 1; i <= 100; ++i) {
        const TorchSample& got = recording.samples[static_cast<size_t>(i - 1)];
        const TorchSample wanted = sampleAt(i);
        REQUIRE(got.time == wanted.time);
        REQUIRE(got.tip == wanted.tip);
        REQUIRE(got.orientation == wanted.orientation);
        REQUIRE(got.trigger == wanted.trigger);
        REQUIRE(recording.furtherCells[static_cast<size_t>(i - 1)].front() == std::to_string(i));
    }
}

TEST_CASE("a place that cannot be written is bad input, a full disk is a fault", "[training]") {
    CHECK_THROWS_AS(Telemetry("/proc/nowhere/telemetry.csv"), InputError);
    if (std::filesystem::exists("/dev/full")) CHECK_THROWS_AS(Telemetry("/dev/full"), RuntimeFault);
}
