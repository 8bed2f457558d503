// Finding, opening and losing the headset.
#include "xr/link.hpp"

#include <algorithm>
#include <thread>
#include <utility>

namespace meltpool::xr {

namespace {

using Clock = std::chrono::steady_clock;
// A runtime that has just gone is often back at once; one that was never there is not worth a look (and its library's
// words on the terminal) every second.
constexpr auto kFirstPause = std::chrono::milliseconds(1000);
constexpr auto kLongestPause = std::chrono::milliseconds(8000);

} // namespace

std::string explain(const XrFault& fault) {
    switch (fault.result()) {
    case XR_ERROR_RUNTIME_UNAVAILABLE:
        return "no OpenXR runtime is active; install SteamVR, Meta Link, Monado or WiVRn and make it the active OpenXR "
               "runtime "
               "in its own settings";
    case XR_ERROR_FORM_FACTOR_UNAVAILABLE:
        return "the OpenXR runtime runs but sees no headset; switch the headset on, plug it in or connect it to this "
               "computer";
    case XR_ERROR_INSTANCE_LOST:
        return "the OpenXR runtime has gone away; it is taken again as soon as it is back";
    case XR_ERROR_SESSION_LOST:
        return "the headset has gone away; it is taken again as soon as it is back";
    case XR_ERROR_RUNTIME_FAILURE:
        return "the OpenXR runtime does not answer; start it (for Monado: monado-service) or restart it";
    case XR_ERROR_LIMIT_REACHED:
        return "another program holds the headset; close it";
    default:
        return fault.what();
    }
}

HeadsetLink::HeadsetLink(HeadsetSettings settings) : settings_(settings), nextLook_(Clock::now()), pause_(kFirstPause) {
    quietLoader();
}

HeadsetLink::~HeadsetLink() = default;

void HeadsetLink::look(Search& search) {
    try {
        search.instance = std::make_unique<Instance>();
    } catch (const XrFault& fault) {
        search.reason = explain(fault);
    } catch (const std::exception& other) {
        search.reason = other.what();
    }
    search.over = true;
}

LinkState HeadsetLink::update() {
    if (state_ == LinkState::ended) return state_;
    try {
        if (headset_ == nullptr) search();
        if (headset_ == nullptr || !open()) return state_ = LinkState::searching;
        headset_->poll();
    } catch (const XrFault& fault) {
        onFault(fault);
        return state_;
    } catch (const Stalled&) {
        onStall();
        return state_;
    }
    switch (headset_->mode()) {
    case SessionMode::lost:
        drop("the headset has gone away; it is taken again as soon as it is back");
        break;
    case SessionMode::ended:
        drop("the headset's own menu has closed the trainer");
        state_ = LinkState::ended;
        break;
    default:
        state_ = headset_->running() ? LinkState::running : LinkState::asleep;
    }
    return state_;
}

void HeadsetLink::search() {
    if (gone_ != nullptr && !*gone_) return;
    if (looking_ == nullptr) {
        if (Clock::now() < nextLook_) return;
        looking_ = std::make_shared<Search>();
        std::thread([search = looking_] { look(*search); }).detach();
    }
    if (!looking_->over) return;
    const std::shared_ptr<Search> found = std::exchange(looking_, nullptr);
    nextLook_ = Clock::now() + pause_;
    pause_ = std::min(2 * pause_, kLongestPause);
    reason_ = found->reason;
    if (found->instance == nullptr) return;
    try {
        headset_ = std::make_unique<Headset>(std::move(found->instance), settings_);
    } catch (const std::exception& wrong) {
        reason_ = wrong.what();
    }
}

/// Sees the opening of a session through; false: not yet, or it failed.
bool HeadsetLink::open() {
    const bool before = opened_;
    try {
        opened_ = headset_->opened();
    } catch (const std::exception& wrong) {
        const auto* fault = dynamic_cast<const XrFault*>(&wrong);
        reason_ = fault != nullptr ? explain(*fault) : wrong.what();
        letGo();
        return false;
    }
    if (opened_ && !before) ++openings_;
    return opened_;
}

void HeadsetLink::letGo() {
    if (headset_ == nullptr) return;
    gone_ = headset_->leave();
    headset_.reset();
    opened_ = false;
}

void HeadsetLink::onStall() {
    reason_ = "the OpenXR runtime does not answer: the arc is out; it is taken again as soon as it does";
    state_ = LinkState::stalled;
}

void HeadsetLink::onFault(const XrFault& fault) {
    drop(explain(fault));
}

void HeadsetLink::drop(std::string reason) {
    letGo();
    reason_ = std::move(reason);
    pause_ = kFirstPause;
    nextLook_ = Clock::now() + pause_;
    state_ = LinkState::searching;
}

void HeadsetLink::close() {
    headset_.reset(); // waits for the session's orderly end
    opened_ = false;
    state_ = LinkState::ended;
    reason_ = "the headset is not used";
}

} // namespace meltpool::xr
