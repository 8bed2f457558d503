#include "app/headset/headset_changes.hpp"

#include "core/base/text.hpp"

namespace meltpool {

bool HeadsetChanges::lessonBegan(const LessonSession& session) {
    started_ = session.running() && !running_;
    const bool began = started_ || (session.running() && session.run().steps() < steps_);
    running_ = session.running();
    steps_ = session.run().steps();
    if (began) {
        shown_.reset();
        holder_.reset();
        seen_ = burning_ = false;
    }
    return began;
}

void HeadsetChanges::takeParameters(const HeadsetParameters& parameters, float zoom, HeadsetHands& hands,
                                    LessonSession& session) {
    const RecordedValues now{zoom, parameters.tableHeight, parameters.hand, parameters.table};
    const bool fresh = !shown_;
    const RecordedValues last = shown_.value_or(now);
    shown_ = now;
    const auto note = [&](bool changed, std::string_view name, ArcOut reason, const auto& value) {
        if (changed) hands.putOut(reason);
        if (changed || fresh) session.run().event(name, value());
    };
    note(now.zoom != last.zoom, "zoom", ArcOut::zoomed, [&] { return formatNumber(static_cast<double>(now.zoom)); });
    note(now.tableHeight != last.tableHeight, "table_height", ArcOut::tableMoved,
         [&] { return formatNumber(static_cast<double>(now.tableHeight)); });
    note(now.hand != last.hand, "hand", ArcOut::handChanged,
         [&] { return now.hand == HeadsetParameters::kLeft ? "left" : "right"; });
    note(now.table != last.table, "table", ArcOut::tableMoved,
         [&] { return now.table == HeadsetParameters::kSetHeight ? "set" : "automatic"; });
}

void HeadsetChanges::recentred(HeadsetHands& hands, LessonSession& session) {
    hands.putOut(ArcOut::recentred);
    session.run().event("recentred");
}

void HeadsetChanges::takeConnection(bool inUse, HeadsetHands& hands, ArcOut reason, LessonSession& session) {
    if (!inUse) hands.lose(reason);
    if (inUse != inUse_) session.run().event("headset", inUse ? "in_use" : "lost");
    inUse_ = inUse;
}

void HeadsetChanges::takeTorch(const HeadsetHands& hands, LessonSession& session) {
    const TrackedTorch& torch = hands.torch();
    if (torch.tracked() != seen_) session.run().event("torch", torch.tracked() ? "seen" : "lost");
    seen_ = torch.tracked();
    const TorchHolder holder = hands.selector().holder();
    if (holder_ != holder) session.run().event("torch_on", holder == TorchHolder::tracker ? "tracker" : "controller");
    holder_ = holder;
    if (burning_ && torch.triggerLock().locked())
        session.run().event("arc_out", arcOutName(torch.triggerLock().reason()));
    burning_ = torch.trigger() > 0;
}

} // namespace meltpool
