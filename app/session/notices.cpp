#include "app/session/notices.hpp"

#include "core/base/words.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace meltpool {

namespace {

/// Keys in the order of NoArc; empty: no notice. Each key is written whole: composing one would allocate.
constexpr std::array<std::string_view, 12> kKeys{
    "",
    "",
    "notice.arc.too_long",
    "notice.arc.touched",
    "notice.arc.metal_left",
    "notice.arc.no_metal",
    "notice.arc.too_far",
    "notice.arc.touching",
    "",
    "notice.arc.no_wire",
    "notice.arc.stuck",
    "notice.arc.used_up",
};
static_assert(kKeys.size() == static_cast<size_t>(NoArc::usedUp) + 1);

/// Key for a covered electrode, which strikes by touch; its touching is no fault yet.
std::string_view touchKey(NoArc reason) {
    if (reason == NoArc::tooLong) return "notice.arc_by_touch.too_long";
    if (reason == NoArc::metalLeft) return "notice.arc_by_touch.metal_left";
    if (reason == NoArc::noMetal) return "notice.arc_by_touch.no_metal";
    if (reason == NoArc::tooFar) return "notice.arc_by_touch.too_far";
    if (reason == NoArc::touching) return {};
    return kKeys[static_cast<size_t>(reason)];
}

/// Key for a wire, which strikes again by itself when it reaches the metal.
std::string_view wireKey(NoArc reason) {
    if (reason == NoArc::tooLong) return "notice.arc_by_wire.too_long";
    if (reason == NoArc::metalLeft) return "notice.arc_by_wire.metal_left";
    return kKeys[static_cast<size_t>(reason)];
}

std::string_view sentenceOf(const ArcState& arc, Striking striking) {
    const bool wire = striking == Striking::wire;
    std::string_view key = kKeys[static_cast<size_t>(arc.noArc)];
    if (striking == Striking::touch) key = touchKey(arc.noArc);
    if (wire) key = arc.action == ArcAction::stubbed ? "notice.arc_by_wire.stubs" : wireKey(arc.noArc);
    return key.empty() ? key : phrase(key);
}

/// Key of the sentence about slow metal that fits the torch's leader.
std::string_view slowKey(LessonSession& session) {
    if (session.leader() == TorchLeader::hand) return "notice.slow.hand";
    const bool mouse = session.leader() == TorchLeader::desk && session.deskTorch().leads();
    return mouse ? "notice.slow.mouse" : "notice.slow.sentence";
}

} // namespace

std::string_view ArcNotice::update(const ArcState& arc, Striking striking, double elapsed) {
    const std::string_view sentence = sentenceOf(arc, striking);
    waiting_ = sentence.empty() ? 0 : waiting_ + elapsed;
    return waiting_ > kPatience || wentOut(arc.noArc) ? sentence : std::string_view();
}

std::string_view SlowNotice::update(double speed, bool burns, double elapsed, std::string_view key) {
    slowFor_ = speed < kSlow ? slowFor_ + elapsed : 0;
    told_ = told_ ? speed <= kKeepsUp : slowFor_ >= kPatience;
    burned_ = burned_ || burns;
    sentence_.clear();
    if (!told_ || (burned_ && !burns)) return {};
    const double percent = speed * 100;
    // Rounded to 5 %, so that the number stays readable.
    const double shown = percent < 10 ? std::fmax(1.0, std::round(percent)) : 5 * std::round(percent / 5);
    const PhraseNumber number(shown);
    text_.clear();
    appendPhrase(text_, "notice.slow.figure", {{"percent", number}});
    if (sentenceFor_ < kSentence) appendPhrase(sentence_, key, {{"percent", number}});
    sentenceFor_ += elapsed;
    return text_;
}

std::string_view HiddenCuesNotice::update(const AttemptCues& cues) {
    const CueSet hidden = cues.faded();
    if (hidden.empty() || cues.showsFaded() || !cues.used().empty()) return {};
    if (hidden == told_) return sentence_;
    std::string names;
    for (const CueKind kind : kCueKinds)
        if (hidden.has(kind)) names += (names.empty() ? "" : ", ") + phraseOf("notice.cues", cueName(kind));
    sentence_ = phrase("notice.cues.hidden", {{"cues", names}});
    told_ = hidden;
    return sentence_;
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

void Notices::update(LessonSession& session, LessonFigures& figures, const TriggerLock& lock, double elapsed,
                     Messages& messages) {
    constexpr double kBegin = 1; // s: going back by a redo ends later in most attempts
    if (figures.time < time_ && figures.time < kBegin) slow_.reset();
    time_ = figures.time;
    figures.slow = {};
    std::string_view sentence;
    if (session.activities().allowed().ownTorch) {
        // A paused metal has no speed.
        if (!session.paused())
            figures.slow = slow_.update(figures.speed, session.run().arc().burns(), elapsed, slowKey(session));
        sentence = arc_.update(session.run().arc(), traitsOf(session.lesson().process).striking, elapsed);
        if (session.attempt().cues().withheld(CueKind::arc)) sentence = {};
        if (lock.holdsBack()) sentence = arcOutSentence(lock.reason());
    }
    if (figures.slow.empty() || slow_.sentence().empty())
        messages.clear(kSlowTopic);
    else
        messages.hold(slow_.sentence(), kSlowTopic);
    const bool atDesk = session.leader() == TorchLeader::desk && !session.run().arc().burns();
    const std::string_view hidden = atDesk ? hiddenCues_.update(session.attempt().cues()) : std::string_view();
    if (hidden.empty())
        messages.clear("cues");
    else
        messages.hold(hidden, "cues");
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
