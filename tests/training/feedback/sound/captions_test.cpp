// Captions of the sound.
#include "core/training/feedback/sound/sound_steps.hpp"
#include "tests/support/catch.hpp"
#include "tests/training/feedback/sound/sound_steps.hpp"

using namespace meltpool;
using namespace meltpool::test;

namespace {

/// Returns the caption after `seconds` of equal steps.
std::string after(Captions& captions, const SoundStep& step, double seconds) {
    for (double time = 0; time < seconds; time += step.seconds)
        captions.step(step);
    return std::string(captions.text());
}

} // namespace

TEST_CASE("captions name what is heard", "[sound]") {
    Captions captions;
    CHECK(after(captions, noArc(Gmaw::kTraits), 1).empty());
    CHECK(after(captions, noArc(Gmaw::kTraits, 1), 1) == "Gas flows");
    SoundStep spray = openArc(Gmaw::kTraits);
    spray.dropRate = 250;
    CHECK(after(captions, spray, 1) == "Drops hum");
    spray.dropRate = 20;
    CHECK(after(captions, spray, 1) == "Large drops fall");
    CHECK(after(captions, openArc(Gmaw::kTraits, 0.9F), 1) == "A long arc hisses");
    CHECK(after(captions, noArc(Gmaw::kTraits), 0.4) == "Gas flows"); // after the arc
    CHECK(after(captions, noArc(Gmaw::kTraits), 2).empty());
    CHECK(after(captions, openArc(Smaw::kTraits), 1) == "The electrode crackles");
    CHECK(after(captions, openArc(Gtaw::kTraits), 1) == "The arc hisses softly");
    CHECK(after(captions, noArc(Flame::kTraits, 1), 1) == "The flame roars");
}

TEST_CASE("captions tell even short circuits from uneven ones", "[sound]") {
    Captions captions;
    ShortCircuits shorts;
    for (int i = 0; i < 45; ++i)
        captions.step(shorting(shorts));
    CHECK(captions.text() == "Short circuits, even");
    for (int i = 0; i < 180; ++i)
        captions.step(i % 40 < 20 ? shorting(shorts, 120) : openArc(Gmaw::kTraits));
    CHECK(captions.text() == "Short circuits, uneven");
    // A short arc that drops bridge again and again.
    for (int i = 0; i < 180; ++i) {
        SoundStep step = shorting(shorts, 100);
        step.arc.action = i % 3 == 0 ? ArcAction::shorting : ArcAction::burning;
        captions.step(step);
    }
    CHECK(captions.text() == "Short circuits, even");
    SoundStep stubs = openArc(Gmaw::kTraits);
    stubs.arc.action = ArcAction::stubbed;
    CHECK(after(captions, stubs, 0.5) == "The wire stubs");
}

TEST_CASE("a caption does not flicker", "[sound]") {
    Captions captions;
    after(captions, openArc(Smaw::kTraits), 1);
    int changes = 0;
    std::string last(captions.text());
    for (int i = 0; i < 900; ++i) { // an arc with repeated short interruptions
        captions.step(i % 20 < 3 ? noArc(Smaw::kTraits, 1) : openArc(Smaw::kTraits));
        changes += captions.text() != last ? 1 : 0;
        last = captions.text();
    }
    CHECK(changes == 0);
}

TEST_CASE("an ear hands steps on in order, drops what nobody takes, and chips with the next step", "[sound]") {
    SoundSteps ear;
    for (size_t i = 0; i < SoundFeed::kRoom + 10; ++i) {
        SoundStep step = noArc(Smaw::kTraits);
        step.hottest = static_cast<float>(i);
        ear.hear(step);
    }
    CHECK(ear.feed().waiting() == SoundFeed::kRoom);
    SoundStep taken;
    for (size_t i = 0; i < SoundFeed::kRoom; ++i) {
        REQUIRE(ear.feed().pop(taken));
        CHECK(taken.hottest == static_cast<float>(i));
        CHECK(taken.chips == 0);
    }
    CHECK_FALSE(ear.feed().pop(taken));
    ear.chip(3);
    ear.hear(noArc(Smaw::kTraits));
    ear.hear(noArc(Smaw::kTraits));
    REQUIRE(ear.feed().pop(taken));
    CHECK(taken.chips == 3);
    REQUIRE(ear.feed().pop(taken));
    CHECK(taken.chips == 0);
}
