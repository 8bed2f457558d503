// The benchmark's frame: what a measurement keeps, and the report that other programs read.
#include "app/bench/bench.hpp"
#include "core/gl/buffer.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <nlohmann/json.hpp>

using namespace meltpool;

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
    CHECK(runs == 2 + 5); // two to warm up
    CHECK(row.suite == "suite");
    CHECK(row.what == "clear");
    CHECK(row.stepMs > 0);
    REQUIRE(row.passes.size() == 1);
    CHECK(row.passes[0].first == "clear pass");
    CHECK(row.passes[0].second >= 0);
}

TEST_CASE("the report names the machine once and each row with its fields", "[app]") {
    BenchRow row;
    row.suite = "classic";
    row.what = "step";
    row.particles = 8192;
    row.stepMs = 1.5;
    row.passes = {{"sort", 0.5}, {"density", 0.75}};
    row.bytesPerParticle = 120;
    row.bytes = 983040;
    row.further = {{"times_all_pairs", 30}};
    const nlohmann::json json = nlohmann::json::parse(benchJson(test::context().info(), {row, row}));
    for (const char* field : {"renderer", "driver", "processor", "threads", "version", "commit", "date"})
        CHECK(json.contains(field));
    CHECK(json.at("renderer") == test::context().info().renderer);
    REQUIRE(json.at("rows").size() == 2);
    const auto& first = json.at("rows").at(0);
    CHECK(first.at("suite") == "classic");
    CHECK(first.at("particles") == 8192);
    CHECK(first.at("step_ms") == 1.5);
    CHECK(first.at("passes").at("density") == 0.75);
    CHECK(first.at("bytes_per_particle") == 120);
    CHECK(first.at("times_all_pairs") == 30);
}
