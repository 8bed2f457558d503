// Tests best scores: the rules of counting, their return from the file, and an unreadable file, which is reported and
// preserved.
#include "app/library/best_scores.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

namespace meltpool {

namespace {

namespace fs = std::filesystem;

Judgement judged(double total, bool scored = true) {
    Judgement judgement;
    judgement.score.emplace();
    judgement.score->scored = scored;
    judgement.score->total = total;
    return judgement;
}

std::string joined(const std::vector<std::string>& lines) {
    std::string all;
    for (const std::string& line : lines)
        all += line + "\n";
    return all;
}

} // namespace

TEST_CASE("an attempt counts where it is scored; the verdict goes with it") {
    CHECK_FALSE(countedScore({}));
    CHECK_FALSE(countedScore(judged(90, false)));
    Judgement judgement = judged(84.4);
    REQUIRE(countedScore(judgement));
    CHECK(countedScore(judgement)->score == 84.4);
    CHECK_FALSE(countedScore(judgement)->accepted);
    judgement.verdict.emplace();
    judgement.verdict->accepted = true;
    CHECK(countedScore(judgement)->accepted);
    CHECK(bestScoreText({84.4, true, 4, false, false}) == "Best so far: 84, accepted, zoom 4");
    CHECK(bestScoreText({84.4, true, 1, true}) == "Best test: 84, accepted");
    CHECK(bestScoreText({0, false, 1, false, true}) == "Best so far: 0, changed values");
    CHECK(bestScoreText({70, true, 1, false, false, true}) == "Best so far: 70, accepted (with help)");
    CHECK(bestScoreText({70, false, 1, false, false, false, false, 0.064}) == "Best so far: 70");
    judgement.realTime = 0.25;
    CHECK(countedScore(judgement)->realTime == 0.25);
    BestScore helped{70};
    helped.cues.set(CueKind::aim);
    CHECK(bestScoreText(helped) == "Best so far: 70 (with help)");
    helped.ghost = "expert";
    CHECK(bestScoreText(helped) == "Best so far: 70 (with help)");
    BestScore set{70};
    set.chosen = "voltage 22 V";
    CHECK(bestScoreText(set) == "Best so far: 70");
}

TEST_CASE("the better score of a lesson stays, with its help, from one start to the next") {
    const fs::path file = test::scratchFolder("best-scores") / "new" / "best-scores.toml";
    {
        BestScores scores(file);
        CHECK(scores.faults().empty());
        CHECK(scores.find("gmaw-bead") == nullptr);
        CHECK(scores.offer("gmaw-bead", {61.5, false, 4, false, true}));
        CHECK(scores.offer("tee fillet \"2F\"", {80, true}));
        CHECK_FALSE(scores.offer("gmaw-bead", {61.5, true})); // a score that is no better
        CHECK(scores.find("gmaw-bead")->zoom == 4);
    }
    BestScores again(file);
    CHECK(joined(again.faults()) == "");
    REQUIRE(again.find("gmaw-bead") != nullptr);
    CHECK(again.find("gmaw-bead")->score == 61.5);
    CHECK_FALSE(again.find("gmaw-bead")->accepted);
    CHECK(again.find("gmaw-bead")->zoom == 4);
    CHECK(again.find("gmaw-bead")->changed);
    REQUIRE(again.find("tee fillet \"2F\"") != nullptr);
    CHECK(again.find("gmaw-bead")->realTime == 1);
    BestScore better{70, true, 1, false, false, false, false, 0.5};
    better.chosen = "voltage 22 V";
    better.swung = true;
    CHECK(again.offer("gmaw-bead", better));
    CHECK(BestScores(file).find("gmaw-bead")->realTime == 0.5);
    CHECK(BestScores(file).find("gmaw-bead")->chosen == "voltage 22 V");
    CHECK(BestScores(file).find("gmaw-bead")->swung);
    CHECK(bestScoreText(better).ends_with("(with help)"));
    CHECK(BestScores(file).find("tee fillet \"2F\"")->chosen.empty());
}

TEST_CASE("the best score of tests stays apart from that of practice") {
    const fs::path file = test::scratchFolder("best-scores-tests") / "best-scores.toml";
    const BestScore practised{90, true, 1, false, true}, tested{70, true, 1, true};
    {
        BestScores scores(file);
        CHECK(scores.offer("tee-fillet", tested));
        CHECK(scores.offer("tee-fillet", practised));
        CHECK(scores.offer("gmaw-bead", tested));
        CHECK_FALSE(scores.offer("gmaw-bead", {60, true, 1, true}));
    }
    BestScores again(file);
    CHECK(joined(again.faults()) == "");
    REQUIRE(again.find("tee-fillet") != nullptr);
    REQUIRE(again.findTest("tee-fillet") != nullptr);
    CHECK(again.find("tee-fillet")->score == 90);
    CHECK(again.findTest("tee-fillet")->score == 70);
    CHECK(again.findTest("tee-fillet")->forScore);
    CHECK(again.find("gmaw-bead") == nullptr);
    CHECK(again.findTest("gmaw-bead")->score == 70);
    CueSkill skill;
    skill.setGood(TechniqueQuantity::aim, 1);
    again.practise("gmaw-bead", skill); // known by a test alone
    CHECK(BestScores(file).skill("gmaw-bead") == skill);

    writeTextFileAtomically(file, "[a]\nscore = 50\nfor_score = true\n"); // of an earlier version
    CHECK(BestScores(file).find("a") == nullptr);
    REQUIRE(BestScores(file).findTest("a") != nullptr);
    CHECK(BestScores(file).findTest("a")->score == 50);
}

TEST_CASE("the cues of a best score, and how far they have faded, stay from one start to the next") {
    const fs::path file = test::scratchFolder("best-scores-cues") / "best-scores.toml";
    CueSkill skill;
    skill.setGood(TechniqueQuantity::travelSpeed, 3);
    skill.setGood(TechniqueQuantity::aim, 1);
    {
        BestScores scores(file);
        BestScore helped{70};
        helped.cues.set(CueKind::speed);
        helped.cues.set(CueKind::seam);
        helped.ghost = "best";
        scores.practise("gmaw-bead", skill); // the skill has no entry to be stored in without a best score
        CHECK_FALSE(fs::exists(file));
        CHECK(scores.offer("gmaw-bead", helped));
        CHECK(scores.skill("gmaw-bead") == CueSkill());
        scores.practise("gmaw-bead", skill);
        CHECK_FALSE(scores.offer("gmaw-bead", {50})); // a score that is no better, but practised
    }
    const BestScores again(file);
    CHECK(joined(again.faults()) == "");
    REQUIRE(again.find("gmaw-bead") != nullptr);
    CHECK(again.find("gmaw-bead")->cues.names() == "speed seam");
    CHECK(again.find("gmaw-bead")->ghost == "best");
    CHECK(again.skill("gmaw-bead") == skill);
    CHECK(again.skill("tee-fillet") == CueSkill());

    writeTextFileAtomically(file, "[a]\nscore = 5\ncues = [\"voice\"]\n[b]\nscore = 5\npractised = { aim = 9 }\n");
    const std::string told = joined(BestScores(file).faults());
    CHECK_THAT(told, test::containsText("best-scores.toml:3: [a] cues: has 'voice'"));
    CHECK_THAT(told, test::containsText("best-scores.toml:6: "));
}

TEST_CASE("two programs with the same file keep each other's scores, and the better one of a lesson") {
    const fs::path file = test::scratchFolder("best-scores-two") / "best-scores.toml";
    BestScores first(file), second(file); // both have read an empty one
    CHECK(first.offer("gmaw-bead", {60}));
    CHECK(first.offer("tee-fillet", {90, true}));
    CHECK_FALSE(second.offer("tee-fillet", {70})); // the better one is already in the file
    CHECK(second.offer("lap-fillet", {50}));
    CHECK(first.offer("gmaw-bead", {65}));
    const BestScores after(file);
    REQUIRE(after.find("lap-fillet") != nullptr);
    CHECK(after.find("gmaw-bead")->score == 65);
    CHECK(after.find("tee-fillet")->score == 90);
    CHECK(after.find("tee-fillet")->accepted);
    CHECK(second.find("tee-fillet")->score == 90);
    CHECK(joined(first.faults()) + joined(second.faults()) == "");
}

TEST_CASE("good attempts at a cue in two programs are counted together, each judged attempt once") {
    const fs::path file = test::scratchFolder("best-scores-two-cues") / "best-scores.toml";
    const auto aims = [](int good) {
        CueSkill skill;
        skill.setGood(TechniqueQuantity::aim, good);
        return skill;
    };
    BestScores(file).offer("gmaw-bead", {60});
    BestScores first(file), second(file);
    CHECK(first.beginAttempt("gmaw-bead") == CueSkill());
    CHECK(second.beginAttempt("gmaw-bead") == CueSkill());
    first.practise("gmaw-bead", aims(1));
    second.practise("gmaw-bead", aims(1));
    second.practise("gmaw-bead", aims(1)); // judged again
    CHECK(second.skill("gmaw-bead") == aims(2));
    CHECK(BestScores(file).skill("gmaw-bead") == aims(2));
    second.practise("gmaw-bead", aims(0)); // judged once more, as a poor one
    CHECK(BestScores(file).skill("gmaw-bead") == aims(1));
    CHECK(first.beginAttempt("gmaw-bead") == aims(1));
}

TEST_CASE("a fault in one lesson's best score is told with its line; the others are taken and the file is kept") {
    const fs::path file = test::scratchFolder("best-scores-fault") / "best-scores.toml";
    const std::string text = "[a]\nscore = 50\n[b]\nscore = 101\n[c]\nscore = 1\nskill = 3\n";
    writeTextFileAtomically(file, text);
    BestScores scores(file);
    const std::string told = joined(scores.faults());
    CHECK_THAT(told, test::containsText("best-scores.toml:4: [b] score: "));
    CHECK_THAT(told, test::containsText("best-scores.toml:7: [c] skill: "));
    CHECK_THAT(told, test::containsText("best-scores.broken-1.toml"));
    REQUIRE(scores.find("a") != nullptr);
    CHECK(scores.find("b") == nullptr);
    CHECK(scores.offer("b", {20}));
    CHECK(readTextFile(file.parent_path() / "best-scores.broken-1.toml") == text);
    // One fault gets one copy and one message.
    CHECK_FALSE(fs::exists(file.parent_path() / "best-scores.broken-2.toml"));
    CHECK(scores.faults().size() == 3);
    CHECK(BestScores(file).faults().empty());
}

TEST_CASE("a file that is no TOML is told and kept aside; where that is impossible nothing takes its place") {
    const fs::path file = test::scratchFolder("best-scores-broken") / "best-scores.toml";
    writeTextFileAtomically(file, "[a\nscore = ");
    BestScores scores(file);
    CHECK_THAT(joined(scores.faults()), test::containsText("best-scores.toml:1: ") &&
                                            test::containsText("the best scores so far are not shown"));
    CHECK(scores.offer("a", {20}));
    CHECK(readTextFile(file.parent_path() / "best-scores.broken-1.toml") == "[a\nscore = ");
    CHECK(BestScores(file).find("a")->score == 20);

    const fs::path device = "/proc/self/stat"; // file that is readable, not TOML, and can get no copy next to it
    if (!fs::exists(device)) return;
    BestScores stuck(device);
    CHECK_THAT(joined(stuck.faults()), test::containsText("Best scores are not kept from now on"));
    CHECK_NOTHROW(stuck.offer("a", {20}));
    CHECK(stuck.find("a")->score == 20);
}

TEST_CASE("a best score that cannot be written is told by the caller, and stays for this session") {
    BestScores scores("/proc/nowhere/best-scores.toml");
    CHECK(scores.faults().empty());
    CHECK_THROWS_AS(scores.offer("a", {20}), InputError);
    REQUIRE(scores.find("a") != nullptr);
}

} // namespace meltpool
