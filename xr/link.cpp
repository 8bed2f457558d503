// Finding, opening and losing the headset.
#include "xr/link.hpp"

#include <algorithm>

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

HeadsetLink::~HeadsetLink() {
    if (looking_) looking_->wait();
}

HeadsetLink::Found HeadsetLink::look() {
    try {
        return {std::make_unique<Instance>(), {}};
    } catch (const XrFault& fault) {
        return {nullptr, explain(fault)};
    } catch (const std::exception& other) {
        return {nullptr, other.what()};
    }
}

LinkState HeadsetLink::update() {
    if (state_ == LinkState::ended) return state_;
    try {
        if (headset_ == nullptr) search();
        if (headset_ == nullptr) return state_ = LinkState::searching;
        headset_->poll();
    } catch (const XrFault& fault) {
        onFault(fault);
        return state_;
    }
    switch (headset_->session().mode()) {
    case SessionMode::lost:
        drop("the headset has gone away; it is taken again as soon as it is back");
        break;
    case SessionMode::ended:
        headset_.reset();
        reason_ = "the headset's own menu has closed the trainer";
        state_ = LinkState::ended;
        break;
    default:
        state_ = headset_->running() ? LinkState::running : LinkState::asleep;
    }
    return state_;
}

void HeadsetLink::search() {
    if (!looking_) {
        if (Clock::now() < nextLook_) return;
        looking_ = std::async(std::launch::async, look);
    }
    if (looking_->wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    Found found = looking_->get();
    looking_.reset();
    nextLook_ = Clock::now() + pause_;
    pause_ = std::min(2 * pause_, kLongestPause);
    reason_ = found.reason;
    if (found.instance != nullptr) open(std::move(found.instance));
}

void HeadsetLink::open(std::unique_ptr<Instance> instance) {
    try {
        headset_ = std::make_unique<Headset>(std::move(instance), settings_);
        ++openings_;
    } catch (const XrFault& fault) {
        reason_ = explain(fault);
    } catch (const std::exception& wrong) {
        reason_ = wrong.what();
    }
}

void HeadsetLink::onFault(const XrFault& fault) {
    drop(explain(fault));
}

void HeadsetLink::drop(std::string reason) {
    headset_.reset();
    reason_ = std::move(reason);
    pause_ = kFirstPause;
    nextLook_ = Clock::now() + pause_;
    state_ = LinkState::searching;
}

void HeadsetLink::close() {
    headset_.reset();
    state_ = LinkState::ended;
    reason_ = "the headset is not used";
}

} // namespace meltpool::xr
