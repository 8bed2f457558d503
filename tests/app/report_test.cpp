// `meltpool report`: a run's results as one page that loads nothing.
#include "app/report/curve_drawing.hpp"
#include "app/report/report_page.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "tests/app/program.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <algorithm>
#include <array>
#include <cmath>

using namespace meltpool;
using meltpool::test::containsText;
using meltpool::test::runMeltpool;

namespace {

namespace fs = std::filesystem;

/// The name of the first tag that is not closed as HTML wants it; empty where all are. Names are in lower case here.
std::string firstUnclosed(const std::string& html) {
    constexpr std::array<std::string_view, 4> kVoid{"meta", "input", "img", "!doctype"};
    std::vector<std::string> open;
    for (size_t at = html.find('<'); at != std::string::npos; at = html.find('<', at + 1)) {
        const size_t end = html.find('>', at);
        if (end == std::string::npos) return "<";
        std::string name = html.substr(at + 1, html.find_first_of(" />\n", at + 2) - at - 1);
        std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
        if (name.starts_with('/')) {
            if (open.empty() || open.back() != name.substr(1)) return name;
            open.pop_back();
        } else if (html[end - 1] != '/' && std::find(kVoid.begin(), kVoid.end(), name) == kVoid.end()) {
            open.push_back(name);
        }
    }
    return open.empty() ? std::string() : open.back();
}

/// A finished run as a file says so, without a weld.
fs::path writtenRun(const char* name, const std::string& result) {
    const fs::path folder = test::scratchFolder(name);
    writeTextFileAtomically(folder / "result.json", result);
    return folder;
}

const char* const kResult = R"({"lesson": "tee <b>", "finished": true, "torch": "a.toml", "seconds": 11,
 "version": "1", "commit": "c", "renderer": "r & s", "state_hash": "00ff",
 "score": {"total": 84.4, "scored": true, "parameters": {"travel_speed": 62.5, "unknown": 1},
  "values": {"travel_speed": {"unit": "mm/s", "mean": 7.2, "ideal": 6.5, "inner": 0.6, "outer": 2}},
  "corrections": ["Travel slower."]},
 "arc": {"seconds": 7, "mean_current_a": 251.4, "mean_voltage_v": 29.1, "heat_input_kj_mm": 0.9},
 "verdict": {"standard": "ISO 5817", "edition": "2014", "level": "C", "accepted": false, "items": [
  {"name": "undercut", "value": 0.8, "limit": 0.5, "unit": "mm", "state": "fail", "at_mm": 2},
  {"name": "porosity", "value": null, "limit": null, "unit": "mm", "state": "estimated"}]},
 "weld": {"kind": "fillet", "stations": 3, "toe_width_mm": 8.5}})";

} // namespace

TEST_CASE("bytes as base64", "[app]") { // the test vectors of RFC 4648
    CHECK(base64("") == "");
    CHECK(base64("f") == "Zg==");
    CHECK(base64("fo") == "Zm8=");
    CHECK(base64("foo") == "Zm9v");
    CHECK(base64("foobar") == "Zm9vYmFy");
    CHECK(base64(std::string_view("\xFF\x00\xFE", 3)) == "/wD+");
}

TEST_CASE("ticks are round numbers within the range", "[app]") {
    CHECK(ticks(0, 10, 5) == std::vector<double>{0, 2, 4, 6, 8, 10});
    const std::vector<double> odd = ticks(-0.3, 1.7, 4);
    REQUIRE(odd.size() >= 4);
    CHECK(odd[1] == Approx(0.5));
    CHECK(ticks(1, 1, 4).empty());
}

TEST_CASE("a curve is broken where nothing is known, and drawn inside its sheet however far it wanders", "[app]") {
    Curve curve{"speed <x>", "mm/s", {0, 1, 2, 3, 4}, {5, 6, NAN, 5, 900}, CurveBand{5.5, 0.5, 2}};
    const std::string svg = curveDrawing(curve);
    CHECK(firstUnclosed(svg) == "");
    CHECK_THAT(svg, containsText("speed &lt;x&gt;") && containsText("class=\"ideal\""));
    size_t lines = 0;
    for (size_t at = svg.find("<polyline"); at != std::string::npos; at = svg.find("<polyline", at + 1))
        ++lines;
    CHECK(lines == 2);
    for (size_t at = svg.find("points=\""); at != std::string::npos; at = svg.find("points=\"", at + 1)) {
        const std::string first = svg.substr(at + 8, svg.find(' ', at) - at - 8);
        const double y = std::stod(first.substr(first.find(',') + 1));
        CHECK(y >= 22);
        CHECK(y <= 106);
    }
    curve.values.assign(5, NAN);
    CHECK(curveDrawing(curve).empty());
}

TEST_CASE("the page tells score, correction, verdict and weld, in both systems, and loads nothing", "[app]") {
    const fs::path folder = writtenRun("report-page", kResult);
    writeTextFileAtomically(folder / "technique.csv", "place_mm,arc_s,judged,direction,speed_mm_s\n-1,0.1,1,1,6\n"
                                                      "0,0.1,1,1,7\n1,0.1,1,1,8\n");
    writeTextFileAtomically(folder / "weld.csv", "place_mm,toe_width_mm\n0,8\n2,8.5\n4,9\n");
    writeTextFileAtomically(folder / "001.000s-metal.png", "old");
    writeTextFileAtomically(folder / "011.000s-metal.png", "foobar");
    const std::string html = reportPage(readRunResults(folder));
    CHECK(firstUnclosed(html) == "");
    for (const char* text : {"tee &lt;b&gt;", "r &amp; s", ">84<", "Travel slower.", "travel speed", "62.50",
                             "7.20 mm/s", "17.0 in/min", "not accepted", "undercut", "8.50 mm<", "0.335 in", "251 A",
                             "22.9 kJ/in", "data:image/png;base64,Zm9vYmFy", "<polyline", "seam-fail"}) {
        INFO(text);
        CHECK_THAT(html, containsText(text));
    }
    CHECK(html.find("http") == std::string::npos);
    CHECK(html.find("<script") == std::string::npos);
    CHECK(html.find(base64("old")) == std::string::npos); // only the last moment is shown
}

TEST_CASE("what is no finished run is refused in one sentence", "[app]") {
    const fs::path empty = test::scratchFolder("report-empty");
    CHECK_THROWS_WITH(readRunResults(empty), containsText("holds no result.json"));
    CHECK_THROWS_WITH(readRunResults(writtenRun("report-broken", "{")), containsText("is no JSON"));
    CHECK_THROWS_WITH(readRunResults(writtenRun("report-other", "[1]")), containsText("is not what a run writes"));
    CHECK_THROWS_WITH(readRunResults(writtenRun("report-cut", R"({"lesson": "a", "finished": false})")),
                      containsText("has not ended"));
    const fs::path rows = writtenRun("report-rows", kResult);
    writeTextFileAtomically(rows / "weld.csv", "a,b\n1,2\n1\n");
    CHECK_THROWS_WITH(readRunResults(rows), containsText("weld.csv:3: "));
    // Entries of other kinds than expected are left out.
    const std::string odd = reportPage(readRunResults(
        writtenRun("report-odd",
                   R"({"lesson": 3, "finished": true, "score": 4, "verdict": [], "weld": "x", "arc": {"a": "b"}})")));
    CHECK(firstUnclosed(odd) == "");
    CHECK(runMeltpool("report '" + empty.string() + "'").code == 2);
}

TEST_CASE("a run's folder becomes a page by one command", "[app]") {
    const fs::path folder = test::scratchFolder("report-run");
    const test::Outcome run =
        runMeltpool("run gmaw-bead --seconds 0.9 --pictures 0 --size 64x36 --out '" + folder.string() + "'");
    INFO(run.errors);
    REQUIRE(run.code == 0);
    const test::Outcome report = runMeltpool("report '" + folder.string() + "'");
    INFO(report.errors);
    REQUIRE(report.code == 0);
    const std::string html = readTextFile(folder / "report.html");
    CHECK(firstUnclosed(html) == "");
    CHECK_THAT(html, containsText("gmaw-bead") && containsText("data:image/png;base64,iVBOR"));
    CHECK_THAT(readTextFile(folder / "result.json"), containsText("heat_input_kj_mm"));
}
