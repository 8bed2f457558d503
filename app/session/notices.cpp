#include "app/session/notices.hpp"

#include <cmath>
#include <cstdio>
#include <utility>

namespace meltpool {

namespace {

/// In the order of NoArc; empty: nothing to tell.
constexpr std::array<std::string_view, 12> kSentences{
    "",
    "",
    "The arc became too long: it is out. Let the trigger go, then strike nearer.",
    "The electrode has touched the metal and is spoiled: the arc is out. Let the trigger go, then strike again.",
    "No metal lies before the torch any more: the arc is out. Let the trigger go, then strike over the metal.",
    "There is no arc: no metal lies before the torch.",
    "There is no arc: the electrode is too far from the metal. Strike nearer.",
    "There is no arc: the electrode touches the metal. Lift it, then strike.",
    "",
    "There is no arc: no wire is fed. Set the wire feed above 0.",
    "The electrode sticks to the metal. Twist it free, then strike again.",
    "The electrode has burned down to its stub. Let the trigger go to take a new one.",
};
static_assert(kSentences.size() == static_cast<size_t>(NoArc::usedUp) + 1);

/// A covered electrode strikes by touch; while it touches, nothing is wrong yet.
std::string_view touchSentence(NoArc reason) {
    if (reason == NoArc::tooLong)
        return "The arc became too long: it is out. Touch the metal and lift, to strike again.";
    if (reason == NoArc::metalLeft) return "No metal lies before the electrode any more: the arc is out.";
    if (reason == NoArc::tooFar) return "There is no arc: touch the metal with the electrode and lift it a little.";
    if (reason == NoArc::touching) return {};
    return kSentences[static_cast<size_t>(reason)];
}

/// A wire strikes again by itself when it reaches the metal.
std::string_view sentenceOf(NoArc reason, Striking striking) {
    const bool wire = striking == Striking::wire;
    if (striking == Striking::touch) return touchSentence(reason);
    if (wire && reason == NoArc::tooLong) return "The arc became too long: it is out. Bring the torch nearer.";
    if (wire && reason == NoArc::metalLeft) return "No metal lies before the torch any more: the arc is out.";
    return kSentences[static_cast<size_t>(reason)];
}

} // namespace

std::string_view ArcNotice::update(const ArcState& arc, Striking striking, double elapsed) {
    const bool stubs = striking == Striking::wire && arc.action == ArcAction::stubbed;
    const std::string_view sentence =
        stubs ? "The wire stubs: it comes faster than the arc melts it." : sentenceOf(arc.noArc, striking);
    waiting_ = sentence.empty() ? 0 : waiting_ + elapsed;
    return waiting_ > kPatience || wentOut(arc.noArc) ? sentence : std::string_view();
}

std::string_view SlowNotice::update(double speed, double elapsed) {
    slowFor_ = speed < kSlow ? slowFor_ + elapsed : 0;
    told_ = told_ ? speed <= kKeepsUp : slowFor_ >= kPatience;
    if (!told_) return {};
    const double percent = speed * 100;
    // In steps of 5 %, so that the number can be read.
    const double shown = percent < 10 ? std::fmax(1.0, std::round(percent)) : 5 * std::round(percent / 5);
    const int length = std::snprintf(text_.data(), text_.size(), "metal runs at %.0f %% of real time", shown);
    return {text_.data(), static_cast<size_t>(length)};
}

void tellRecordings(RecordingKeeper& recordings, double now, Messages& messages) {
    recordings.update();
    if (recordings.fault().empty())
        messages.clear("recording");
    else
        messages.hold(recordings.fault(), "recording");
    if (std::string notice = recordings.takeNotice(); !notice.empty())
        messages.warn(std::move(notice), now, "recordings");
}

void Notices::tellSlow(std::string_view slow, Messages& messages) {
    if (slow.empty()) return messages.clear(kSlowTopic);
    const int length = std::snprintf(slowSentence_.data(), slowSentence_.size(),
                                     "The %.*s: this weld is not the one that your hand makes.",
                                     static_cast<int>(slow.size()), slow.data());
    messages.hold({slowSentence_.data(), static_cast<size_t>(length)}, kSlowTopic);
}

void Notices::update(LessonSession& session, LessonFigures& figures, const TriggerLock& lock, double elapsed,
                     Messages& messages) {
    figures.slow = {};
    std::string_view sentence;
    if (session.activity().allowed().ownTorch) {
        if (!session.paused()) figures.slow = slow_.update(figures.speed, elapsed); // else the metal stands
        sentence = arc_.update(session.run().arc(), traitsOf(session.lesson().process).striking, elapsed);
        if (session.attempt().cues().withheld(CueKind::arc)) sentence = {};
        if (lock.holdsBack()) sentence = arcOutSentence(lock.reason());
    }
    tellSlow(figures.slow, messages);
    const bool eye = session.running() && session.lesson().look.adaptation;
    if (eye && !session.picture().visor().sentence().empty())
        messages.hold(session.picture().visor().sentence(), "visor");
    else
        messages.clear("visor");
    if (session.attempt().ghost().fault().empty())
        messages.clear("ghost");
    else
        messages.hold(session.attempt().ghost().fault(), "ghost");
    if (sentence.empty())
        messages.clear("arc");
    else
        messages.hold(sentence, "arc");
}

} // namespace meltpool
