// Sound and notice are at the end to which a covered electrode has burned, not at the end of a new one.
#include "app/headset/headset_notice.hpp"
#include "app/headset/tracked_torch.hpp"
#include "app/session/lesson_session.hpp"
#include "tests/app/small_lessons.hpp"
#include "tests/support/catch.hpp"

#include <glm/geometric.hpp>

using namespace meltpool;

TEST_CASE("the arc of a burning electrode sounds at its end, on which the hand comes down", "[app]") {
    Lesson lesson = findLesson("smaw-bead", test::shippedLessons());
    lesson.workpiece.lengthMm = 30;
    lesson.workpiece.widthMm = 20;
    lesson.surface.cells = 28;
    LessonSession session(test::shaders(), lesson, [] { return 0.0; });
    Controls controls;
    session.begin(controls);
    CHECK(session.run().burntOff() == 0);
    float x = -5e-3f;
    const auto lead = [&](double seconds, float height) {
        constexpr double kStride = 1.0 / 45;
        for (double time = 0; time < seconds; time += kStride)
            session.advance(controls, kStride, nullptr, [&](int, int steps) {
                x += 3e-3f * static_cast<float>(kStride / steps);
                TorchSample torch;
                torch.tip = {x, height - session.run().burntOff(), 0};
                torch.orientation = glm::angleAxis(-1.5707963f, glm::vec3(1, 0, 0));
                torch.trigger = 1;
                return torch;
            });
    };
    lead(0.1, -0.2e-3f); // strikes by touch
    lead(1.5, 2.5e-3f);
    REQUIRE(session.run().arc().burns());
    const float burnt = session.run().burntOff();
    CHECK(burnt > 2e-3f);
    const glm::vec3 end = session.run().torchEnd(), tip = session.run().torch().tip;
    CHECK(glm::distance(end, tip) == Approx(burnt).epsilon(1e-3));
    CHECK(end.y == Approx(2.5e-3).margin(0.5e-3));
    const auto heard = session.picture().arcFrom(glm::mat4(1));
    REQUIRE(heard);
    CHECK(glm::distance(*heard, end) < 1e-5f); // a flat plate: the workpiece's frame is the world's
}

TEST_CASE("the notice hangs above the end of the electrode, wherever the hand is", "[app]") {
    TrackedTorch torch;
    xr::HandInput hand;
    hand.present = hand.tracked = true;
    hand.grip = {glm::angleAxis(-1.5707963f, glm::vec3(1, 0, 0)), {0, 0.8f, 0}}; // the torch points down
    torch.update(hand, {}, Workshop(), 0.01);
    const glm::vec3 end = torch.end(0.15f);
    CHECK(glm::distance(end, glm::vec3(0, 0.95f, 0)) < 1e-5f);
    CHECK(torch.end(0) == torch.tip().position);
    const xr::Pose head{glm::angleAxis(-0.7f, glm::vec3(1, 0, 0)), {0, 1.4f, 0.45f}};
    NoticePlace place;
    place.update(true, head, end, 0.9f, 0.01);
    CHECK(glm::distance(place.pose().position, end) < 0.2f);
    CHECK(place.pose().position.y > end.y);
}
