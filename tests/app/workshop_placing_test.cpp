// Checks when the workshop comes to the person.
#include "app/headset/workshop_placing.hpp"
#include "tests/support/catch.hpp"

#include <cmath>

using namespace meltpool;

namespace {

constexpr double kFrame = 1.0 / 72;

xr::Pose headAt(const glm::vec3& place, float yaw = 0) {
    return {glm::angleAxis(yaw, glm::vec3(0, 1, 0)), place};
}

/// A person whose workshop is placed as the front end does it.
struct Placed {
    Workshop workshop;
    WorkshopPlacing placing;
    xr::Pose head = headAt({0, 1.6f, 0});
    bool held = false;
    bool burning = false;
    bool handsAct = false;
    int places = 0;

    Placed() { frames(0.1); }

    void frame(std::optional<bool> worn = {}, bool spaceMoved = false) {
        placing.update({head, worn, spaceMoved, held, handsAct}, workshop, kFrame);
        if (!placing.due() || burning) return;
        workshop.place(head, std::nullopt, true);
        placing.placed(head);
        ++places;
    }
    /// Frames with a head that sways as a worn one does.
    void frames(double seconds) {
        const glm::vec3 there = head.position;
        for (int i = 0; i < int(seconds / kFrame); ++i) {
            head.position = there + glm::vec3(0.004f * std::sin(0.2f * float(i)), 0, 0);
            frame();
        }
        head.position = there;
    }
    void rest(double seconds) {
        for (int i = 0; i < int(seconds / kFrame); ++i)
            frame();
    }
    /// Brings the head there in a second.
    void move(const glm::vec3& to, float yaw) {
        const glm::vec3 from = head.position;
        for (int i = 1; i <= 72; ++i) {
            head = headAt(glm::mix(from, to, float(i) / 72), yaw * float(i) / 72);
            frame();
        }
    }
    float away() const {
        return glm::distance(workshop.toWorkshop(head).position, {0, head.position.y, Workshop::kReach});
    }
};

} // namespace

TEST_CASE("the workshop is placed at the first head, and stays while its person works", "[app]") {
    Placed person;
    CHECK(person.places == 1);
    person.frames(20);
    person.move({0.2f, 1.55f, -0.2f}, 0.4f); // leans over the work
    person.frames(5);
    CHECK(person.places == 1);
}

TEST_CASE("a headset that lay on a desk brings the workshop to the person who puts it on", "[app]") {
    Placed person;
    person.head = headAt({1.5f, 0.8f, 0.5f}, 2);
    person.placing.request();
    person.frame();
    REQUIRE(person.places == 2);
    person.rest(WorkshopPlacing::kRest + 1);
    person.move({0.9f, 1.7f, 0.8f}, 0.3f);
    CHECK(person.places == 2); // not while it moves
    person.frames(2);
    CHECK(person.places == 3);
    CHECK(person.away() < 0.03f);
}

TEST_CASE("a headset that is lifted and put on in its place leaves the work where it is", "[app]") {
    Placed person;
    person.rest(WorkshopPlacing::kRest + 1);
    person.move({0.1f, 1.58f, 0.05f}, 0.2f);
    person.frames(3);
    CHECK(person.places == 1);
}

TEST_CASE("a head that rests while the hands work was not put on when it moves", "[app]") {
    Placed person;
    person.handsAct = true;
    person.rest(2 * WorkshopPlacing::kRest);
    person.move({0.1f, 1.3f, -0.1f}, 0); // leans down
    person.frames(3);
    CHECK(person.places == 1);
}

TEST_CASE("where the runtime tells that the headset is worn, its word counts and no rest does", "[app]") {
    Placed person;
    person.frame(false);
    person.rest(WorkshopPlacing::kRest + 1);
    person.move({1, 1.2f, 0}, 0);
    person.frames(3);
    CHECK(person.places == 1);
    person.frame(true);
    person.frames(2);
    CHECK(person.places == 2);
}

TEST_CASE("another person's height at the same place places the workshop again", "[app]") {
    Placed person;
    person.frame(false);
    person.move({0, 1.45f, 0}, 0);
    person.frame(true);
    person.frames(2);
    CHECK(person.places == 2);
}

TEST_CASE("the workshop follows a person who has gone far away, and the system's own recentre", "[app]") {
    Placed person;
    person.move({1.2f, 1.6f, -0.3f}, 1);
    person.frames(3);
    CHECK(person.places == 1); // round the table
    person.move({2.8f, 1.6f, 0}, 1);
    person.frames(2);
    CHECK(person.places == 2);
    person.frame({}, true);
    CHECK(person.places == 3);
}

TEST_CASE("the button acts after a second of hold, once, and never while the arc burns", "[app]") {
    Placed person;
    person.held = true;
    person.frames(0.8);
    CHECK(person.places == 1);
    CHECK(person.placing.held() > 0.7);
    person.held = false;
    person.frames(0.1);
    CHECK(person.placing.held() == 0);
    person.held = true;
    person.frames(3);
    CHECK(person.places == 2);
    person.held = false;
    person.frames(0.1);
    person.burning = true;
    person.held = true;
    person.frames(1.2);
    person.held = false;
    person.frames(0.5);
    CHECK(person.places == 2);
    person.burning = false;
    person.frame();
    CHECK(person.places == 3);
}
