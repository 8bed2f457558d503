#include "app/session/trigger_lock.hpp"

#include <array>

namespace meltpool {

namespace {

struct Words {
    std::string_view name, sentence;
};

/// In the order of ArcOut.
constexpr std::array<Words, 15> kWords{{
    {"recentred", "The workshop has moved: the arc is out. Let the trigger go to strike again."},
    {"zoomed", "The zoom has changed: the arc is out. Let the trigger go to strike again."},
    {"hand", "The torch is in the other hand: the arc is out. Let the trigger go to strike again."},
    {"holder", "Something else holds the torch: the arc is out. Let the trigger go to strike again."},
    {"table", "The table has moved: the arc is out. Let the trigger go to strike again."},
    {"jump", "The torch has jumped: the arc is out. Let the trigger go to strike again."},
    {"torch_lost", "The torch was out of sight: the arc is out. Let the trigger go to strike again."},
    {"runtime_lost", "The headset was away: the arc is out. Let the trigger go to strike again."},
    {"not_focused", "The headset showed something else: the arc is out. Let the trigger go to strike again."},
    {"taken_over", "Mouse or hand has taken the torch over: the arc is out. Let the trigger go to strike again."},
    {"paused", "The lesson was paused: the arc is out. Let the trigger go to strike again."},
    {"lesson", "The lesson begins: let the trigger go, then strike."},
    {"panel", "The trigger was used at the panel: let it go to strike."},
    {"measuring", "The torch was measured: let the trigger go to strike."},
    {"redone", "You are back at an earlier moment: let the trigger go, then strike."},
}};

static_assert(kWords.size() == static_cast<size_t>(ArcOut::redone) + 1);

} // namespace

std::string_view arcOutName(ArcOut reason) {
    return kWords[static_cast<size_t>(reason)].name;
}

std::string_view arcOutSentence(ArcOut reason) {
    return kWords[static_cast<size_t>(reason)].sentence;
}

void TriggerLock::lock(ArcOut reason) {
    if (!locked_) reason_ = reason;
    locked_ = true;
}

float TriggerLock::pass(float travel, bool seen) {
    pulled_ = seen && travel > kLetGo;
    if (!seen) return 0;
    locked_ = locked_ && pulled_;
    return locked_ ? 0 : travel;
}

} // namespace meltpool
