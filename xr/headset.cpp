// Hands the frame loop's calls to the worker's thread and limits their duration.
#include "xr/headset.hpp"

#include <algorithm>
#include <utility>

namespace meltpool::xr {

namespace {

constexpr std::chrono::milliseconds kOpening{10000};

/// Far longer than a processor without a card needs for a frame.
constexpr std::chrono::milliseconds kDrawing{60000};

/// The least time for a call, even after a slow frame.
constexpr std::chrono::steady_clock::duration kLeastPatience = std::chrono::milliseconds(50);

/// A member function of the worker as a call for a CallThread.
template <void (RuntimeWorker::*Member)()>
void invoke(ThreadOwned& callee) {
    (static_cast<RuntimeWorker&>(callee).*Member)();
}

} // namespace

Headset::Headset(std::unique_ptr<Instance> instance, const HeadsetSettings& settings) : settings_(settings) {
    auto worker = std::make_unique<RuntimeWorker>(std::move(instance), settings, std::make_unique<SharedContext>());
    worker_ = worker.get();
    thread_ = std::make_unique<CallThread>(std::move(worker));
    thread_->begin(invoke<&RuntimeWorker::open>);
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
    const GLenum depth = hasDepthLayer() ? worker_->depthFormat : GL_DEPTH_COMPONENT32F;
    targets_ =
        std::make_unique<EyeTargets>(worker_->colourFormat, depth, worker_->width, worker_->height, settings_.samples);
    panel_ = std::make_unique<Panel>(worker_->colourFormat, settings_.panel);
    notice_ = std::make_unique<Panel>(worker_->colourFormat, settings_.notice);
    note();
}

void Headset::note() {
    running_ = worker_->session->running();
    mode_ = worker_->session->mode();
    hapticCalls_ = worker_->input->hapticCalls();
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
    news_ = {};
    patience_ = kPatience;
    if (stalled_) {
        if (!thread_->over()) throw Stalled();
        stalled_ = false;
        const bool late = std::exchange(waitedLate_, false);
        thread_->rethrow();
        waitedLate_ = late;
        if (!late) call(invoke<&RuntimeWorker::dropFrame>);
    }
    // Every call costs the time of both threads, so events polled by endFrame() are not polled again.
    if (!std::exchange(polled_, false)) call(invoke<&RuntimeWorker::poll>);
    if (!running_) waitedLate_ = false;
}

FrameTiming Headset::waitFrame() {
    if (!std::exchange(waitedLate_, false)) {
        waitedLate_ = true; // set here, as the call may be abandoned
        call(invoke<&RuntimeWorker::waitFrame>, WorkPlace::waiting);
        waitedLate_ = false;
    }
    news_ = std::exchange(worker_->news, {});
    return worker_->timing;
}

void Headset::beginFrame() {
    call(invoke<&RuntimeWorker::beginFrame>);
    worker_->submission = {};
}

bool Headset::locateEyes(std::array<EyeView, 2>& eyes) {
    call(invoke<&RuntimeWorker::locateEyes>);
    if (worker_->headTracked) eyes = worker_->views;
    return worker_->headTracked;
}

bool Headset::drawEyes(FunctionRef<void(const BothEyes&)> draw) {
    if (!worker_->headTracked) return false;
    draw({worker_->views, targets_->framebuffer(), targets_->width(), targets_->height(), targets_->encodesSrgb(),
          settings_.nearZ, settings_.farZ, worker_->masks.triangles()});
    // The worker may still be copying the last frame's pictures.
    if (worker_->copied != nullptr) {
        glWaitSync(worker_->copied, 0, GL_TIMEOUT_IGNORED);
        glDeleteSync(std::exchange(worker_->copied, nullptr));
    }
    targets_->resolve();
    worker_->submission.eyes = true;
    worker_->submission.colour = targets_->finishedColour();
    worker_->submission.depth = targets_->finishedDepth();
    return true;
}

void Headset::show(Quad quad, const Panel& picture, const Pose& pose, bool fresh) {
    worker_->submission.quads[size_t(quad)] = {true, fresh, picture.texture(), pose, 0};
}

void Headset::showPanel(const Pose& pose) {
    show(Quad::panel, *panel_, pose, true);
}

void Headset::showNotice(const Pose& pose, float width, bool fresh) {
    show(Quad::notice, *notice_, pose, fresh);
    worker_->submission.quads[size_t(Quad::notice)].width = width;
}

void Headset::play(Hand which, const HapticPulse& pulse) {
    worker_->submission.plays[size_t(which)] = true;
    worker_->submission.pulses[size_t(which)] = pulse;
}

void Headset::playTracker(size_t which, const HapticPulse& pulse) {
    worker_->submission.trackerPlays = true;
    worker_->submission.tracker = which;
    worker_->submission.trackerPulse = pulse;
}

void Headset::awaitDrawing() {
    const InWork driver(WorkPlace::driver);
    // Drawing on the processor may take long; the runtime does not cause this.
    thread_->begin(invoke<&RuntimeWorker::awaitDrawing>);
    if (!thread_->wait(kDrawing)) {
        stalled_ = true;
        throw Stalled();
    }
    if (WorkMeter* meter = WorkMeter::current()) meter->add(thread_->work());
    thread_->rethrow();
}

void Headset::endFrame() {
    const auto& quads = worker_->submission.quads;
    const bool copies = std::any_of(quads.begin(), quads.end(), [](const QuadSubmission& quad) { return quad.fresh; });
    if (worker_->submission.eyes || copies) {
        worker_->submission.drawn = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
        glFlush(); // otherwise the worker's context would wait for commands that were never sent
        if (worker_->drawsOnProcessor()) awaitDrawing();
    }
    call(invoke<&RuntimeWorker::endFrame>);
    polled_ = true;
}

void Headset::requestExit() {
    call(invoke<&RuntimeWorker::requestExit>);
}

std::shared_ptr<const std::atomic<bool>> Headset::leave() {
    return std::exchange(thread_, nullptr)->leave();
}

} // namespace meltpool::xr
