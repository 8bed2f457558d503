// `meltpool replay`, `compare` and `demonstration` as commands, with all that they write.
#include "core/base/text.hpp"
#include "core/weld/torch/torch_csv.hpp"
#include "tests/app/program.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

using namespace meltpool;
using meltpool::test::containsText;
using meltpool::test::runMeltpool;

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const std::string kSmall = " --pictures 0 --size 64x36 ";

std::string quoted(const fs::path& path) {
    return " '" + path.string() + "' ";
}

Json resultIn(const fs::path& folder) {
    return Json::parse(readTextFile(folder / "result.json"));
}

/// Runs a short bead on a small plate, with time before and after it, and returns the run's folder with its record.
fs::path attemptIn(const std::string& name) {
    const fs::path folder = test::scratchFolder(name);
    writeTextFileAtomically(folder / "path.toml", "start_mm = [-7, 3, 0]\ntravel_angle_deg = 10\n"
                                                  "[[move]]\nkind = 'hold'\nseconds = 1.2\n"
                                                  "[[move]]\nkind = 'arc_on'\n"
                                                  "[[move]]\nkind = 'line'\nto_mm = [7, 3, 0]\nspeed_mm_s = 10\n"
                                                  "[[move]]\nkind = 'arc_off'\n"
                                                  "[[move]]\nkind = 'hold'\nseconds = 0.2\n");
    writeTextFileAtomically(
        folder / "bead.toml",
        "title = 'Bead'\nnext = 'after-bead'\nmodel = 'weld'\ntorch = 'path.toml'\n[run]\nseconds = 3\n"
        "[workpiece]\nworkpiece = 'plate'\nlength_mm = 22\nwidth_mm = 14\nthickness_mm = 3\nspacing_mm = 1\n"
        "[process]\nprocess = 'gmaw'\nvoltage = 21\nwire_diameter_mm = 1.2\nwire_feed_m_min = 4.5\n"
        "[technique]\nlength_from_mm = -7\nlength_to_mm = 7\n"
        "travel_speed = { ideal = 10, inner = 1, outer = 3 }\n"
        "[[picture]]\nname = 'metal'\n[[picture]]\nname = 'section'\nsection_at_mm = 0\n");
    const test::Outcome run =
        runMeltpool("run" + quoted(folder / "bead.toml") + kSmall + "--set voltage=22 --out" + quoted(folder / "run"));
    INFO(run.errors);
    REQUIRE(run.code == 0);
    return folder;
}

/// Copies the record and replaces each line that begins with a given `head`.
void rewrite(const fs::path& from, const fs::path& to, const std::vector<std::pair<std::string, std::string>>& lines) {
    std::string text = readTextFile(from);
    for (const auto& [head, line] : lines) {
        const size_t at = text.find("\n" + head) + 1;
        REQUIRE(at != 0);
        text.replace(at, text.find('\n', at) - at, line);
    }
    writeTextFileAtomically(to, text);
}

} // namespace

TEST_CASE("an attempt is replayed to its bits, seeked, changed, compared and shown", "[app][attempts]") {
    static const fs::path folder = attemptIn("attempts"); // one weld serves all sections
    const fs::path record = folder / "run" / "telemetry.csv";
    const std::string lesson = " --lesson" + quoted(folder / "bead.toml");
    const std::string again = "replay" + quoted(record) + lesson + kSmall;
    const Json original = resultIn(folder / "run");

    SECTION("replayed as it was") {
        const test::Outcome same = runMeltpool(again + "--view azimuth=90 --out" + quoted(folder / "same"));
        INFO(same.errors << same.output);
        REQUIRE(same.code == 0);
        CHECK_THAT(same.output, containsText("identical to the record's, to the last bit"));
        const Json result = resultIn(folder / "same");
        CHECK(result["state_hash"] == original["state_hash"]);
        CHECK(result["recorded"]["same"] == true);
        CHECK(result["recorded"]["repetition"] == "same bits");
        CHECK(result["parameters"]["voltage"] == 22);
        CHECK(result["parameters"]["azimuth"] == 90);
        CHECK_FALSE(result.contains("what_if"));
        CHECK_THAT(same.errors, containsText("meltpool: warning: The lesson bead.toml names 'after-bead'"));
        CHECK(result["warnings"] == original["warnings"]);
        CHECK(result["warnings"].size() == 1);

        // The run's folder and the replay's hold an identical attempt.
        const test::Outcome compared = runMeltpool("compare" + quoted(folder / "run") + quoted(folder / "same") +
                                                   "--out" + quoted(folder / "page"));
        INFO(compared.errors);
        REQUIRE(compared.code == 0);
        CHECK_THAT(compared.output, containsText("no difference that the metal resolves"));
        const std::string html = readTextFile(folder / "page" / "comparison.html");
        CHECK_THAT(html, containsText("No difference that the metal resolves") && containsText("<polyline") &&
                             containsText("data:image/png;base64,") && containsText("travel speed"));
        CHECK(html.find("http") == std::string::npos);
        CHECK(html.find("<script") == std::string::npos);
    }
    SECTION("seeked") {
        const test::Outcome seek = runMeltpool(again + "--seek 0.5 --out" + quoted(folder / "seek"));
        INFO(seek.errors);
        REQUIRE(seek.code == 0);
        const Json result = resultIn(folder / "seek");
        CHECK(result["seconds"].get<double>() == Approx(0.5).margin(0.05));
        CHECK(result["recorded"]["repetition"] == "not checked");
        CHECK_THAT(runMeltpool(again + "--seek 99 --out" + quoted(folder / "seek")).errors,
                   containsText("--seek is '99'; expected a second of the attempt, from 0 to "));
    }
    SECTION("a record of another end and driver is simulated, and says so") {
        const fs::path other = folder / "other.csv";
        rewrite(record, other, {{"# driver", "# driver another machine"}, {"# state_hash", "# state_hash 00"}});
        const test::Outcome simulated =
            runMeltpool("replay" + quoted(other) + lesson + kSmall + "--out" + quoted(folder / "simulated"));
        INFO(simulated.errors);
        REQUIRE(simulated.code == 0);
        CHECK_THAT(simulated.output, containsText("simulation of the recording") && containsText("another machine"));
        const Json recorded = resultIn(folder / "simulated")["recorded"];
        CHECK(recorded["repetition"] == "simulation of the recording");
        CHECK(recorded["driver"] == "another machine");
    }
    SECTION("changed") {
        const test::Outcome changed =
            runMeltpool(again + "--what-if speed=0.6 --what-if work_angle=5 --out" + quoted(folder / "if"));
        INFO(changed.errors << changed.output);
        REQUIRE(changed.code == 0);
        CHECK_THAT(changed.output, containsText("what if: speed=0.6, work_angle=5 against original: ") &&
                                       containsText("half a particle spacing"));
        CHECK(resultIn(folder / "if" / "original")["state_hash"] == original["state_hash"]);
        const Json result = resultIn(folder / "if" / "what-if");
        CHECK(result["what_if"]["speed"] == "0.6");
        CHECK_FALSE(result["recorded"].contains("same"));
        CHECK(result["seconds"].get<double>() == Approx(original["seconds"].get<double>() / 0.6).epsilon(0.01));
        CHECK(result["score"]["total"] != original["score"]["total"]);
        CHECK_THAT(readTextFile(folder / "if" / "comparison.html"), containsText("what if: speed=0.6") &&
                                                                        containsText("slower travel") &&
                                                                        containsText("Points of 100"));
    }
    SECTION("changed by nothing it is the original") {
        const test::Outcome same =
            runMeltpool(again + "--what-if speed=1 --no-page --out" + quoted(folder / "nothing"));
        INFO(same.errors);
        REQUIRE(same.code == 0);
        CHECK_THAT(same.output, containsText("no difference that the metal resolves"));
        CHECK(resultIn(folder / "nothing" / "what-if")["state_hash"] == original["state_hash"]);
        CHECK_FALSE(fs::exists(folder / "nothing" / "comparison.html"));
    }
    SECTION("made a demonstration") {
        const fs::path shown = folder / "shown" / "demo.toml";
        fs::create_directories(shown.parent_path());
        const test::Outcome made = runMeltpool("demonstration" + quoted(record) + lesson + "--out" + quoted(shown));
        INFO(made.errors);
        REQUIRE(made.code == 0);
        const std::vector<TorchSample> samples = readTorchCsv(folder / "shown" / "demo.csv").samples;
        REQUIRE(samples.size() > 10);
        CHECK(samples.front().time == 0);
        const double length = samples.back().time;
        CHECK(length > 2.2); // one second, 1.4 s of weld and the time after it
        CHECK(length < 2.9); // shorter than the full 3 s
        const test::Outcome run = runMeltpool("run" + quoted(shown) + kSmall + "--out" + quoted(folder / "welded"));
        INFO(run.errors);
        REQUIRE(run.code == 0);
        const Json result = resultIn(folder / "welded");
        CHECK(result["parameters"]["voltage"] == 22); // value of the attempt
        CHECK(result["score"]["scored"] == true);
        CHECK(result["score"]["values"]["travel_speed"]["mean"].get<double>() == Approx(10).epsilon(0.1));
    }
}

TEST_CASE("what cannot be replayed, compared or shown is refused in one sentence", "[app][attempts]") {
    const fs::path folder = test::scratchFolder("attempts-refused");
    const std::string out = " --out" + quoted(folder / "out");
    const auto refused = [&](const std::string& command, const std::string& sentence) {
        const test::Outcome outcome = runMeltpool(command + out);
        INFO(command << ": " << outcome.errors);
        CHECK(outcome.code == 2);
        CHECK_THAT(outcome.errors, containsText(sentence));
        CHECK(std::count(outcome.errors.begin(), outcome.errors.end(), '\n') == 1);
    };
    const std::string head = "# meltpool record 1\n# lesson gmaw-bead\n# attempt 1\n";
    const std::string columns = "time_s,x_mm,y_mm,z_mm,qx,qy,qz,qw,trigger\n";
    const std::string row = "0.001,0,0,0,0,0,0,1,0\n";
    const fs::path plain = folder / "plain.csv", good = folder / "good.csv", damaged = folder / "damaged.csv",
                   strange = folder / "strange.csv";
    writeTextFileAtomically(plain, columns + row);
    writeTextFileAtomically(good, head + columns + row);
    writeTextFileAtomically(damaged, head + columns + row + "0.002,0,0,zero,0,0,0,1,0\n");
    writeTextFileAtomically(strange, "# meltpool record 1\n# lesson nowhere\n" + columns + row);
    refused("replay" + quoted(plain), "is no recorded attempt");
    refused("replay" + quoted(folder / "missing.csv"), "missing.csv");
    refused("replay" + quoted(folder), "is a folder");
    refused("replay" + quoted(damaged), "damaged.csv:6: ");
    refused("replay" + quoted(strange), "expected --lesson");
    refused("replay" + quoted(good) + "--lesson classic", "is a record of lesson 'gmaw-bead'");
    refused("replay" + quoted(good) + "--what-if colour=red", "expected one of speed, stick_out");
    refused("replay" + quoted(good) + "--what-if speed=0.5 --seek 0", "--seek and --what-if exclude each other");
    refused("replay" + quoted(good) + "--view voltage=3", "expected KEY=VALUE of what pictures show");
    refused("compare" + quoted(good) + quoted(folder / "missing.csv"), "missing.csv");
    refused("compare" + quoted(folder) + quoted(folder), "holds no result.json");
    const auto noDemonstration = [&](const std::string& file, const std::string& sentence) {
        const test::Outcome outcome = runMeltpool("demonstration" + quoted(good) + "--out" + quoted(folder / file));
        CHECK(outcome.code == 2);
        CHECK_THAT(outcome.errors, containsText(sentence));
    };
    noDemonstration("demo.txt", "ends in .csv");
    noDemonstration("demo.csv", "never pulls the trigger");
    CHECK_FALSE(fs::exists(folder / "demo.csv"));
}
