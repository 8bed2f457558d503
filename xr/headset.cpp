// The headset as its frame loop sees it.
#include "xr/headset.hpp"

#include <algorithm>
#include <utility>

namespace meltpool::xr {

namespace {

constexpr std::chrono::milliseconds kOpening{10000};

/// Even the last call of a slow frame gets this long.
constexpr std::chrono::steady_clock::duration kLeastPatience = std::chrono::milliseconds(50);

/// A member function of the calls as a CallThread takes it.
template <void (HeadsetCalls::*Member)()>
void invoke(Callee& callee) {
    (static_cast<HeadsetCalls&>(callee).*Member)();
}

} // namespace

Headset::Headset(std::unique_ptr<Instance> instance, const HeadsetSettings& settings) : settings_(settings) {
    auto calls = std::make_unique<HeadsetCalls>(std::move(instance), settings, std::make_unique<SharedContext>());
    calls_ = calls.get();
    thread_ = std::make_unique<CallThread>(std::move(calls));
    thread_->begin(invoke<&HeadsetCalls::open>);
}

Headset::~Headset() = default;

bool Headset::opened() {
    if (targets_ != nullptr) return true;
    if (!thread_->over()) return false;
    thread_->rethrow();
    finishOpening();
    return true;
}

void Headset::waitUntilOpened() {
    if (!thread_->wait(kOpening)) throw Stalled();
    opened();
}

void Headset::finishOpening() {
    const GLenum depth = hasDepthLayer() ? calls_->depthFormat : GL_DEPTH_COMPONENT32F;
    targets_ =
        std::make_unique<EyeTargets>(calls_->colourFormat, depth, calls_->width, calls_->height, settings_.samples);
    panel_ = std::make_unique<Panel>(calls_->colourFormat, settings_.panel);
    note();
}

void Headset::note() {
    running_ = calls_->session->running();
    mode_ = calls_->session->mode();
    hapticCalls_ = calls_->input->hapticCalls();
}

void Headset::call(CallThread::Call work, WorkPlace place) {
    if (stalled_) throw Stalled();
    const InWork elsewhere(place);
    const auto begin = std::chrono::steady_clock::now();
    thread_->begin(work);
    if (!thread_->wait(std::chrono::duration_cast<std::chrono::milliseconds>(patience_))) {
        stalled_ = true;
        throw Stalled();
    }
    patience_ = std::max(patience_ - (std::chrono::steady_clock::now() - begin), kLeastPatience);
    if (WorkMeter* meter = WorkMeter::current()) meter->add(thread_->work());
    thread_->rethrow();
    note();
}

void Headset::poll() {
    patience_ = kPatience;
    if (stalled_) {
        if (!thread_->over()) throw Stalled();
        stalled_ = false;
        thread_->rethrow();
        call(invoke<&HeadsetCalls::dropFrame>);
    }
    // Each call that is handed over takes both threads' time.
    if (!std::exchange(heard_, false)) call(invoke<&HeadsetCalls::poll>);
}

FrameTiming Headset::waitFrame() {
    call(invoke<&HeadsetCalls::waitFrame>, WorkPlace::waiting);
    return calls_->timing;
}

void Headset::beginFrame() {
    call(invoke<&HeadsetCalls::beginFrame>);
    calls_->order = {};
}

bool Headset::locateEyes(std::array<EyeView, 2>& eyes) {
    call(invoke<&HeadsetCalls::locateEyes>);
    if (calls_->headTracked) eyes = calls_->views;
    return calls_->headTracked;
}

bool Headset::drawEyes(FunctionRef<void(const BothEyes&)> draw) {
    if (!calls_->headTracked) return false;
    draw({calls_->views, targets_->framebuffer(), targets_->width(), targets_->height(), targets_->encodesSrgb(),
          settings_.nearZ, settings_.farZ});
    // The last frame's pictures may still be on their way to the runtime.
    if (calls_->copied != nullptr) {
        glWaitSync(calls_->copied, 0, GL_TIMEOUT_IGNORED);
        glDeleteSync(std::exchange(calls_->copied, nullptr));
    }
    targets_->resolve();
    calls_->order.eyes = true;
    calls_->order.colour = targets_->finishedColour();
    calls_->order.depth = targets_->finishedDepth();
    return true;
}

void Headset::showPanel(const Pose& pose) {
    calls_->order.panelShown = true;
    calls_->order.panel = panel_->texture();
    calls_->order.panelPose = pose;
}

void Headset::play(Hand which, const HapticPulse& pulse) {
    calls_->order.plays[size_t(which)] = true;
    calls_->order.pulses[size_t(which)] = pulse;
}

void Headset::playTracker(size_t which, const HapticPulse& pulse) {
    calls_->order.trackerPlays = true;
    calls_->order.tracker = which;
    calls_->order.trackerPulse = pulse;
}

void Headset::endFrame() {
    if (calls_->order.eyes || calls_->order.panelShown) {
        calls_->order.drawn = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
        glFlush(); // or the other context would wait for commands that nobody has sent
    }
    call(invoke<&HeadsetCalls::endFrame>);
    heard_ = true;
}

void Headset::requestExit() {
    call(invoke<&HeadsetCalls::requestExit>);
}

std::shared_ptr<const std::atomic<bool>> Headset::leave() {
    return std::exchange(thread_, nullptr)->leave();
}

} // namespace meltpool::xr
