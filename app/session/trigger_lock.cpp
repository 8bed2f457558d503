#include "app/session/trigger_lock.hpp"

#include "core/base/words.hpp"

#include <array>

namespace meltpool {

namespace {

constexpr std::string_view kGroup = "notice.arc_out.";

/// Keys of the sentences in the order of ArcOut; the part after the group is the word for records.
constexpr std::array<std::string_view, 15> kKeys{
    "notice.arc_out.recentred",  "notice.arc_out.zoomed",       "notice.arc_out.hand",
    "notice.arc_out.holder",     "notice.arc_out.table",        "notice.arc_out.jump",
    "notice.arc_out.torch_lost", "notice.arc_out.runtime_lost", "notice.arc_out.not_focused",
    "notice.arc_out.taken_over", "notice.arc_out.paused",       "notice.arc_out.lesson",
    "notice.arc_out.panel",      "notice.arc_out.measuring",    "notice.arc_out.redone",
};
static_assert(kKeys.size() == static_cast<size_t>(ArcOut::redone) + 1);

} // namespace

std::string_view arcOutName(ArcOut reason) {
    return kKeys[static_cast<size_t>(reason)].substr(kGroup.size());
}

std::string_view arcOutSentence(ArcOut reason) {
    return phrase(kKeys[static_cast<size_t>(reason)]);
}

void TriggerLock::lock(ArcOut reason) {
    if (!locked_ || reason == ArcOut::lessonBegan) reason_ = reason;
    locked_ = true;
}

float TriggerLock::pass(float travel, bool seen) {
    pulled_ = seen && travel > kLetGo;
    if (!seen) return 0;
    locked_ = locked_ && pulled_;
    return locked_ ? 0 : travel;
}

} // namespace meltpool
