#include "app/desktop/seat_requests.hpp"

#include "core/base/words.hpp"

#include <algorithm>
#include <string>
#include <string_view>

namespace meltpool {

namespace {

/// Request that the other person reads about.
struct ToldRequest {
    MenuRequest request;
    std::string_view event;                ///< value for the record
    std::array<std::string_view, 2> words; ///< keys of the sentences, indexed by Seat
    bool ends;                             ///< ends the running attempt, or a part of it
};

constexpr std::array<ToldRequest, 12> kTold{{
    {MenuRequest::home, "home", {"seat.desk.home", "seat.headset.home"}, true},
    {MenuRequest::tryCure, "home", {"seat.desk.home", "seat.headset.home"}, true},
    {MenuRequest::openLesson, "open_lesson", {"seat.desk.open", "seat.headset.open"}, true},
    {MenuRequest::next, "next_lesson", {"seat.desk.open", "seat.headset.open"}, true},
    {MenuRequest::start, "start", {"seat.desk.start", "seat.headset.start"}, true},
    {MenuRequest::startWithDefaults, "start", {"seat.desk.start", "seat.headset.start"}, true},
    {MenuRequest::demonstrate, "demonstration", {"seat.desk.demonstrate", "seat.headset.demonstrate"}, true},
    {MenuRequest::replay, "replay", {"seat.desk.replay", "seat.headset.replay"}, true},
    {MenuRequest::reset, "new_attempt", {"seat.desk.reset", "seat.headset.reset"}, true},
    {MenuRequest::restart, "lesson_page", {"seat.desk.restart", "seat.headset.restart"}, true},
    {MenuRequest::redo, "redo", {"seat.desk.redo", "seat.headset.redo"}, true},
    {MenuRequest::judge, "judge", {"seat.desk.judge", "seat.headset.judge"}, false},
}};

const ToldRequest* toldOf(MenuRequest request) {
    const auto found =
        std::find_if(kTold.begin(), kTold.end(), [&](const ToldRequest& t) { return t.request == request; });
    return found == kTold.end() ? nullptr : &*found;
}

std::string_view topicOf(Seat seat) {
    return seat == Seat::desk ? kDeskTopic : std::string_view("headset did");
}

} // namespace

bool endsAttempt(MenuRequest request) {
    const ToldRequest* told = toldOf(request);
    return told != nullptr && told->ends;
}

void SeatRequests::update(bool inUse, bool deskLeads, double now) {
    const size_t steps = session_.run().steps();
    if (!session_.running() || (steps < steps_ && session_.log().redo().redone() == 0)) welded_ = false;
    steps_ = steps;
    welded_ = welded_ || session_.welds();
    inUse_ = inUse;
    for (const Seat seat : {Seat::desk, Seat::headset})
        if (question(seat).asked() && !endsWeldOfOther(seat)) question(seat) = {};
    if (!inUse || !session_.running()) {
        deskLeads_.reset();
        return;
    }
    const bool changed = deskLeads_ && *deskLeads_ != deskLeads;
    deskLeads_ = deskLeads;
    if (!changed || !session_.activities().allowed().ownTorch) return;
    session_.run().event("torch_led_by", deskLeads ? "desk" : "headset");
    messages_.note(phrase(deskLeads ? "seat.desk.torch" : "seat.headset.torch"), now, std::string(kDeskTopic));
}

/// Returns true if the other person leads the torch of an attempt that has begun and is not judged.
bool SeatRequests::endsWeldOfOther(Seat asker) const {
    if (!inUse_ || !session_.running() || !session_.activities().allowed().ownTorch) return false;
    const bool others = asker == Seat::desk ? session_.leader() == TorchLeader::hand : deskLeads_.value_or(false);
    return others && (session_.welds() || (welded_ && !session_.attempt().judged()));
}

bool SeatRequests::allows(Seat asker, MenuRequest request) {
    const ToldRequest* told = toldOf(request);
    if (told == nullptr || !told->ends || !endsWeldOfOther(asker)) return true;
    Pending& pending = pending_[static_cast<size_t>(asker)];
    pending.request = request;
    pending.question = {phrase(asker == Seat::desk ? "seat.question.trainee_welds" : "seat.question.teacher_welds"),
                        {phrase("seat.question.let_weld"), phrase("seat.question.end")}};
    return false;
}

void SeatRequests::note(Seat asker, MenuRequest request, double now) {
    const ToldRequest* told = toldOf(request);
    if (!inUse_ || told == nullptr) return;
    session_.run().event(asker == Seat::desk ? "asked_at_desk" : "asked_in_headset", told->event);
    messages_.note(phrase(told->words[static_cast<size_t>(asker)]), now, std::string(topicOf(asker)));
}

MenuRequest SeatRequests::takeConfirmed(Seat asker) {
    Pending& pending = pending_[static_cast<size_t>(asker)];
    if (!pending.question.asked() || pending.question.answered < 0) return MenuRequest::none;
    const bool yes = pending.question.answered == 1;
    pending.question = {};
    return yes ? pending.request : MenuRequest::none;
}

} // namespace meltpool
