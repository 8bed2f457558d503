// Tests the rights of a person during each activity, and the leader of the torch.
#include "app/activities/activities.hpp"
#include "app/session/torch_lead.hpp"
#include "tests/support/catch.hpp"

namespace meltpool {

namespace {

/// Makes a lesson that nothing could make cheaper: it is measured once.
Lesson coarsest() {
    Lesson lesson;
    lesson.model = LessonModel::Weld;
    lesson.workpiece.spacingMm = 2;
    lesson.surface.cells = 16;
    return lesson;
}

} // namespace

TEST_CASE("without metal nothing is allowed") {
    const Activities activities;
    const Allowed allowed = activities.allowed();
    CHECK_FALSE((allowed.ownTorch || allowed.values || allowed.help || allowed.judging || allowed.notes));
    CHECK(activities.current().nextAttempt(false) == NextAttempt::none);
    CHECK_FALSE(activities.current().inLesson());
    CHECK(TorchLead().leader(allowed) == TorchLeader::none);
}

TEST_CASE("an attempt is one's own, led from the desk or by a hand") {
    Activities activities;
    activities.turnTo(activities.attempt);
    CHECK(activities.at(activities.attempt));
    CHECK(activities.current().inLesson());
    const Allowed allowed = activities.allowed();
    CHECK((allowed.ownTorch && allowed.values && allowed.help && allowed.judging && allowed.notes));
    CHECK(activities.current().nextAttempt(true) == NextAttempt::sameMetal);
    TorchLead lead;
    CHECK(lead.leader(allowed) == TorchLeader::desk);
    lead.take(true);
    CHECK(lead.leader(allowed) == TorchLeader::hand);
    activities.end();
    CHECK_FALSE(activities.allowed().ownTorch);
}

TEST_CASE("a demonstration and a replay are led by their path, whatever a hand does") {
    Activities activities;
    TorchLead lead;
    lead.take(true);
    activities.demonstration.begin(5);
    activities.replay.line().begin(5);
    for (Activity* watched :
         {static_cast<Activity*>(&activities.demonstration), static_cast<Activity*>(&activities.replay)}) {
        activities.turnTo(*watched);
        const Allowed allowed = activities.allowed();
        CHECK(allowed.values);
        CHECK_FALSE((allowed.ownTorch || allowed.help || allowed.judging || allowed.notes));
        CHECK(lead.leader(allowed) == TorchLeader::path);
    }
    CHECK(activities.replay.nextAttempt(false) == NextAttempt::freshMetal);
    CHECK_FALSE(activities.replay.hurries());
    activities.replay.line().seek(3);
    CHECK(activities.replay.hurries());
}

TEST_CASE("a comparison goes on outside a lesson and leaves only itself") {
    Activities activities;
    activities.turnTo(activities.attempt);
    activities.endComparison();
    CHECK(activities.at(activities.attempt));
    activities.turnTo(activities.comparison);
    const Allowed allowed = activities.allowed();
    CHECK_FALSE((allowed.ownTorch || allowed.values || allowed.help || allowed.judging || allowed.notes));
    CHECK_FALSE((activities.current().inLesson() || activities.current().hurries()));
    CHECK(activities.current().nextAttempt(false) == NextAttempt::none);
    activities.endComparison();
    CHECK_FALSE(activities.at(activities.comparison));
}

TEST_CASE("an attempt after a demonstration keeps its metal unless that has other settings or counts for score") {
    Demonstration demonstration;
    demonstration.begin(5);
    CHECK(demonstration.nextAttempt(false) == NextAttempt::sameMetal);
    CHECK(demonstration.nextAttempt(true) == NextAttempt::freshMetal);
    demonstration.begin(5, true);
    CHECK(demonstration.nextAttempt(false) == NextAttempt::freshMetal);
}

TEST_CASE("while the machine's speed is measured nothing that a person does reaches the metal") {
    SpeedTrial trial;
    trial.begin(coarsest());
    CHECK(trial.hurries());
    CHECK_FALSE((trial.allowed().values || trial.allowed().help));
    CHECK(trial.nextAttempt(false) == NextAttempt::none);
    while (trial.measuring())
        trial.count(0.25, 0.1);
    CHECK_FALSE(trial.hurries()); // the trial asks how to continue
    CHECK(trial.allowed().values);
    CHECK(trial.nextAttempt(false) == NextAttempt::none);
    CHECK(trial.takeVerdict() == SpeedTrial::Verdict::more); // only a frame of its own leaves a verdict
}

} // namespace meltpool
