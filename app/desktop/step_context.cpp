#include "app/desktop/step_context.hpp"

#include "core/base/error.hpp"
#include "core/gl/software_driver/software_driver.hpp"

namespace meltpool {

bool HeadlessStepContext::enter() {
    try {
        context_.emplace();
    } catch (const InputError&) { // the window's own context serves as well
        return false;
    }
    if (!gl::dispatchIsSynchronous()) {
        context_.reset();
        return false;
    }
    shaders_.emplace(root_);
    return true;
}

void HeadlessStepContext::leave() {
    shaders_.reset();
    context_.reset();
}

} // namespace meltpool
