// Tests a saved attempt's time line without a window: positions and seconds, the length of a frame, and its texts.
#include "app/activities/curve_track.hpp"
#include "app/activities/replay_end.hpp"
#include "app/activities/seek_pace.hpp"
#include "app/activities/timeline.hpp"
#include "app/activities/timeline_marks.hpp"
#include "app/library/replay_list.hpp"
#include "core/base/output_file.hpp"
#include "core/base/words.hpp"
#include "core/training/judging/seam.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/recording_bytes.hpp"

#include <cmath>
#include <limits>

namespace meltpool {

namespace {

namespace fs = std::filesystem;

constexpr double kStep = 0.02;

RecordedAttempt attemptOf(size_t rows) {
    RecordedAttempt attempt;
    attempt.rows = rows;
    attempt.stateHash = "00000000000000ff";
    attempt.head.program = "0.1.0 (abc)";
    attempt.head.driver = "one driver";
    return attempt;
}

} // namespace

TEST_CASE("an attempt plays to its end, pauses, and begins again from there") {
    ReplayTimeline line;
    CHECK_FALSE(line.playing());
    line.begin(4);
    CHECK((line.playing() && !line.seeking()));
    CHECK(line.target() == 0);
    line.reach(1.5, kStep, false);
    CHECK(line.time() == 1.5);
    line.toggle();
    CHECK_FALSE(line.playing());
    line.toggle();
    CHECK(line.playing());
    line.reach(4.005, kStep, true);
    CHECK(line.time() == 4);
    CHECK((line.over() && !line.playing()));
    line.toggle();
    CHECK((line.playing() && line.seeking()));
    CHECK(line.target() == 0);
    line.end();
    CHECK_FALSE(line.playing());
}

TEST_CASE("a replay that skips its beginning is brought to its start, and begins again there") {
    ReplayTimeline line;
    line.begin(10, 4);
    CHECK(line.start() == 4);
    CHECK((line.seeking() && line.playing()));
    CHECK(line.takeFresh());
    line.stepFrom(0);
    line.reach(4, kStep, false);
    CHECK_FALSE(line.seeking());
    line.reach(10, kStep, true);
    line.toggle();
    CHECK(line.target() == 4);
    line.seek(0); // the skipped part is there for one who wants it
    CHECK(line.target() == 0);
    line.begin(4);
    CHECK((line.start() == 0 && !line.seeking()));
}

TEST_CASE("the time of the first arc is read from a recording and from a record") {
    const fs::path folder = test::scratchFolder("replay-arc");
    const auto recorded = [&](bool arc) {
        test::RecordingBytes bytes;
        AttemptHead head = test::recordedHead("gmaw-bead");
        head.arc = arc;
        bytes.head(head);
        for (int i = 1; i <= 6; ++i) {
            RecordingStep step = test::recordedStep(i);
            step.arc.action = i < 4 ? ArcAction::out : ArcAction::burning;
            bytes.step(step);
        }
        const fs::path file = folder / "a.meltrec";
        writeFile(file, bytes.end(test::recordedEnd(6)).bytes());
        return readRecordedAttempt(file);
    };
    REQUIRE(recorded(true)->firstArc);
    CHECK(*recorded(true)->firstArc == Approx(4 / 90.0));
    CHECK_FALSE(recorded(false)->firstArc);
    const fs::path record = folder / "a.csv";
    const std::string head = "# meltpool record 1\n# lesson gmaw-bead\n# attempt 1\n"
                             "time_s,x_mm,y_mm,z_mm,qx,qy,qz,qw,trigger,arc_state\n0.1,0,0,0,0,0,0,1,0,out\n",
                      lit = "0.2,0,0,0,0,0,0,1,1,burning\n";
    writeFile(record, head);
    CHECK_FALSE(readRecordedAttempt(record)->firstArc);
    writeFile(record, head + lit + "0.3,0,0,0,0,0,0,1,1,burning\n");
    CHECK(readRecordedAttempt(record)->firstArc == 0.2);
    writeFile(record, head + lit + "# event redo 1\n0.5,0,0,0,0,0,0,1,1,burning\n");
    CHECK(readRecordedAttempt(record)->firstArc == 0.5);
}

TEST_CASE("a moment that is asked for is reached by the step that is nearest to it") {
    ReplayTimeline line;
    line.begin(4);
    line.reach(1, kStep, false);
    line.seek(2);
    CHECK((line.seeking() && line.playing()));
    line.reach(2, kStep, false); // a step already in progress changes nothing
    CHECK(line.seeking());
    CHECK(line.takeFresh());
    CHECK_FALSE(line.takeFresh());
    line.stepFrom(1);
    CHECK(line.progress() == 0);
    line.reach(1.5, kStep, false);
    CHECK(line.progress() == Approx(0.5));
    line.reach(1.98, kStep, false);
    CHECK(line.seeking());
    line.reach(1.995, kStep, false);
    CHECK_FALSE(line.seeking());
    CHECK(line.playing());

    line.seek(99);
    CHECK(line.target() == 4);
    line.takeFresh();
    line.reach(3.97, kStep, true); // the last step may end before the path does
    CHECK((!line.seeking() && line.over() && !line.playing()));
    line.seek(-3);
    CHECK(line.target() == 0);
    line.takeFresh();
    line.stepFrom(0);
    CHECK_FALSE(line.over());
    line.reach(0, kStep, false);
    CHECK_FALSE(line.seeking());
}

TEST_CASE("the speed keeps within what is offered") {
    ReplayTimeline line;
    line.begin(1);
    CHECK(line.speed() == 1);
    line.setSpeed(0.01);
    CHECK(line.speed() == ReplayTimeline::kSlowest);
    line.setSpeed(9);
    CHECK(line.speed() == ReplayTimeline::kFastest);
}

TEST_CASE("a way to another moment takes more steps a frame while frames stay short, and fewer when they do not") {
    SeekPace pace(0.2);
    pace.begin(0.02);
    CHECK(pace.steps() == SeekPace::kFirst);
    for (int frame = 0; frame < 3; ++frame)
        pace.frame(0.1);
    CHECK(pace.steps() == 8 * SeekPace::kFirst);
    pace.frame(0.4);
    CHECK(pace.steps() == 4 * SeekPace::kFirst);
    for (int frame = 0; frame < 100; ++frame)
        pace.frame(1);
    CHECK(pace.steps() == 1);
    for (int frame = 0; frame < 100; ++frame)
        pace.frame(0);
    CHECK(pace.steps() == SeekPace::kMost);
}

TEST_CASE("a slow picture takes nothing from the steps of a way to another moment") {
    SeekPace pace(0.2);
    pace.begin(0.3);
    for (int frame = 0; frame < 3; ++frame)
        pace.frame(0.5);
    CHECK(pace.steps() == 8 * SeekPace::kFirst);
    pace.begin(60); // a frame with another cause of delay does not count as slow pictures
    pace.frame(1);
    CHECK(pace.steps() == SeekPace::kFirst / 2);
}

TEST_CASE("a curve stands over the time of the attempt as far as it is known") {
    CurveTrack curve;
    curve.begin(10);
    REQUIRE(curve.values().size() == CurveTrack::kPlaces);
    curve.add(5, 7);
    curve.add(10, 3);
    curve.add(2, std::numeric_limits<double>::quiet_NaN());
    CHECK(curve.values()[CurveTrack::kPlaces / 2] == 7);
    CHECK(curve.values().back() == 3);
    CHECK(std::isnan(curve.values()[CurveTrack::kPlaces / 5]));
    CHECK((curve.least() == 3 && curve.most() == 7));
    curve.begin(0);
    curve.add(0, 1); // an attempt without a step has no places
    CHECK(std::isnan(curve.values().front()));
}

TEST_CASE("changes and events are marks at their moments, in their order") {
    RecordedAttempt attempt = attemptOf(100);
    attempt.changes.push_back({50, "voltage", "24", 0});
    attempt.events.push_back({25, "torch", "lost"});
    attempt.events.push_back({30, "torch", "seen"});
    const auto marks = timelineMarks(attempt, 4);
    REQUIRE(marks.size() == 3);
    CHECK(marks[0].time == Approx(1));
    CHECK(marks[0].text == "The torch was lost");
    CHECK((marks[0].fault && !marks[1].fault));
    CHECK(marks[2].time == Approx(2));
    CHECK(marks[2].text == "voltage 24");
    CHECK(timelineMarks(RecordedAttempt{}, 4).empty());
}

TEST_CASE("each way back is a mark where the attempt went on, but for those in an end that was given up") {
    RecordedAttempt attempt = attemptOf(100);
    attempt.notes = {{40, "zoom", "2"}, {60, "redo", "50"}, {70, "redo", "25"}, {80, "redo", "75"}};
    const auto marks = timelineMarks(attempt, 4);
    REQUIRE(marks.size() == 2);
    CHECK((marks[0].redo && marks[1].redo));
    CHECK(marks[0].time == Approx(1));
    CHECK(marks[1].time == Approx(3));
    CHECK_FALSE(marks[0].fault);
}

TEST_CASE("faults with a place are marks at the moment when the arc first burned there") {
    Technique technique(seamOf(WorkpieceParameters{}));
    ArcState arc;
    arc.action = ArcAction::burning;
    for (int i = 0; i <= 200; ++i) { // 5 mm/s from the seam's middle on
        TorchSample torch;
        torch.time = i * 0.02;
        torch.tip = {static_cast<float>(i) * 1e-4F, 0.003F, 0};
        torch.orientation = glm::angleAxis(-1.5707963F, glm::vec3(1, 0, 0));
        torch.trigger = 1;
        technique.add(torch, arc);
    }
    Judgement judgement;
    CHECK(faultMarks(technique, judgement).empty());
    judgement.score.emplace();
    judgement.score->parameters.push_back({});
    judgement.score->parameters.back().quantity = TechniqueQuantity::travelSpeed;
    judgement.score->parameters.back().worstPlaceMm = 10;
    judgement.corrections = {{TechniqueQuantity::travelSpeed, 5, "Travel slower."},
                             {TechniqueQuantity::aim, 3, "Aim better."}, // correction without a place
                             {std::nullopt, 2, "Weld all of it."}};
    judgement.verdict.emplace();
    VerdictItem item;
    item.name = "lack_of_fusion";
    item.state = VerdictState::fail;
    item.value = 1.3;
    item.unit = "mm";
    item.place = 5e-3;
    judgement.verdict->items = {item, item};
    judgement.verdict->items[1].place = 0.5; // place without an arc
    const auto marks = faultMarks(technique, judgement);
    REQUIRE(marks.size() == 2);
    CHECK(marks[0].text == "Lack of fusion fails: 1.3 mm at 5 mm of the seam");
    CHECK(marks[0].time == Approx(1).margin(0.11));
    CHECK(marks[1].text == "Travel slower.");
    CHECK(marks[1].time == Approx(2).margin(0.11));
    CHECK((marks[0].fault && marks[1].fault));
}

TEST_CASE("two attempts of one lesson are marked for a comparison, the older one first") {
    ReplayList list;
    list.show({{"c", "bead", "c"}, {"b", "tee", "b"}, {"a", "bead", "a"}});
    CHECK_FALSE(list.marks());
    CHECK_FALSE(list.mark(0));
    CHECK((list.marks() && list.marked(0)));
    CHECK_FALSE(list.mark(0)); // mark removed
    CHECK_FALSE(list.marks());
    list.mark(0);
    CHECK_FALSE(list.mark(1)); // an attempt of another lesson replaces the marks
    CHECK((list.marked(1) && !list.marked(0)));
    list.mark(2);
    REQUIRE(list.mark(0));
    CHECK_FALSE(list.marks());
    CHECK(list.pair()[0].file == "a");
    CHECK(list.pair()[1].file == "c");
}

TEST_CASE("the end says whether the metal is the attempt's, and names both machines where it is not") {
    using End = ReplayEnd::Verdict;
    const RecordedAttempt attempt = attemptOf(100);
    const ReplayMachine machine{"0.2.0 (def)", "another driver"};
    CHECK(replayEnd(&attempt, 100, 0xff, machine).verdict == End::same);
    const ReplayEnd other = replayEnd(&attempt, 100, 0xfe, machine);
    CHECK(other.verdict == End::different);
    for (const char* part : {"simulation of the recording", "version 0.1.0 (abc) on one driver",
                             "version 0.2.0 (def) on another driver"}) {
        INFO(other.text);
        CHECK(other.text.find(part) != std::string::npos);
    }
    CHECK(replayEnd(&attempt, 99, 0xff, machine).verdict == End::unknown);
    CHECK(replayEnd(nullptr, 100, 0xff, machine).verdict == End::unknown);
    RecordedAttempt broken = attempt;
    broken.stateHash.clear();
    CHECK(replayEnd(&broken, 100, 0xff, machine).text.find("broke off") != std::string::npos);
}

TEST_CASE("an attempt's length is told in seconds, from a minute on in minutes") {
    CHECK(lengthText(12.34) == "12.3 s");
    CHECK(lengthText(59.94) == "59.9 s");
    CHECK(lengthText(59.96) == "1:00 min");
    CHECK(lengthText(125) == "2:05 min");
}

TEST_CASE("a recorded verdict is said in the language's words, another word as it is recorded") {
    CHECK(verdictText("accepted") == phrase("library.attempt.accepted"));
    CHECK(verdictText("not accepted") == phrase("library.attempt.not_accepted"));
    CHECK(verdictText("").empty());
}

} // namespace meltpool
