// The help that the hand had, according to a record's notes.
#include "core/training/lesson/recorded_attempt.hpp"
#include "core/training/trainer/result_file.hpp"
#include "tests/support/catch.hpp"

using namespace meltpool;

TEST_CASE("cues and ghosts of an attempt are told by name, each once, and none where there was none", "[training]") {
    RecordedAttempt attempt;
    CHECK(factsOf(attempt).ghost.empty());
    attempt.notes = {{0, "ghost", "none"}, {0, "cues", "none"}};
    CHECK(factsOf(attempt).ghost.empty());
    CHECK(factsOf(attempt).cues.empty());
    attempt.notes = {{0, "cues", "speed aim"},    {1, "ghost", "expert place"}, {5, "ghost", "none"},
                     {6, "ghost", "expert time"}, {9, "ghost", "file place"},   {9, "cues", "none"}};
    CHECK(factsOf(attempt).ghost == "expert, file");
    CHECK(factsOf(attempt).cues == "speed aim");
}
