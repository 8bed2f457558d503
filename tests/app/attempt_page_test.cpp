// The page that the result panel's button writes from an attempt in progress.
#include "app/report/record_results.hpp"
#include "app/session/attempt_page.hpp"
#include "app/session/lesson_session.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "tests/app/markup.hpp"
#include "tests/app/small_lessons.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <cstdlib>

using namespace meltpool;
using meltpool::test::containsText;

namespace {

namespace fs = std::filesystem;

/// Leads the torch 3 mm over the plate at 8 mm/s for `seconds` while the trigger is pulled, else holds it still.
void lead(LessonSession& session, const Controls& controls, float& x, double seconds, float trigger) {
    constexpr double kFrame = 1.0 / 45;
    for (double time = 0; time < seconds; time += kFrame)
        session.advance(controls, kFrame, nullptr, [&](int, int steps) {
            if (trigger > 0) x += 8e-3f * static_cast<float>(kFrame / steps);
            TorchSample torch;
            torch.tip = {x, 0.003f, 0};
            torch.orientation = glm::angleAxis(-1.5707963f, glm::vec3(1, 0, 0));
            torch.trigger = trigger;
            return torch;
        });
}

} // namespace

TEST_CASE("a judged attempt becomes a page beside its record, and the record alone gives the same score", "[app]") {
    const fs::path folder = test::scratchFolder("attempt-page"), record = folder / "weld.csv";
    LessonSession session(test::shaders(), test::smallBead(), [] { return 0.0; });
    Controls controls;
    session.log().records().use(record, "program", "driver");
    session.log().weldedBy({AttemptOwner::Kind::person, {"0123456789abcdef", "Anna <& Co>", ""}});
    session.begin(controls);
    CHECK_THROWS_AS(writeAttemptPage(session, 1, "driver"), InputError); // no judgement yet
    float x = -0.010f;
    lead(session, controls, x, 2, 1);
    lead(session, controls, x, 1.3, 0);
    REQUIRE(session.attempt().judged());
    const fs::path page = writeAttemptPage(session, 2, "a driver");
    CHECK(page == folder / "weld.html");
    const std::string html = readTextFile(page);
    CHECK(test::firstUnclosed(html) == "");
    for (const char* text :
         {"practice", "<b>Welder:</b> Anna &lt;&amp; Co&gt;", "<b>Zoom:</b> 2.0",
          "<b>Help:</b> cues: speed angles distance aim seam arc", "a driver", "Travel speed", "ISO 5817",
          "data:image/png;base64,iVBOR", "The weld cut across at", "<polyline", "class=\"seam\""}) {
        INFO(text);
        CHECK_THAT(html, containsText(text));
    }
    CHECK(writeAttemptPage(session, 1, "a driver") == folder / "weld (2).html"); // the first page is not replaced
    REQUIRE(session.attempt().judged()->judgement.score);
    const double score = session.attempt().judged()->judgement.score->total;
    session.end("start menu");
    const RunResults hand = readRecordResults(record, test::smallBead());
    CHECK(hand.result.at("score").at("total").get<double>() == Approx(score).margin(0.01));
    CHECK(hand.notes.size() == 1);
    CHECK(hand.result.at("attempt").at("person") == "Anna <& Co>");
    CHECK(hand.result.at("attempt").at("person_id") == "0123456789abcdef");
}

TEST_CASE("the page of an attempt without a record goes into the user's folder", "[app]") {
    const fs::path folder = test::scratchFolder("attempt-pages");
    ::setenv("XDG_DATA_HOME", folder.c_str(), 1);
    const fs::path page = attemptPageName({}, "gmaw-bead", "2026-11-23 08:30");
    CHECK(page == folder / "meltpool" / "pages" / "gmaw-bead 2026-11-23 08.30.html");
    writeTextFileAtomically(page, "first");
    CHECK(attemptPageName({}, "gmaw-bead", "2026-11-23 08:30").filename() == "gmaw-bead 2026-11-23 08.30 (2).html");
    ::setenv("XDG_DATA_HOME", "/dev/null", 1);
    CHECK_THROWS_WITH(attemptPageName({}, "gmaw-bead", "2026-11-23 08:30"), containsText("cannot be created"));
    ::unsetenv("XDG_DATA_HOME");
}
