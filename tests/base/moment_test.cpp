// Times as text: equality across time zones, and text that is no time.
#include "core/base/moment.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <fstream>

using namespace meltpool;

TEST_CASE("a moment is the same whatever zone and season its date is of", "[base]") {
    const auto moment = parseMoment("2026-11-23T07:10:43Z");
    REQUIRE(moment);
    CHECK(moment->time_since_epoch().count() == 1'795'417'843'000);
    CHECK(parseMoment("2026-11-23T08:10:43+0100") == moment);
    CHECK(parseMoment("2026-11-22T21:40:43-0930") == moment);
    CHECK(parseMoment("2026-11-23T07:10:43.125Z") == *moment + std::chrono::milliseconds(125));
    // Half past two occurs twice in the night when summer time ends.
    CHECK(*parseMoment("2026-10-25T02:30:00+0200") < *parseMoment("2026-10-25T02:10:00+0100"));
    CHECK(utcText(*moment + std::chrono::milliseconds(7)) == "2026-11-23T07:10:43.007Z");
    CHECK(utcSecond(*moment + std::chrono::milliseconds(7)) == "2026-11-23T07:10:43Z");
    CHECK(parseMoment(utcText(*moment)) == moment);
    const Moment now = momentNow();
    CHECK(parseMoment(utcText(now)) == now);
}

TEST_CASE("a text that is no moment in UTC is none", "[base]") {
    for (const char* text :
         {"", "2026-11-23", "2026-11-23T08:10:43", "2026-11-23 08:10:43Z", "2026-13-01T08:10:43Z",
          "2026-02-29T08:10:43Z", "2026-11-23T24:10:43Z", "2026-11-23T08:60:43Z", "2026-11-23T08:10:43+1",
          "2026-11-23T08:10:43+1560", "2026-11-23T08:10:43.1Z", "2026-11-23T08:10:43.", "2026-11-23T08:10:43.123",
          "2026-11-23T08:1x:43Z", "2026-11-23T08:10:43ZZ", "-026-11-23T08:10:43Z"}) {
        INFO(text);
        CHECK_FALSE(parseMoment(text));
    }
}

TEST_CASE("a file was written just now; one that is not there never", "[base]") {
    const std::filesystem::path file = test::scratchFolder("moment") / "a.txt";
    CHECK_FALSE(writtenAt(file));
    std::ofstream(file) << "x";
    REQUIRE(writtenAt(file));
    CHECK(std::chrono::abs(*writtenAt(file) - momentNow()) < std::chrono::minutes(1));
}
