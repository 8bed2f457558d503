// The benchmark's frame: its measured values and the report that other programs read.
#include "app/bench/bench.hpp"
#include "app/bench/card.hpp"
#include "app/bench/lesson.hpp"
#include "app/bench/looks.hpp"
#include "app/bench/parts.hpp"
#include "core/base/resources.hpp"
#include "core/gl/buffer.hpp"
#include "core/render/look/measures.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <nlohmann/json.hpp>

using namespace meltpool;

namespace {

double further(const BenchRow& row, const std::string& name) {
    for (const auto& [key, value] : row.further)
        if (key == name) return value;
    FAIL("the row has no number '" + name + "'");
    return 0;
}

/// A bead on a plate so small and coarse that one simulated second takes little time.
Lesson smallBead() {
    Lesson lesson = findLesson("gmaw-bead", resourceFolder() / "data" / "lessons");
    for (const auto& [key, value] : {std::pair{"length_mm", "30"}, {"width_mm", "20"}, {"spacing_mm", "2"}})
        lesson.set(key, value, "test");
    return lesson;
}

} // namespace

TEST_CASE("a measurement keeps the least time and the passes of its own suite", "[app]") {
    Bench bench(test::shaders(), "suite");
    const gl::Buffer buffer("bench test", 1 << 16);
    int runs = 0;
    const BenchRow row = bench.measure(
        "clear",
        [&](gl::Profiler& profiler) {
            const gl::Scope scope(&profiler, "clear pass");
            buffer.clear();
            ++runs;
        },
        0.0, 5, 50);
    CHECK(runs == 2 + 5); // two runs warm up
    CHECK(row.suite == "suite");
    CHECK(row.what == "clear");
    CHECK(row.stepMs > 0);
    REQUIRE(row.passes.size() == 1);
    CHECK(row.passes[0].name == "clear pass");
    CHECK(row.passes[0].leastMs >= 0);
    CHECK(row.passes[0].meanMs >= row.passes[0].leastMs);
}

TEST_CASE("the report names the machine once and each row with its fields", "[app]") {
    BenchRow row;
    row.suite = "classic";
    row.what = "step";
    row.particles = 8192;
    row.stepMs = 1.5;
    row.passes = {{"sort", 0.5, 0.625}, {"density", 0.75, 1.5}};
    row.bytesPerParticle = 120;
    row.bytes = 983040;
    row.further = {{"times_all_pairs", 30}};
    const nlohmann::json json = nlohmann::json::parse(benchJson(test::context().info(), {row, row}, true));
    for (const char* field : {"complete", "renderer", "driver", "processor", "threads", "version", "commit", "date"})
        CHECK(json.contains(field));
    CHECK(json.at("renderer") == test::context().info().renderer);
    REQUIRE(json.at("rows").size() == 2);
    const auto& first = json.at("rows").at(0);
    CHECK(first.at("suite") == "classic");
    CHECK(first.at("particles") == 8192);
    CHECK(first.at("step_ms") == 1.5);
    CHECK(first.at("passes").at("density") == 0.75);
    CHECK(first.at("mean_of_passes").at("density") == 1.5);
    CHECK(first.at("bytes_per_particle") == 120);
    CHECK(first.at("times_all_pairs") == 30);
}

TEST_CASE("a measured lesson tells its speed and the share of each part", "[app]") {
    Bench bench(test::shaders(), "lesson");
    const LessonMeasurement measurement{0.1, 1, 10, 160, 90};
    const BenchRow row = measureLesson(bench, smallBead(), measurement);
    CHECK(row.suite == "lesson");
    CHECK(row.particles > 100);
    CHECK(row.bytesPerParticle > 50);
    CHECK(further(row, "pictures") == 10);
    CHECK(further(row, "steps") >= 90); // a step is a 90th of a second at most
    CHECK(further(row, "dispatches") > further(row, "steps"));
    CHECK(further(row, "simulated_over_wall") == Approx(1e3 / row.stepMs)); // one second is measured
    double shares = 0;
    for (const char* part : {"physics_share", "surface_share", "picture_share", "rest_share"}) {
        INFO(part);
        CHECK(further(row, part) > 0);
        CHECK(further(row, part) < 1);
        shares += further(row, part);
    }
    CHECK(shares == Approx(1));
}

TEST_CASE("the card's suite measures pools until one is slow, and a weld with both eyes", "[app]") {
    Bench bench(test::shaders(), "card");
    CardLimits limits;
    limits.seconds = 1e6; // repeats end the measurement, however slow the machine is
    limits.longestPool = 1e6;
    limits.repeats = 5;
    limits.largestPool = 256 * 4;
    limits.eyeWidth = 64;
    limits.eyeHeight = 48;
    limits.weldSeconds = 0.05;
    measurePools(bench, limits);
    REQUIRE(bench.rows().size() == 2);
    CHECK(bench.rows()[0].particles == 6 * 6 * 6);
    CHECK(bench.rows()[1].particles == 10 * 10 * 10);
    for (const BenchRow& row : bench.rows()) {
        CHECK(row.suite == "card");
        CHECK(further(row, "faults") == 0);
        CHECK(further(row, "searches") >= 1);
        CHECK(row.stepMs <= further(row, "median_ms"));
        CHECK(further(row, "median_ms") <= further(row, "ms_99"));
    }
    limits.longestPool = 0;
    measurePools(bench, limits);
    CHECK(bench.rows().size() == 3); // even the smallest case is slow

    measureWeldAndEyes(bench, smallBead(), limits);
    REQUIRE(bench.rows().size() == 6);
    const BenchRow& weld = bench.rows()[3];
    CHECK(weld.particles > 100);
    CHECK(further(weld, "welded_s") >= 0.04);
    CHECK(further(weld, "dispatches") > 10);
    CHECK(further(weld, "simulated_over_wall") == Approx(further(weld, "simulated_ms") / further(weld, "median_ms")));
    CHECK(bench.rows()[4].what == "gmaw-bead, surface after a step");
    CHECK(further(bench.rows()[5], "eye_width") == 64);
    CHECK(bench.rows()[5].stepMs > 0);
}

TEST_CASE("empty dispatches are 200 and timed on the GPU and by the clock", "[app]") {
    Bench bench(test::shaders(), "weld");
    const std::uint64_t before = gl::dispatchCount();
    const BenchRow row = measureEmptyDispatches(bench);
    const std::uint64_t dispatches = gl::dispatchCount() - before;
    CHECK(dispatches % 200 == 0);
    CHECK(dispatches >= 5 * 200); // two runs warm up, at least three count
    CHECK(row.stepMs > 0);
    CHECK(further(row, "us_per_dispatch") == Approx(row.stepMs * 1e3 / 200));
    REQUIRE(row.passes.size() == 1);
    CHECK(row.passes[0].leastMs > 0);
}

TEST_CASE("the suite of looks measures the levels, and each measure left out, for one eye and for two", "[app]") {
    Bench bench(test::shaders(), "looks");
    Lesson lesson = findLesson("gmaw-bead", resourceFolder() / "data" / "lessons");
    lesson.set("spacing_mm", "2", "test");
    measureLooks(bench, lesson, {1.0, 160, 90, 1, 0}); // the arc burns by then
    const size_t ofAnEye = 3 + kMeasures.size();
    REQUIRE(bench.rows().size() == 2 * ofAnEye);
    CHECK(bench.rows()[0].what == "high, one eye");
    CHECK(bench.rows()[2].what == "low, one eye");
    CHECK(bench.rows()[ofAnEye].what == "high, two eyes");
    const BenchRow& high = bench.rows()[0];
    CHECK(further(high, "cpu_over_high") == 1);
    for (size_t i = 0; i < kMeasures.size(); ++i) {
        const BenchRow& row = bench.rows()[3 + i];
        CHECK(row.suite == "looks");
        CHECK(row.what == "high without " + std::string(kMeasures[i].key) + ", one eye");
        CHECK(further(row, "measure_cpu_ms") == Approx(further(high, "cpu_ms") - further(row, "cpu_ms")));
        CHECK(further(row, "measure_gpu_ms") == Approx(further(high, "gpu_ms") - further(row, "gpu_ms")));
    }
    const auto passesOf = [](const BenchRow& row) {
        std::string names;
        for (const BenchPass& pass : row.passes)
            names += pass.name + ";";
        return names;
    };
    CHECK_THAT(passesOf(high), test::containsText("draw glare"));
    CHECK_THAT(passesOf(bench.rows()[2]), !test::containsText("draw glare"));
}
