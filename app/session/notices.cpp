#include "app/session/notices.hpp"

#include <cmath>
#include <cstdio>

namespace meltpool {

namespace {

/// m; arcs that became too long are longer, tips that have touched are nearer.
constexpr float kTouched = 1e-3f;

} // namespace

std::string_view ArcNotice::reasonOut(bool wire, float distance) {
    if (!wire && distance < kTouched) {
        wentOut_ = "touched";
        return "The electrode has touched the metal and is spoiled: the arc is out. Let the trigger go, then strike "
               "again.";
    }
    wentOut_ = "too_long";
    if (wire) return "The arc became too long: it is out. Bring the torch nearer.";
    return "The arc became too long: it is out. Let the trigger go, then strike nearer.";
}

std::string_view ArcNotice::update(const ProcessSettings& process, const ArcState& arc, bool pulled, double elapsed) {
    wentOut_ = {};
    const bool wire = process.is<Gmaw>();
    if (!pulled || !(wire || process.is<Gtaw>())) {
        *this = {};
        return {};
    }
    const bool burnt = burns_;
    burns_ = arc.burns();
    if (burns_) {
        burnt_ = true;
        reason_ = {};
        waiting_ = arc.action == ArcAction::stubbed ? waiting_ + elapsed : 0;
        return waiting_ > kPatience ? "The wire stubs: it comes faster than the arc melts it." : std::string_view();
    }
    if (burnt) {
        waiting_ = 0;
        reason_ = reasonOut(wire, arc.distance);
    }
    waiting_ += elapsed;
    if (burnt_ || waiting_ <= kPatience) return reason_;
    if (std::isinf(arc.distance)) return "There is no arc: no metal lies before the torch.";
    if (wire) return {}; // it is on its way to the metal
    return arc.distance < kTouched ? "There is no arc: the electrode touches the metal. Lift it, then strike."
                                   : "There is no arc: the electrode is too far from the metal. Strike nearer.";
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
    if (session.running()) {
        figures.slow = slow_.update(figures.speed, elapsed);
        const bool weld = session.lesson().model == LessonModel::Weld;
        sentence = arc_.update(session.lesson().process, session.arc(), weld && session.torch().trigger > 0, elapsed);
        if (!arc_.wentOut().empty()) session.event("arc_out", arc_.wentOut());
        if (lock.holdsBack()) sentence = arcOutSentence(lock.reason());
    }
    tellSlow(figures.slow, messages);
    if (sentence.empty())
        messages.clear("arc");
    else
        messages.hold(sentence, "arc");
}

} // namespace meltpool
