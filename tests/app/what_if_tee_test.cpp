// Effects of each what-if on the GMAW fillet of the shipped tee lesson. With MELTPOOL_KEEP=FOLDER the test stores pages
// and pictures there to look at.
#include "core/base/text.hpp"
#include "tests/app/program.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <nlohmann/json.hpp>

#include <cstdlib>

using namespace meltpool;
using meltpool::test::runMeltpool;

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Resolution of a length, mm: half a particle spacing of the lesson.
constexpr double kResolved = 0.5;

std::string quoted(const fs::path& path) {
    return " '" + path.string() + "' ";
}

fs::path keptFolder() {
    const char* kept = std::getenv("MELTPOOL_KEEP");
    if (kept == nullptr || *kept == 0) return test::scratchFolder("what-if-tee");
    fs::create_directories(fs::path(kept) / "what-if-tee");
    return fs::path(kept) / "what-if-tee";
}

/// The demonstration of the lesson with its settings; its record is the attempt.
class Tee {
  public:
    Tee() : folder_(keptFolder()) {
        const test::Outcome run = runMeltpool("run tee-fillet --pictures 0 --size 960x540 --out" + quoted(attempt()));
        INFO(run.errors);
        REQUIRE(run.code == 0);
    }

    /// Welds the attempt with this change; its page is comparison.html in the folder NAME.
    Json weldIf(const std::string& name, const std::string& wish) const {
        const fs::path out = folder_ / name;
        const test::Outcome changed = runMeltpool("replay" + quoted(attempt() / "telemetry.csv") + "--what-if " + wish +
                                                  " --pictures 0 --size 960x540 --out" + quoted(out));
        INFO(wish << ": " << changed.errors);
        REQUIRE(changed.code == 0);
        CHECK(fs::exists(out / "comparison.html"));
        WARN(changed.output.substr(0, changed.output.find("\npoints of 100")));
        CHECK(read(out / "original").at("state_hash") == own().at("state_hash"));
        return read(out / "what-if");
    }
    Json own() const { return read(attempt()); }

  private:
    fs::path attempt() const { return folder_ / "attempt"; }
    static Json read(const fs::path& run) { return Json::parse(readTextFile(run / "result.json")); }

    fs::path folder_;
};

/// Returns the item of the verdict with this name.
Json itemOf(const Json& result, const std::string& name) {
    for (const Json& item : result.at("verdict").at("items"))
        if (item.at("name") == name) return item;
    FAIL("no item " << name);
    return {};
}

double weldOf(const Json& result, const char* key) {
    INFO(key);
    REQUIRE(result.at("weld").at(key).is_number());
    return result.at("weld").at(key).get<double>();
}

/// Returns the mean of both legs, mm.
double legOf(const Json& result) {
    return (weldOf(result, "leg1_mm") + weldOf(result, "leg2_mm")) / 2;
}

double currentOf(const Json& result) {
    return result.at("arc").at("mean_current_a").get<double>();
}

} // namespace

TEST_CASE("one thing changed on the tee lesson changes the fillet as physics has it", "[app][attempts][long]") {
    const Tee tee;
    const Json own = tee.own();

    // An equal wire on less seam gives a section that is 1/0.7 as large, so legs and throat are 1.2 times as long.
    const Json slower = tee.weldIf("slower", "speed=0.7");
    CHECK(slower.at("arc").at("seconds").get<double>() > 1.3 * own.at("arc").at("seconds").get<double>());
    CHECK(slower.at("arc").at("heat_input_kj_mm").get<double>() >
          1.2 * own.at("arc").at("heat_input_kj_mm").get<double>());
    CHECK(legOf(slower) > legOf(own) + kResolved);
    CHECK(weldOf(slower, "throat_mm") > weldOf(own, "throat_mm"));
    CHECK(weldOf(slower, "penetration_mm") > weldOf(own, "penetration_mm") - kResolved);

    // A longer piece of hot wire melts with less current, and less current penetrates less. The wire is unchanged.
    const Json longer = tee.weldIf("longer-stick-out", "stick_out=6");
    CHECK(currentOf(longer) < currentOf(own) - 5);
    CHECK(weldOf(longer, "penetration_mm") < weldOf(own, "penetration_mm") + kResolved / 2);
    CHECK(legOf(longer) == Approx(legOf(own)).margin(2 * kResolved));

    // Turned about the corner, a handle that leans towards the welder brings the wire's end down to the base plate, and
    // the pool is between it and the corner: its metal remains there, and the root is fused less. A more upright handle
    // does the opposite.
    const Json flat = tee.weldIf("flat-torch", "work_angle=15");
    const Json steep = tee.weldIf("steep-torch", "work_angle=-15");
    const auto standingMore = [](const Json& result) { return weldOf(result, "leg2_mm") - weldOf(result, "leg1_mm"); };
    WARN("standing leg less lying leg: " << standingMore(flat) << " mm flat, " << standingMore(own) << " as it was, "
                                         << standingMore(steep) << " steep");
    CHECK(standingMore(flat) < standingMore(own) - kResolved);
    CHECK(standingMore(steep) > standingMore(own));
    CHECK(weldOf(flat, "root_fusion_mm") < 0.7 * weldOf(own, "root_fusion_mm"));
    CHECK(weldOf(steep, "root_fusion_mm") > weldOf(own, "root_fusion_mm") - kResolved / 2);
    CHECK(currentOf(flat) == Approx(currentOf(own)).epsilon(0.05));

    // More wire takes more current, fills more and melts deeper.
    const Json more = tee.weldIf("more-wire", "wire_feed=9");
    CHECK(currentOf(more) > 1.1 * currentOf(own));
    CHECK(legOf(more) > legOf(own));
    CHECK(weldOf(more, "throat_mm") > weldOf(own, "throat_mm"));
    CHECK(weldOf(more, "penetration_mm") > weldOf(own, "penetration_mm") - kResolved / 2);
}

TEST_CASE("a cold fillet of a right hand gets the lesson's voltage as its remedy, and is accepted with it",
          "[app][attempts][long]") {
    const fs::path folder = keptFolder() / "cold";
    const test::Outcome run =
        runMeltpool("run tee-fillet --set voltage=20 --pictures 0 --size 480x270 --out" + quoted(folder / "attempt"));
    INFO(run.errors);
    REQUIRE(run.code == 0);
    const Json cold = Json::parse(readTextFile(folder / "attempt" / "result.json"));
    CHECK(cold.at("verdict").at("accepted") == false);
    for (const char* name : {"overlap", "toe_angle"}) {
        INFO(name);
        REQUIRE(itemOf(cold, name).at("state") == "fail");
        CHECK_THAT(itemOf(cold, name).at("cure").get<std::string>(),
                   test::containsText("Set the voltage to 26 V as in the lesson: it was 20."));
        CHECK(itemOf(cold, name).at("try") == "voltage=29.5");
    }
    const test::Outcome tried =
        runMeltpool("replay" + quoted(folder / "attempt" / "telemetry.csv") +
                    "--what-if voltage=29.5 --no-page --pictures 0 --size 480x270 --out" + quoted(folder / "tried"));
    INFO(tried.errors);
    REQUIRE(tried.code == 0);
    CHECK_THAT(tried.output, test::containsText("With voltage=29.5 the weld would have been accepted: "));
}
