// Messages during the weld: the reason of a missing arc, slow metal, and their display in the headset.
#include "app/headset/headset_notice.hpp"
#include "app/headset/panel_pointer.hpp"
#include "app/session/notices.hpp"
#include "core/training/feedback/cue_shapes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <array>

using namespace meltpool;

namespace {

constexpr double kFrame = 0.1;

ArcState arcOf(ArcAction action, NoArc noArc = NoArc::burns) {
    ArcState arc;
    arc.action = action;
    arc.noArc = noArc;
    arc.distance = 0.0002F; // this state does not explain a missing arc
    return arc;
}

} // namespace

TEST_CASE("why there is no arc is told as the process says it, until it burns or the trigger is let go", "[app]") {
    ArcNotice notice;
    Striking striking = Striking::spark;
    const auto told = [&](ArcState arc, int frames = 1) {
        std::string sentence;
        for (int i = 0; i < frames; ++i)
            sentence = notice.update(arc, striking, kFrame);
        return sentence;
    };
    const auto out = [](NoArc reason) { return arcOf(ArcAction::out, reason); };
    const auto contains = [](const char* text) { return test::containsText(text); };
    CHECK(told(out(NoArc::tooFar)).empty()); // the arc may still strike
    CHECK(told(arcOf(ArcAction::burning)).empty());
    CHECK_THAT(told(out(NoArc::tooLong)), contains("too long"));
    CHECK_THAT(told(out(NoArc::tooLong), 20), contains("too long"));
    CHECK(told(out(NoArc::released)).empty());
    CHECK_THAT(told(out(NoArc::touched)), contains("spoiled"));
    CHECK(told(out(NoArc::released)).empty());
    CHECK_THAT(told(out(NoArc::metalLeft)), contains("left the metal"));
    CHECK(told(out(NoArc::released)).empty());
    CHECK(told(out(NoArc::tooFar), 5).empty());
    CHECK_THAT(told(out(NoArc::tooFar)), contains("too far"));
    CHECK_THAT(told(out(NoArc::touching), 6), contains("Lift it"));
    CHECK_THAT(told(out(NoArc::noMetal), 6), contains("no metal"));
    CHECK_THAT(told(out(NoArc::noWire), 6), contains("wire feed"));
    striking = Striking::wire;
    CHECK(told(out(NoArc::feeding), 20).empty());
    CHECK(told(arcOf(ArcAction::shorting), 20).empty());
    CHECK(told(arcOf(ArcAction::stubbed), 5).empty());
    CHECK_THAT(told(arcOf(ArcAction::stubbed)), contains("stubs"));
    CHECK(told(arcOf(ArcAction::burning)).empty());
    CHECK_THAT(told(out(NoArc::tooLong)), contains("Bring the torch nearer"));
    striking = Striking::touch;
    CHECK(told(out(NoArc::released)).empty());
    CHECK_THAT(told(out(NoArc::tooFar), 6), contains("touch the metal"));
    CHECK(told(out(NoArc::touching), 20).empty());
    CHECK_THAT(told(out(NoArc::stuck)), contains("Twist it by 12 degrees"));
    CHECK_THAT(told(out(NoArc::tooLong)), contains("Touch the metal and lift"));
    CHECK_THAT(told(out(NoArc::usedUp)), contains("new one"));
}

TEST_CASE("slow metal is told after half a second and until it keeps up", "[app]") {
    SlowNotice notice;
    CHECK(notice.update(0.96, false, 10).empty());
    for (int i = 0; i < 4; ++i)
        CHECK(notice.update(0.45, false, kFrame).empty());
    notice.update(0.45, false, kFrame);
    CHECK(notice.update(0.45, false, kFrame) == "computer too slow: 45 %");
    CHECK(notice.update(0.063, true, kFrame) == "computer too slow: 6 %");
    CHECK(notice.update(0.96, true, kFrame) == "computer too slow: 95 %");
    CHECK(notice.update(0.98, true, kFrame).empty());
    CHECK(notice.update(0.96, true, kFrame).empty());
}

TEST_CASE("the sentence about slow metal is shown once an attempt, and not while the metal only cools", "[app]") {
    SlowNotice notice;
    notice.update(0.4, true, 1);
    CHECK_THAT(std::string(notice.sentence()), test::containsText("too slow (40 %)"));
    CHECK(notice.update(0.4, false, 1).empty()); // the arc is out: the metal cools
    CHECK(notice.sentence().empty());
    CHECK_FALSE(notice.update(0.4, true, SlowNotice::kSentence).empty());
    CHECK_FALSE(notice.sentence().empty());
    CHECK_FALSE(notice.update(0.4, true, 1).empty()); // the figure remains
    CHECK(notice.sentence().empty());
    notice.reset();
    notice.update(0.4, true, 1);
    CHECK_FALSE(notice.sentence().empty());
}

TEST_CASE("the headset's notice has the window's warnings, the newest last, and the zoom below them", "[app]") {
    Messages messages;
    LessonFigures figures;
    NoticeText notice;
    notice.compose(messages, figures, 1.0f);
    CHECK(notice.text().empty());
    messages.note("Picture saved as a.png", 0);
    messages.warn("one", 0);
    messages.hold("two", "headset");
    messages.hold("three", "arc");
    messages.hold("four", "record");
    figures.slow = "computer too slow: 45 %";
    notice.compose(messages, figures, 4.0f);
    CHECK(notice.warnings() == "two\nthree\nfour\n");
    CHECK_THAT(std::string(notice.quiet()), test::containsText("computer too slow: 45 %\n"));
    messages.hold("This computer is too slow (45 %).", kSlowTopic);
    notice.compose(messages, figures, 4.0f);
    CHECK(notice.warnings() == "three\nfour\nThis computer is too slow (45 %).\n");
    CHECK_THAT(std::string(notice.quiet()), !test::containsText("too slow"));
    messages.clear(kSlowTopic);
    notice.compose(messages, figures, 4.0f);
    CHECK_THAT(std::string(notice.quiet()), test::containsText("Zoom 4"));
    messages.clear("arc");
    messages.clear("headset");
    figures.slow = {};
    notice.compose(messages, figures, 1.0f);
    CHECK(notice.text() == "one\nfour\n");
    messages.hold(std::string(5000, 'x'), "arc");
    notice.compose(messages, figures, 4.0f);
    CHECK(notice.text().size() < 600);
    CHECK_THAT(std::string(notice.quiet()), test::containsText("Zoom 4"));
}

TEST_CASE("eyes that look away are led to the work, below, above or ahead") {
    const auto told = [](float pitch, const glm::vec3& work) {
        const xr::Pose head{glm::angleAxis(pitch, glm::vec3(1, 0, 0)), {0, 1.6f, 0.36f}};
        return std::string(wayToWork(head, work));
    };
    CHECK_THAT(told(0, {0, 1.2f, 0}), test::containsText("Look down"));
    CHECK(told(-0.5f, {0, 1.2f, 0}).empty()); // 20 degrees over it
    CHECK_THAT(told(0, {0, 1.9f, 0}), test::containsText("Look up"));
    CHECK(told(0, {0, 1.55f, 0}).empty());
    CHECK_THAT(told(0, {0.6f, 1.6f, 0.3f}), test::containsText("Turn to the work"));
}

TEST_CASE("a head over the weld does not face the panel behind it; one that is raised does") {
    const auto head = [](float pitch) {
        return xr::Pose{glm::angleAxis(pitch, glm::vec3(1, 0, 0)), {0, 1.4f, Workshop::kReach}};
    };
    const glm::vec3 panel(0, 1.4f, -PanelPointer::kBehind);
    CHECK_FALSE(faces(head(-0.8f), panel));
    CHECK(faces(head(-0.3f), panel));
}

TEST_CASE("the notice hangs above the torch where the person looks there, else before their eyes", "[app]") {
    NoticePlace place;
    const xr::Pose head{glm::angleAxis(-0.7f, glm::vec3(1, 0, 0)), {0, 1.4f, 0.45f}};
    const glm::vec3 tip(0, 0.95f, 0);
    place.update(true, head, tip, 0.9f, 0.01);
    const auto angle = [&](const glm::vec3& point) {
        return glm::degrees(std::acos(glm::dot(glm::normalize(point - head.position), head.forward())));
    };
    CHECK(glm::distance(place.pose().position, tip) < 0.2f);
    // Its lower edge leaves the cues' board free, which is at the tip's height or above.
    const xr::PanelShape& shape = HeadsetNotice::kShape;
    const float half =
        place.width() * static_cast<float>(shape.heightPixels) / static_cast<float>(shape.widthPixels) / 2;
    const glm::vec3 edge = place.pose().position - place.pose().orientation * glm::vec3(0, half, 0);
    CHECK(glm::distance(edge, tip) > kCueBoardHeight * glm::distance(head.position, tip));
    CHECK(glm::distance(edge, tip) < 0.1f);
    CHECK(place.pose().position.y > tip.y);
    CHECK(angle(place.pose().position) < 20);
    // The panel faces the eyes.
    const glm::vec3 normal = place.pose().orientation * glm::vec3(0, 0, 1);
    CHECK(glm::dot(normal, glm::normalize(head.position - tip)) > 0.99f);
    for (int i = 0; i < 200; ++i)
        place.update(true, head, std::nullopt, 0.9f, 0.01);
    CHECK(angle(place.pose().position) < 15);
    CHECK(glm::distance(place.pose().position, head.position) == Approx(0.6).margin(0.1));
    place.update(false, head, tip, 0.9f, 0.01); // only the zoom is left, on the table in front of the workpiece
    CHECK(place.pose().position.y < 1.0f);
    CHECK(place.pose().position.z > 0.1f);
}

TEST_CASE("the notice keeps its angle however near the head comes, and its capitals are a degree high", "[app]") {
    const glm::vec3 tip(0, 0.95f, 0);
    for (const float distance : {0.15f, 0.45f, 0.8f}) {
        const glm::vec3 back = glm::normalize(glm::vec3(0, 1, 1));
        const xr::Pose head{glm::angleAxis(-0.785f, glm::vec3(1, 0, 0)), tip + back * distance};
        NoticePlace fresh;
        fresh.update(true, head, tip, 0.9f, 0.01);
        const float angle =
            glm::degrees(2 * std::atan(fresh.width() / 2 / glm::distance(head.position, fresh.pose().position)));
        CHECK(angle < 31);
        CHECK(angle > 25);
    }
    constexpr float kFontPoints = 18, kCapitals = 0.71f; // of a line's height, in Open Sans
    const float share = HeadsetNotice::kTextScale * kFontPoints * kCapitals / float(HeadsetNotice::kShape.widthPixels);
    CHECK(glm::degrees(2 * std::atan(share * std::tan(NoticePlace::kAngle / 2))) >= 1.0f);
}

TEST_CASE("the notice hangs below the panel that the person looks at, and tells the task while nothing warns",
          "[app]") {
    NoticePlace place;
    const xr::Pose head{{1, 0, 0, 0}, {0, 1.6f, 0.45f}}, panel{{1, 0, 0, 0}, {0, 1.48f, -0.35f}};
    place.update(true, head, std::nullopt, 0.9f, 0.01, panel);
    CHECK(place.pose().position.y < 1.48f - 0.37f);
    Messages messages;
    LessonFigures figures;
    NoticeText notice;
    notice.compose(messages, figures, 1.0f, "Set 20 V. " + std::string(300, 'x'));
    CHECK(notice.quiet() == "Set 20 V.\n");
    messages.warn("one", 0);
    notice.compose(messages, figures, 1.0f, "Set 20 V.");
    CHECK(notice.text() == "one\n");
    const std::array<std::string_view, 2> way{"Look down.", "Green is the visor."};
    notice.compose(messages, figures, 1.0f, {}, way);
    CHECK(notice.warnings() == "one\n");
    CHECK(notice.quiet() == "Look down.\nGreen is the visor.\n");
}

TEST_CASE("below the panel aside the whole notice is in the view of a person who looks ahead", "[app]") {
    HeadsetParameters parameters;
    PanelPointer panel(parameters);
    const xr::Pose head{{1, 0, 0, 0}, {0, parameters.tableHeight + Workshop::kDrop, Workshop::kReach}};
    for (const xr::Hand hand : {xr::Hand::right, xr::Hand::left}) {
        panel.move(true, head.position, hand, 10); // closed, so at once
        NoticePlace place;
        place.update(true, head, std::nullopt, parameters.tableHeight, 0.01, panel.pose());
        const xr::Pose inPanel = panel.pose().inverse() * place.pose();
        CHECK(inPanel.position.y < -0.37f); // below the panel
        for (const float side : {-0.5f, 0.5f}) {
            const glm::vec3 edge = place.pose() * glm::vec3(side * place.width(), 0, 0) - head.position;
            const float angle = glm::degrees(std::atan2(edge.x, -edge.z));
            INFO((hand == xr::Hand::right ? "right" : "left") << ", edge at " << angle << " degrees");
            CHECK(std::abs(angle) < 40);
        }
    }
}

TEST_CASE("the hand whose torch is at the metal does not point at the panel behind it; the other one may", "[app]") {
    HeadsetParameters parameters;
    PanelPointer panel(parameters);
    panel.show();
    panel.move(false, glm::vec3(0, parameters.tableHeight + Workshop::kDrop, Workshop::kReach), xr::Hand::right, 10);
    const Workshop workshop;
    std::array<xr::HandInput, 2> hands;
    const auto aimAtPanel = [&](xr::Hand hand) {
        xr::HandInput& pointing = hands[hand == xr::Hand::left ? 0 : 1];
        pointing.tracked = true;
        pointing.aim = workshop.toSession(panel.pose() * xr::Pose{{1, 0, 0, 0}, {0, 0, 0.4f}});
    };
    const auto pointing = [&](bool torchWorks) {
        panel.update(hands, workshop, {}, xr::Hand::right, torchWorks);
        return panel.pointingHand();
    };
    aimAtPanel(xr::Hand::right);
    CHECK(pointing(false) == xr::Hand::right);
    CHECK_FALSE(pointing(true));
    aimAtPanel(xr::Hand::left);
    hands[0].trigger = 1;
    CHECK(pointing(true) == xr::Hand::left);
    CHECK(panel.pointer().pressed);
    // A hand that closes the panel and opens it again by its button wants to point.
    hands[0] = {};
    for (int press = 0; press < 2; ++press) {
        hands[1].menu = true;
        pointing(true);
    }
    hands[1].menu = false;
    CHECK(pointing(true) == xr::Hand::right);
}

TEST_CASE("the panel in front has letters of a degree from the welder's place", "[app]") {
    constexpr float kFontPoints = 18, kCapitals = 0.71f;
    const xr::PanelShape shape;
    const float capital = HeadsetPanel::kScale * kFontPoints * kCapitals * shape.width / float(shape.widthPixels);
    CHECK(glm::degrees(std::atan(capital / (Workshop::kReach + PanelPointer::kBehind))) >= 1.0f);
}
