// Results over time: series by machine, and a page that loads nothing.
#include "app/platform/result_head.hpp"
#include "app/report/history_page.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "tests/app/program.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/places.hpp"

#include <nlohmann/json.hpp>

using namespace meltpool;
using meltpool::test::containsText;
using meltpool::test::runMeltpool;

namespace {

namespace fs = std::filesystem;

/// Head of a result of a machine whose processor has this name.
nlohmann::json headOf(const std::string& processor, const std::string& commit, const std::string& date) {
    return {{"renderer", "llvmpipe"}, {"driver", "4.5 (Core Profile) Mesa 1"},
            {"processor", processor}, {"threads", 2u},
            {"commit", commit},       {"date", date}};
}

fs::path writeResults() {
    const fs::path folder = test::scratchFolder("history");
    const auto keep = [&](const std::string& name, const nlohmann::json& json) {
        fs::create_directories((folder / name).parent_path());
        writeTextFileAtomically(folder / name, json.dump());
    };
    nlohmann::json newer = headOf("A", "bbb", "2026-11-02T00:00:00Z"),
                   older = headOf("A", "aaa", "2026-11-01T00:00:00Z");
    newer["rows"] = {{{"suite", "weld"}, {"what", "a <step>"}, {"particles", 8}, {"step_ms", 1.5}}};
    older["rows"] = {{{"suite", "weld"}, {"what", "a <step>"}, {"particles", 8}, {"step_ms", 3}}};
    keep("a/bbb-bench-weld.json", newer);
    keep("a/zzz-bench-weld.json", older); // older by its date, not by its name
    nlohmann::json errors = headOf("B", "aaa", "2026-11-01T00:00:00Z");
    errors["set"] = "logged";
    errors["mean_errors"] = {{{"name", "leg_mm"}, {"percent", 12.5}}};
    keep("b/aaa-validate-logged.json", errors);
    newer["complete"] = false;
    keep("a/stopped.json", newer);
    keep("house.json", nlohmann::json::array());
    return folder;
}

} // namespace

TEST_CASE("results of bench and validate become series by machine, in the order of their dates", "[app]") {
    const ResultHistory history = readResultHistory(writeResults());
    REQUIRE(history.machines.size() == 2);
    CHECK(history.machines[0].machine == "a-2-threads-llvmpipe-mesa-1");
    REQUIRE(history.machines[0].series.size() == 1);
    const HistorySeries& step = history.machines[0].series[0];
    CHECK(step.group == "bench weld");
    CHECK(step.name == "a <step>");
    CHECK(step.unit == "ms");
    REQUIRE(step.points.size() == 2);
    CHECK(step.points[0].commit == "aaa");
    CHECK(step.points[1].value == 1.5);
    CHECK(history.machines[1].series.at(0).group == "validate logged");
    CHECK(history.machines[1].series[0].points.at(0).value == 12.5);
    REQUIRE(history.leftOut.size() == 2); // stopped.json and house.json
}

TEST_CASE("the page of results draws each series and loads nothing", "[app]") {
    const std::string html = historyPage(readResultHistory(writeResults()));
    INFO(html);
    for (const char* text : {"a &lt;step&gt;", "1.50 ms, bbb, 2026-11-02", "<polyline", "leg_mm", "2 results"})
        CHECK_THAT(html, containsText(text));
    for (const char* text : {"http", "<script", "src="})
        CHECK(html.find(text) == std::string::npos);
}

TEST_CASE("the command draws the results of the project", "[app]") {
    const fs::path page = test::scratchFolder("history-page") / "history.html";
    const std::string results = (test::sourceFolder() / "tests" / "bench" / "results").string();
    const test::Outcome outcome = runMeltpool("history '" + results + "' --out '" + page.string() + "'");
    INFO(outcome.output);
    REQUIRE(outcome.code == 0);
    CHECK_THAT(outcome.errors, containsText("house.json is left out"));
    CHECK_THAT(readTextFile(page), containsText("GMAW bead"));
    const test::Outcome missing = runMeltpool("history /nowhere --out '" + page.string() + "'");
    CHECK(missing.code == 2);
    CHECK_THAT(missing.errors, containsText("expected a folder of results"));
}

TEST_CASE("a result in a folder of results is named by machine and commit", "[app]") {
    const fs::path folder = test::scratchFolder("result-place");
    const gl::ContextInfo& driver = test::context().info();
    CHECK(ResultPlace{}.file(driver, "bench-weld").empty());
    CHECK(ResultPlace{"my.json", {}}.file(driver, "bench-weld") == "my.json");
    const fs::path file = ResultPlace{{}, folder}.file(driver, "bench-weld");
    CHECK(file.parent_path().filename() == machineOf(resultHead(driver)));
    CHECK(fs::is_directory(file.parent_path()));
    CHECK(file.filename().string().ends_with("-bench-weld.json"));
}
