// Searches on a thread of its own, since making an instance may block for seconds.
#include "xr/headset_connection.hpp"

#include "core/base/words.hpp"
#include "xr/runtime_manifest.hpp"

#include <algorithm>
#include <thread>
#include <utility>

namespace meltpool::xr {

namespace {

using Clock = std::chrono::steady_clock;
// A runtime that disappeared is often back within a second. The search for one that was never there gets rarer and
// rarer: each attempt costs time and writes its library's messages to the terminal.
constexpr auto kFirstPause = std::chrono::milliseconds(1000);
constexpr auto kLongestPause = std::chrono::milliseconds(8000);

std::string unavailable(const RuntimeManifest& manifest) {
    if (!manifest.fault.empty()) return manifest.fault;
    if (!manifest.file.empty())
        return phrase("headset.reason.not_loaded", {{"file", manifest.file}, {"library", manifest.library}});
    return phrase("headset.reason.no_runtime");
}

} // namespace

std::string explain(const XrFault& fault) {
    switch (fault.result()) {
    case XR_ERROR_RUNTIME_UNAVAILABLE:
        return unavailable(findRuntimeManifest());
    case XR_ERROR_FORM_FACTOR_UNAVAILABLE:
        return phrase("headset.reason.no_headset");
    case XR_ERROR_INSTANCE_LOST:
        return phrase("headset.reason.stopped");
    case XR_ERROR_SESSION_LOST:
        return phrase("headset.reason.disconnected");
    case XR_ERROR_RUNTIME_FAILURE:
        return phrase("headset.reason.no_answer");
    case XR_ERROR_LIMIT_REACHED:
        return phrase("headset.reason.held");
    default:
        return fault.what();
    }
}

HeadsetConnection::HeadsetConnection(HeadsetSettings settings)
    : settings_(settings), nextLook_(Clock::now()), pause_(kFirstPause) {
    quietLoader();
}

HeadsetConnection::~HeadsetConnection() = default;

void HeadsetConnection::look(Search& search) {
    try {
        const RuntimeManifest manifest = findRuntimeManifest();
        search.manifestAtFault = !manifest.fault.empty();
        // The loader's own message says only that there is no runtime.
        if (search.manifestAtFault)
            search.reason = unavailable(manifest);
        else
            search.instance = std::make_unique<Instance>();
    } catch (const XrFault& fault) {
        search.reason = explain(fault);
        search.noRuntime = fault.result() == XR_ERROR_RUNTIME_UNAVAILABLE;
    } catch (const std::exception& other) {
        search.reason = other.what();
    }
    search.over = true;
}

ConnectionState HeadsetConnection::update() {
    if (state_ == ConnectionState::ended) return state_;
    try {
        if (headset_ == nullptr) search();
        if (headset_ == nullptr || !open()) return state_ = ConnectionState::searching;
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
        lose(phrase("headset.reason.disconnected"));
        break;
    case SessionMode::ended:
        lose(phrase("headset.reason.closed"));
        state_ = ConnectionState::ended;
        break;
    default:
        state_ = headset_->running() ? ConnectionState::running : ConnectionState::asleep;
    }
    return state_;
}

void HeadsetConnection::search() {
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
    manifestAtFault_ = found->manifestAtFault;
    noRuntime_ = found->noRuntime;
    if (found->instance == nullptr) return noteFailure();
    try {
        headset_ = std::make_unique<Headset>(std::move(found->instance), settings_);
    } catch (const std::exception& wrong) {
        reason_ = wrong.what();
        noteFailure();
    }
}

void HeadsetConnection::noteFailure() {
    if (!failedSince_) failedSince_ = Clock::now();
}

bool HeadsetConnection::hopeless() const {
    return manifestAtFault_ || noRuntime_ || (failedSince_ && Clock::now() - *failedSince_ > kPatience);
}

/// Continues opening the session; false while it is not open, or if it failed.
bool HeadsetConnection::open() {
    const bool before = opened_;
    try {
        opened_ = headset_->opened();
    } catch (const std::exception& wrong) {
        const auto* fault = dynamic_cast<const XrFault*>(&wrong);
        reason_ = fault != nullptr ? explain(*fault) : wrong.what();
        release();
        noteFailure();
        return false;
    }
    if (opened_) failedSince_.reset();
    if (opened_ && !before) ++openings_;
    return opened_;
}

void HeadsetConnection::release() {
    if (headset_ == nullptr) return;
    gone_ = headset_->leave();
    headset_.reset();
    opened_ = false;
}

void HeadsetConnection::onStall() {
    reason_ = phrase("headset.reason.stalled");
    state_ = ConnectionState::stalled;
}

void HeadsetConnection::onFault(const XrFault& fault) {
    lose(explain(fault));
}

void HeadsetConnection::lose(std::string reason) {
    release();
    reason_ = std::move(reason);
    pause_ = kFirstPause;
    nextLook_ = Clock::now() + pause_;
    state_ = ConnectionState::searching;
}

void HeadsetConnection::close() {
    headset_.reset(); // waits for the session to end
    opened_ = false;
    state_ = ConnectionState::ended;
    reason_ = phrase("headset.reason.not_used");
}

} // namespace meltpool::xr
