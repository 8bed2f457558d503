// Checks of lessons as files: permitted expectations, their comparison with a judgement, and messages about faults.
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/training/lesson/lesson_check.hpp"
#include "core/weld/process/shielding_gas.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

using namespace meltpool;
using meltpool::test::containsText;

namespace {

namespace fs = std::filesystem;

fs::path lessons() {
    return test::testFolder().parent_path() / "app" / "data" / "lessons";
}

LessonCheck checkFrom(const std::string& text) {
    const fs::path file = test::scratchFolder("check") / "one.toml";
    writeTextFileAtomically(file, text);
    return readLessonCheck(file, lessons());
}

std::string refusal(const std::string& text) {
    try {
        checkFrom(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

/// Returns a judgement with a score of 81, speed lowest, a bead 7 mm wide that fails by overlap.
Judgement judged() {
    Judgement made;
    TechniqueScore score;
    score.scored = true;
    score.total = 81;
    score.parameters.resize(2);
    score.parameters[0].quantity = TechniqueQuantity::aim;
    score.parameters[0].score = 100;
    score.parameters[1].quantity = TechniqueQuantity::travelSpeed;
    score.parameters[1].score = 62;
    score.lowest = TechniqueQuantity::travelSpeed;
    made.score = score;
    WeldMeasures weld;
    weld.mean.toeWidth = 7e-3;
    made.weld = weld;
    Verdict verdict;
    VerdictItem overlap;
    overlap.name = "overlap";
    overlap.state = VerdictState::fail;
    verdict.items = {overlap};
    made.verdict = verdict;
    return made;
}

const std::string kHead = "lesson = 'gmaw-bead'\n";

} // namespace

TEST_CASE("a check holds score, parameters, verdict and measured weld against what is expected", "[training][check]") {
    const LessonCheck check = checkFrom(
        kHead + "[set]\nvoltage = 23\n[bend]\ntime = 0.5\nturn_deg = 90\ntremor_seed = 3\ntremor_mm = 0.1\n"
                "[expect]\nscore = [80, 90]\nscored = true\naccepted = true\nlowest = 'travel_speed'\n"
                "travel_speed = [0, 60]\ntoe_width_mm = [6.5, 7.5]\npenetration_mm = [1, 2]\noverlap = 'fail'\n");
    CHECK(check.name == "one");
    CHECK(check.bend.time == 0.5);
    CHECK(check.bend.turn == Approx(1.5707963));
    CHECK(check.bend.tremor == 3);
    CHECK(check.bend.tremorPlace == Approx(1e-4));
    CHECK(check.bend.tremorAngle == Approx(HandTremor::kAngle));
    const auto values = checkJudgement(check, judged());
    REQUIRE(values.size() == 8);
    const auto outcome = [&](std::string_view key) {
        for (const CheckedValue& each : values)
            if (each.key == key) return each;
        FAIL("no value " << key);
        return CheckedValue{};
    };
    CHECK(outcome("score").passed);
    CHECK(outcome("score").expected == "80 to 90");
    CHECK(outcome("scored").passed);
    CHECK_FALSE(outcome("accepted").passed);
    CHECK(outcome("accepted").found == "no");
    CHECK(outcome("lowest").passed);
    CHECK_FALSE(outcome("travel_speed").passed);
    CHECK(outcome("travel_speed").found == "62");
    CHECK(outcome("toe_width_mm").passed);
    CHECK_FALSE(outcome("penetration_mm").passed); // this weld has no penetration
    CHECK(outcome("penetration_mm").found == "none");
    CHECK(outcome("overlap").passed);
}

TEST_CASE("an attempt without score meets no range of it", "[training][check]") {
    Judgement judgement = judged();
    judgement.score->scored = false;
    const auto values = checkJudgement(checkFrom(kHead + "[expect]\nscore = [0, 100]\nscored = false\n"), judgement);
    REQUIRE(values.size() == 2);
    CHECK_FALSE(values[0].passed);
    CHECK(values[1].passed);
}

TEST_CASE("a bad check is refused in one sentence with file, line and expectation", "[training][check]") {
    struct Case {
        std::string text, place, expectation;
    };
    const std::vector<Case> cases{
        {kHead, "one.toml:1: ", "expect"},
        {kHead + "[expect]\n", "one.toml:2: ", "at least one value"},
        {kHead + "[expect]\nbeauty = [0, 1]\n", "one.toml:3: ", "expected score"},
        {kHead + "[expect]\nscore = 90\n", "one.toml:3: ", "expected a list"},
        {kHead + "[expect]\nscore = [90, 80]\n", "one.toml:3: ", "expected [least, most]"},
        {kHead + "[expect]\nlowest = 'whip'\n", "one.toml:3: ", "expected one of"},
        {kHead + "[expect]\noverlap = 'bad'\n", "one.toml:3: ", "expected one of pass"},
        {kHead + "torch = 'nowhere.csv'\n[expect]\nscore = [0, 1]\n", "one.toml:2: ", "nowhere.csv"},
        {kHead + "[bend]\ntime = 0\n[expect]\nscore = [0, 1]\n", "one.toml:3: ", "expected a number from"},
        {kHead + "[set]\nbeauty = 1\n[expect]\nscore = [0, 1]\n", "one.toml:3: ", "beauty"},
        {"lesson = 'nothing'\n[expect]\nscore = [0, 1]\n", "one.toml:1: ", "catalogue"},
        {"lesson = 'classic'\n[expect]\nscore = [0, 1]\n", "one.toml:3: ", "[technique]"},
        {kHead + "luck = 1\n[expect]\nscore = [0, 1]\n", "one.toml:2: ", "unknown key"},
    };
    for (const Case& bad : cases) {
        INFO(bad.text);
        const std::string sentence = refusal(bad.text);
        CHECK_THAT(sentence, containsText(bad.place));
        CHECK_THAT(sentence, containsText(bad.expectation));
        CHECK(sentence.find('\n') == std::string::npos);
    }
}

TEST_CASE("a check whose torch is a record takes the attempt's values, and its changes at their places of the path",
          "[training][check]") {
    const fs::path folder = test::scratchFolder("check-record");
    writeTextFileAtomically(folder / "attempt.csv", "# meltpool record 1\n# lesson gmaw-bead\n# value voltage 21\n"
                                                    "time_s,x_mm,y_mm,z_mm,qx,qy,qz,qw,trigger\n"
                                                    "0.1,0,3,0,0,0,0,1,1\n0.2,1,3,0,0,0,0,1,1\n# set voltage 26\n"
                                                    "0.3,2,3,0,0,0,0,1,1\n0.4,3,3,0,0,0,0,1,1\n");
    writeTextFileAtomically(folder / "one.toml",
                            kHead + "torch = 'attempt.csv'\n[bend]\ntime = 0.5\n[expect]\nscore = [0, 100]\n");
    const LessonCheck check = readLessonCheck(folder / "one.toml", lessons());
    REQUIRE(check.lesson.recorded);
    CHECK(check.lesson.process.of<Gmaw>().voltage == 21);
    // A record of a program that knew no gas was welded in the mix, which its lesson names.
    CHECK(check.lesson.process.of<Gmaw>().gas == static_cast<int>(GasKind::arCo2));
    CHECK(check.lesson.run.seconds == Approx(0.4));
    REQUIRE(check.lesson.recorded->changes.size() == 1);
    CHECK(check.lesson.recorded->changes[0].steps == 1); // two steps of the path, which takes half its time here
    CHECK(check.lesson.recorded->changes[0].value == "26");
}
