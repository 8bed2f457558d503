#include "app/desktop/background_steps.hpp"

#include "core/base/work_meter.hpp"
#include "core/gl/software_driver/software_driver.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <utility>

namespace meltpool {

BackgroundSteps::BackgroundSteps(const std::filesystem::path& shaders) {
    if (!gl::dispatchIsSynchronous()) return;
    auto thread = std::make_unique<StepThread>(std::make_unique<HeadlessStepContext>(shaders));
    if (thread->usable()) thread_ = std::move(thread);
}

double BackgroundSteps::timeBeside(double lastFrameSeconds) const {
    const double waited = ofLastFrame_ ? ofLastFrame_->waited : 0;
    return std::max(lastFrameSeconds - waited, 1e-3);
}

void BackgroundSteps::begin(std::function<void()> work) {
    if (due_) thread_->begin(std::move(work));
}

bool BackgroundSteps::finish() {
    ofLastFrame_.reset();
    if (!std::exchange(due_, false)) return false;
    {
        const InWork waiting(WorkPlace::waiting);
        thread_->wait();
    }
    ofLastFrame_ = {thread_->seconds(), thread_->waited()};
    return true;
}

void BackgroundSteps::abandon() {
    try {
        if (thread_) thread_->wait();
    } catch (const std::exception& fault) {
        std::fprintf(stderr, "meltpool: %s\n", fault.what());
    }
}

} // namespace meltpool
