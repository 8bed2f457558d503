// What goes on at the tip, from known places of the metal.
#include "core/weld/process/tip_state.hpp"
#include "tests/support/catch.hpp"

using namespace meltpool;

namespace {

TipSounding metalAt(float mm, float liquid = 0) {
    TipSounding sounding;
    sounding.ahead = sounding.nearest = mm * 1e-3f;
    sounding.liquid = liquid;
    return sounding;
}

TipGap gapOf(ProcessKind kind) {
    ProcessParameters p;
    p.kind = static_cast<int>(kind);
    p.arcLengthMm = 3;
    p.wireDiameterMm = 1.2f;
    return tipGap(p);
}

TipAction actionAt(ProcessKind kind, float mm) {
    return tipState(gapOf(kind), 1, metalAt(mm)).action;
}

constexpr float kFrame = 1.0f / 90;

} // namespace

TEST_CASE("a GMAW arc stubs, shorts, burns, breaks and is out as its wire leaves the metal") {
    CHECK(actionAt(ProcessKind::Gmaw, -1) == TipAction::stubbed);
    CHECK(actionAt(ProcessKind::Gmaw, 0.5f) == TipAction::stubbed); // within the wire's own radius
    CHECK(actionAt(ProcessKind::Gmaw, 0.9f) == TipAction::shorting);
    CHECK(actionAt(ProcessKind::Gmaw, 1.2f) == TipAction::burning);
    CHECK(actionAt(ProcessKind::Gmaw, 3) == TipAction::burning);
    CHECK(actionAt(ProcessKind::Gmaw, 7.4f) == TipAction::burning);
    CHECK(actionAt(ProcessKind::Gmaw, 7.6f) == TipAction::breaking);
    CHECK(actionAt(ProcessKind::Gmaw, 16) == TipAction::idle);
    CHECK(tipState(gapOf(ProcessKind::Gmaw), 1, TipSounding{}).action == TipAction::idle); // no metal anywhere
    CHECK(tipState(gapOf(ProcessKind::Gmaw), 1, metalAt(3)).stretch == 0);
    CHECK(tipState(gapOf(ProcessKind::Gmaw), 1, metalAt(5.25f)).stretch == Approx(0.5));
}

TEST_CASE("a TIG electrode has no drops, and its arc is out where it dips in") {
    CHECK(actionAt(ProcessKind::Tig, 0.5f) == TipAction::idle);
    CHECK(actionAt(ProcessKind::Tig, 1.3f) == TipAction::burning);
    CHECK(actionAt(ProcessKind::Tig, 9) == TipAction::breaking);
}

TEST_CASE("a flame gives the more the nearer, an iron only where it touches") {
    const TipGap flame = gapOf(ProcessKind::Flame), iron = gapOf(ProcessKind::Iron);
    CHECK(tipState(flame, 1, metalAt(-2)).power == 1);
    CHECK(tipState(flame, 1, metalAt(15)).power == Approx(0.5));
    CHECK(tipState(flame, 1, metalAt(31)).action == TipAction::idle);
    CHECK(tipState(iron, 1, metalAt(2.1f)).action == TipAction::idle);
    CHECK(tipState(iron, 1, metalAt(1)).power == Approx(0.5));
}

TEST_CASE("without the trigger nothing goes on, and no more than all is pulled") {
    for (const ProcessKind kind : {ProcessKind::Flame, ProcessKind::Tig, ProcessKind::Gmaw, ProcessKind::Iron})
        CHECK(tipState(gapOf(kind), 0, metalAt(1.5f)).action == TipAction::idle);
    CHECK(tipState(gapOf(ProcessKind::Tig), 0.4f, metalAt(3)).power == 0.4f);
    CHECK(tipState(gapOf(ProcessKind::Tig), 7, metalAt(3)).power == 1);
    CHECK(tipState(gapOf(ProcessKind::Tig), 1, metalAt(3, 0.7f)).liquid == 0.7f);
}

TEST_CASE("a touch is noticed once, with the speed at which the hand came, and again after leaving") {
    const TipGap gap = gapOf(ProcessKind::Tig);
    TipTouch touch;
    const glm::vec3 down(0, -0.2f, 0);
    touch.update(gap, metalAt(10), down, kFrame);
    CHECK_FALSE(touch.touching());
    // The answer comes when the hand has stopped.
    touch.update(gap, metalAt(1.0f), glm::vec3(0), kFrame);
    CHECK(touch.touching());
    CHECK(touch.since() == 0);
    CHECK(touch.speed() > 0.1f);
    CHECK(touch.speed() <= 0.2f);
    for (const float mm : {0.5f, 1.1f, 1.3f, 1.6f, 0.9f}) // trembling at the surface is no new touch
        touch.update(gap, metalAt(mm), down, kFrame);
    CHECK(touch.count() == 1);
    CHECK(touch.since() == Approx(5.0 / 90));
    touch.update(gap, metalAt(2), -down, kFrame);
    CHECK_FALSE(touch.touching());
    touch.update(gap, metalAt(1), glm::vec3(0.3f, 0, 0), kFrame);
    CHECK(touch.count() == 2);
}

TEST_CASE("a hand that comes back inside the metal has touched nothing") {
    const TipGap gap = gapOf(ProcessKind::Tig);
    TipTouch touch;
    touch.update(gap, metalAt(-3), glm::vec3(0), kFrame);
    CHECK(touch.touching());
    CHECK(touch.count() == 0);
    touch.update(gap, metalAt(9), glm::vec3(0), kFrame);
    touch.update(gap, metalAt(0), glm::vec3(0), kFrame);
    CHECK(touch.count() == 1);
    touch.forget();
    touch.update(gap, metalAt(-3), glm::vec3(0), kFrame);
    CHECK(touch.count() == 1);
}
