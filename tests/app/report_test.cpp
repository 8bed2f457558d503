// The page of `meltpool report`: a run's results in one file that loads no other.
#include "app/report/curve_scale.hpp"
#include "app/report/record_results.hpp"
#include "app/report/report_page.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/base/units.hpp"
#include "core/training/trainer/result_file.hpp"
#include "tests/app/markup.hpp"
#include "tests/app/program.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <algorithm>
#include <cmath>

using namespace meltpool;
using meltpool::test::containsText;
using meltpool::test::firstUnclosed;
using meltpool::test::runMeltpool;

namespace {

namespace fs = std::filesystem;

/// Writes the files of a finished run, without a weld.
fs::path writtenRun(const char* name, const std::string& result) {
    const fs::path folder = test::scratchFolder(name);
    writeTextFileAtomically(folder / "result.json", result);
    return folder;
}

const char* const kResult = R"({"lesson": "tee <b>", "finished": true, "torch": "a.toml", "seconds": 11,
 "version": "1", "commit": "c", "renderer": "r & s", "state_hash": "00ff",
 "title": "A tee & more", "chosen_text": "voltage 22 V", "simulated_text": "Gap is 1 mm instead of 0.6 mm.",
  "parameters": {"gas": "co2", "gas_flow_l_min": 12.5},
 "attempt": {"date": "2026-11-23 08:30", "driver": "other", "for_score": true, "real_time": 0.97, "zoom": 2, "guided": false, "swung": true, "held": "aim work_angle",
  "changed": false, "cues": "speed aim", "ghost": "expert"},
 "score": {"total": 84.4, "scored": true, "parameters": {"travel_speed": 62.5, "unknown": 1},
  "values": {"travel_speed": {"unit": "mm/s", "mean": 7.2, "ideal": 6.5, "inner": 0.6, "outer": 2, "lost_points": 12.3,
   "worst_at_mm": 1}},
  "wanted_mm": 40, "welded_mm": 38, "lost_to_length_points": 1.5,
  "corrections": ["Travel slower."]},
 "arc": {"process": "gmaw", "seconds": 8, "mean_current_a": 250, "mean_voltage_v": 28, "energy_kj": 56, "seam_mm": 40,
  "travel_speed_mm_s": 5, "efficiency_en_1011_1": 0.8, "heat_input_kj_mm": 1.12},
 "verdict": {"standard": "ISO 5817", "edition": "2014", "level": "C", "accepted": false, "items": [
  {"name": "overlap", "value": 0, "limit": 0.5, "limit_kind": "at_most", "unit": "mm", "state": "pass", "at_mm": 1},
  {"name": "toe_angle", "value": 100, "limit": 110, "limit_kind": "at_least", "unit": "deg", "state": "not_resolved",
   "at_mm": 3},
  {"name": "undercut", "value": 0.8, "limit": 0.5, "limit_kind": "at_most", "unit": "mm", "state": "fail", "at_mm": 2,
   "stretches_mm": [[1, 3]]},
  {"name": "surface_pore", "value": 12, "limit": null, "unit": "mm", "state": "estimated", "beyond": true,
   "rule": "The torch pushes."}]},
 "weld": {"kind": "bead", "stations": 3, "pitch_mm": 2, "toe_width_mm": 8.5, "height_mm": 2, "penetration_mm": 1.5,
  "fused_width_mm": 8}})";

} // namespace

TEST_CASE("bytes as base64", "[app]") { // the test vectors of RFC 4648
    CHECK(base64("") == "");
    CHECK(base64("f") == "Zg==");
    CHECK(base64("fo") == "Zm8=");
    CHECK(base64("foo") == "Zm9v");
    CHECK(base64("foobar") == "Zm9vYmFy");
    CHECK(base64(std::string_view("\xFF\x00\xFE", 3)) == "/wD+");
}

TEST_CASE("the page tells how the attempt was made, its score, verdict and weld, in both systems", "[app]") {
    const fs::path folder = writtenRun("report-page", kResult);
    writeTextFileAtomically(folder / "technique.csv", "place_mm,arc_s,judged,direction,speed_mm_s,current_a,voltage_v\n"
                                                      "-1,0.1,1,1,6,240,27\n0,0.1,1,1,7,250,28\n1,0.1,1,1,8,260,29\n");
    writeTextFileAtomically(folder / "weld.csv", "place_mm,toe_width_mm\n0,8\n2,8.5\n4,9\n");
    writeTextFileAtomically(folder / "001.000s-metal.png", "old");
    writeTextFileAtomically(folder / "011.000s-metal.png", "foobar");
    const std::string html = reportPage(readRunResults(folder));
    CHECK(firstUnclosed(html) == "");
    for (const char* text : {"A tee &amp; more",
                             "tee &lt;b&gt;",
                             "<b>Kind:</b> a test",
                             "2026-11-23 08:30",
                             "voltage 22 V",
                             "Gap is 1 mm instead of 0.6 mm.",
                             "<b>Gas:</b> CO2, 12.5 l/min",
                             "97 % of the clock",
                             "<b>Zoom:</b> 2.0",
                             "cues: speed aim, ghost: expert",
                             "the desk swung the torch",
                             "held by the desk: aim, work angle",
                             "r &amp; s, attempt made on other",
                             ">84<",
                             "Travel slower.",
                             "Travel speed",
                             "62.5",
                             "12.3",
                             "7.20 mm/s",
                             "17.0 in/min",
                             "38.00 mm",
                             "Seam not welded",
                             "not accepted",
                             "FAILS",
                             "at most <span",
                             "0.50 mm",
                             "at least 110.0\xC2\xB0",
                             "passes",
                             "estimated: likely. The torch pushes.",
                             "in <span class=\"mm\">mm</span><span class=\"in\">in</span> of weld",
                             "8.50 mm<",
                             "0.335 in",
                             "250 A",
                             "1.12 kJ/mm",
                             "28.4 kJ/in",
                             "0.8 \xC2\xB7 28.0 V \xC2\xB7 250 A / (",
                             "data:image/png;base64,Zm9vYmFy",
                             "<polyline",
                             "Arc current (A)",
                             "drawn to scale from its measures"}) {
        INFO(text);
        CHECK_THAT(html, containsText(text));
    }
    CHECK(html.find(base64("old")) == std::string::npos); // only the last picture is shown
    CHECK(html.find("Not scored") == std::string::npos);
}

TEST_CASE("an attempt that is at hand has the page of its run's folder", "[app]") {
    Lesson lesson = findLesson("gmaw-bead", test::testFolder().parent_path() / "app" / "data" / "lessons");
    ResultContext context;
    Judgement& judgement = context.judgement;
    judgement.arc = {2, 400, 9000};
    judgement.seam.resize(3);
    for (size_t i = 0; i < judgement.seam.size(); ++i) {
        judgement.seam[i].place = 1e-3 * static_cast<double>(i);
        judgement.seam[i].values[TechniqueQuantity::travelSpeed] = 5.3e-3 + 1e-4 * static_cast<double>(i);
    }
    WeldStation station;
    station.toeWidth = 8.123e-3;
    station.undercut1 = 0.7e-3;
    station.rootFused = 0.984;
    judgement.weld = summarise({station, station, station}, WeldKind::bead, 2e-3, 1e-3);
    judgement.verdict = judge(*judgement.weld, *lesson.acceptance, lesson.nominalWeld());
    const LessonResult result;

    const fs::path folder = test::scratchFolder("report-at-hand");
    writeResult(folder / "result.json", lesson, result, context);
    writeTechniqueCsv(folder / "technique.csv", judgement.seam, judgement.distance);
    writeWeldTable(folder / "weld.csv", *judgement.weld);
    const std::string page = reportPage(resultsOf(resultEntries(lesson, &result, context), judgement));
    CHECK(page == reportPage(readRunResults(folder)));
    for (const char* text : {"8.12 mm", "undercut, side 1", "98 %", "<td>undercut</td>", "<polyline"})
        CHECK_THAT(page, containsText(text));
}

TEST_CASE("figures stand on the page in the order of an inspector, those of a newer program last", "[app]") {
    const fs::path folder = writtenRun(
        "report-figures",
        R"({"lesson": "tee", "finished": true, "seconds": 1, "weld": {"a_new_one_mm": 7, "haz_width_mm": 3, "leg1_mm": 6,
        "leg2_mm": 5, "root_fused_percent": 98.4, "stations": 15, "throat_mm": 4}, "arc": {"mean_current_a": 250.2}})");
    const std::string html = reportPage(readRunResults(folder));
    size_t last = 0;
    for (const char* text : {"leg on the base plate", "leg on the upright plate", "throat", "root fused", "98 %",
                             "heat-affected zone", "sections measured", ">15<", "a new one", "mean current", "250 A"}) {
        INFO(text);
        const size_t place = html.find(text, last);
        REQUIRE(place != std::string::npos);
        last = place;
    }
}

TEST_CASE("a curve that stays the same has an axis of its size", "[app]") {
    const CurveRange flat = shownRange({29.5, 29.5}, std::nullopt);
    CHECK(flat.from == Approx(28.025));
    CHECK(flat.to == Approx(30.975));
    CHECK(curveTicks(flat, 2).count > 0);
    CHECK(shownRange({0, 0}, std::nullopt).to == Approx(0.05));
    CHECK(shownRange({20, 21}, std::nullopt).to == 21);
}

TEST_CASE("the page loads nothing and runs nothing", "[app]") {
    const fs::path folder = writtenRun("report-alone", kResult);
    writeTextFileAtomically(folder / "011.000s-metal.png", "foobar");
    const std::string html = reportPage(readRunResults(folder));
    for (const char* text : {"http", "<script", "<link", "<iframe", "@import", "url(", "onload"}) {
        INFO(text);
        CHECK(html.find(text) == std::string::npos);
    }
    size_t sources = 0;
    for (size_t at = html.find("src=\""); at != std::string::npos; at = html.find("src=\"", at + 1), ++sources)
        CHECK(html.compare(at + 5, 22, "data:image/png;base64,") == 0);
    CHECK(sources == 1);
    for (size_t at = html.find("<img"); at != std::string::npos; at = html.find("<img", at + 1))
        CHECK(html.compare(at + 4, 6, " alt=\"") == 0);
    CHECK_THAT(html, containsText("<html lang=\"en\">"));
}

TEST_CASE("imperfections are lettered, failures first, and stand at their places on the strip", "[app]") {
    const fs::path folder = writtenRun("report-strip", kResult);
    writeTextFileAtomically(folder / "weld.csv", "place_mm\n0\n2\n4\n"); // widened by the pitch: -1 to 5 mm
    const std::string html = reportPage(readRunResults(folder));
    const size_t undercut = html.find("<td>A</td><td>undercut</td>"), angle = html.find("<td>B</td><td>toe angle</td>");
    REQUIRE(undercut != std::string::npos);
    REQUIRE(angle != std::string::npos);
    CHECK(undercut < angle);
    CHECK(html.find("<td></td><td>overlap</td>") > angle);
    // 2 mm is at 20 + 3/6 of 600; the strip around it, 1 to 3 mm, is a third.
    CHECK_THAT(html, containsText("class=\"mark-fail\" x1=\"320.0\""));
    CHECK_THAT(html, containsText("class=\"fault\" x=\"220.0\" y=\"34.0\" width=\"200.0\""));
    CHECK_THAT(html, containsText("text-anchor=\"middle\">A</text>"));
    CHECK_THAT(html, containsText("class=\"mark-other\" x1=\"420.0\""));
}

TEST_CASE("the page names likely cause and remedy of what fails, and the command that tries it", "[app]") {
    const std::string html = reportPage(readRunResults(
        writtenRun("report-cures", R"({"lesson": "tee", "finished": true, "verdict": {"standard": "ISO 5817", "items": [
  {"name": "overlap", "unit": "mm", "value": 1, "state": "fail", "at_mm": 1, "cure": "Overlap: <set> the voltage.",
   "try": "voltage=20"},
  {"name": "toe_angle", "unit": "deg", "value": 90, "state": "fail", "cure": "Toe angle: the same.", "try": "voltage=20"},
  {"name": "undercut", "unit": "mm", "value": 1, "state": "fail", "at_mm": 2, "cure": "Undercut: aim lower."}]}})")));
    CHECK(firstUnclosed(html) == "");
    for (const char* text : {"Why it failed, and what to try", "<li>Overlap: &lt;set&gt; the voltage. ",
                             "meltpool replay FILE --what-if voltage=20 --out DIR", "<li>Undercut: aim lower.</li>"})
        CHECK_THAT(html, containsText(text));
    const size_t command = html.find("--what-if voltage=20");
    CHECK(html.find("--what-if voltage=20", command + 1) == std::string::npos); // once for both
    CHECK_THAT(reportPage(readRunResults(writtenRun("report-no-cures", kResult))),
               !containsText("Why it failed, and what to try"));
}

TEST_CASE("the page says how far a value may be off, what was not assessed, and that a weld is unfinished", "[app]") {
    const std::string html = reportPage(readRunResults(
        writtenRun("report-open", R"({"lesson": "tee", "finished": true, "verdict": {"standard": "ISO 5817",
  "accepted": true, "not_assessed": 3, "complete": true, "items": [
  {"name": "insufficient_throat", "unit": "mm", "value": 0.3, "uncertainty": 0.2, "mean_over_mm": 40,
   "state": "not_resolved"},
  {"name": "overlap", "unit": "mm", "value": 0, "uncertainty": 1, "state": "pass"},
  {"name": "crack", "limit_kind": "not_permitted", "state": "not_resolved"},
  {"name": "undercut", "unit": "mm", "value": 0.7, "uncertainty": 1, "state": "not_resolved", "at_mm": 2}]}})")));
    CHECK(firstUnclosed(html) == "");
    CHECK_THAT(html, containsText("No fault found: 1 passed, 3 left to see on a real weld."));
    CHECK_THAT(html, containsText("not simulated"));
    CHECK_THAT(html, containsText(", mean over "));
    CHECK_THAT(html, containsText(" \xC2\xB1 "));
    CHECK_THAT(html, !containsText("Unfinished"));
    CHECK_THAT(html, !containsText("a short leg counts, too")); // told where it fails
    const std::string small = reportPage(readRunResults(
        writtenRun("report-small", R"({"lesson": "tee", "finished": true, "verdict": {"standard": "ISO 5817",
  "accepted": false, "complete": true, "items": [
  {"name": "insufficient_throat", "unit": "mm", "value": 0.8, "uncertainty": 0.1, "state": "fail"}]}})")));
    CHECK_THAT(small, containsText("a short leg counts, too"));
    const std::string half = reportPage(readRunResults(
        writtenRun("report-half", R"({"lesson": "tee", "finished": true, "verdict": {"standard": "ISO 5817",
  "accepted": false, "not_assessed": 3, "complete": false, "judged_mm": 20, "asked_mm": 40, "items": []}})")));
    CHECK_THAT(half, containsText("Unfinished: "));
    CHECK_THAT(half, !containsText("No fault found"));
}

TEST_CASE("words from files cannot become markup", "[app]") {
    const std::string html = reportPage(readRunResults(
        writtenRun("report-hostile",
                   R"({"lesson": "<script>alert(1)</script>", "title": "\"><img src=x onerror=y>", "finished": true,
 "torch": "</title><b>", "attempt": {"cues": "'><i>", "program": "<u>"}, "chosen_text": "<s>",
 "score": {"scored": false, "reason": "<em>"}, "weld": {"<p>_mm": 1},
 "verdict": {"standard": "<q>", "level": "<r>", "edition": "<v>", "items": [
  {"name": "<w>", "unit": "<x>", "value": 1, "state": "\"><y>", "rule": "<z>", "at_mm": 1}]}})")));
    CHECK(firstUnclosed(html) == "");
    for (const char* text : {"<script>", "<img", "<b>\n", "<i>", "<u>", "<s>", "<em>", "<q>", "<r>", "<v>", "<w>",
                             "<x>", "<y>", "<z>", "<p>_"}) {
        INFO(text);
        CHECK(html.find(text) == std::string::npos);
    }
    CHECK_THAT(html, containsText("&lt;script&gt;alert(1)"));
}

TEST_CASE("what is missing is told, not drawn", "[app]") {
    const std::string html =
        reportPage(readRunResults(writtenRun("report-bare", R"({"lesson": "classic", "finished": true})")));
    CHECK(firstUnclosed(html) == "");
    for (const char* text : {"there is no score", "There is no picture", "There are no curves", "no person's attempt"})
        CHECK_THAT(html, containsText(text));
    CHECK(html.find("<svg") == std::string::npos);
    CHECK(html.find("<img") == std::string::npos);
    CHECK(html.find("class=\"turn\"") == std::string::npos); // one side is enough
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
    // Entries of unexpected kinds are left out.
    const std::string odd = reportPage(readRunResults(
        writtenRun("report-odd",
                   R"({"lesson": 3, "finished": true, "score": 4, "verdict": [], "weld": "x", "arc": {"a": "b"}})")));
    CHECK(firstUnclosed(odd) == "");
    CHECK(runMeltpool("report '" + empty.string() + "'").code == 2);
    // A page never replaces a file that it is made from.
    const fs::path whole = writtenRun("report-kept", kResult);
    const test::Outcome over =
        runMeltpool("report '" + whole.string() + "' --out '" + (whole / "result.json").string() + "'");
    CHECK(over.code == 2);
    CHECK_THAT(over.errors, containsText("written over"));
    CHECK(readTextFile(whole / "result.json") == kResult);
    CHECK(runMeltpool("report '" + whole.string() + "' '" + whole.string() + "' --out a.html").code == 2);
    const test::Outcome file = runMeltpool("report '" + (whole / "result.json").string() + "'");
    CHECK(file.code == 0);
    CHECK(fs::exists(whole / "report.html"));
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
    const std::string result = readTextFile(folder / "result.json");
    CHECK_THAT(result, containsText("heat_input_kj_mm"));

    // The record alone gives an identical description of the hand.
    const test::Outcome alone = runMeltpool("report '" + (folder / "telemetry.csv").string() + "'");
    INFO(alone.errors);
    REQUIRE(alone.code == 0);
    const std::string page = readTextFile(folder / "telemetry.html");
    CHECK(firstUnclosed(page) == "");
    CHECK_THAT(page, containsText("made from the record alone"));
    const RunResults hand =
        readRecordResults(folder / "telemetry.csv",
                          findLesson("gmaw-bead", test::testFolder().parent_path() / "app" / "data" / "lessons"));
    const RunResults whole = readRunResults(folder);
    CHECK(hand.result.at("score").at("scored") == whole.result.at("score").at("scored"));
    CHECK(hand.result.at("arc").at("energy_kj").get<double>() ==
          Approx(whole.result.at("arc").at("energy_kj").get<double>()).epsilon(1e-6));
    CHECK_FALSE(hand.result.contains("weld"));
    REQUIRE(hand.technique.columns == whole.technique.columns);
    REQUIRE(hand.technique.rows.size() == whole.technique.rows.size());
    const auto speeds = hand.technique.column("speed_mm_s"), first = whole.technique.column("speed_mm_s");
    for (size_t i = 0; i < speeds.size(); ++i)
        if (std::isfinite(first[i])) CHECK(speeds[i] == Approx(first[i]).epsilon(1e-5));
    CHECK(runMeltpool("report '" + (folder / "technique.csv").string() + "'").code == 2); // not a record
}

TEST_CASE("the page opens in the units of the person who makes it, and can switch") {
    const fs::path run = writtenRun("report-units", kResult);
    CHECK_THAT(reportPage(readRunResults(run)), containsText("id=\"metric\" checked>") && containsText("id=\"inch\">"));
    chooseUnits(UnitSystem::inches);
    const std::string html = reportPage(readRunResults(run));
    chooseUnits(UnitSystem::metric);
    CHECK_THAT(html, containsText("id=\"metric\">") && containsText("id=\"inch\" checked>"));
}
