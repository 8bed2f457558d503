#include "app/desktop/shader_watch.hpp"

#include "core/base/words.hpp"

#include <string>

namespace meltpool {

namespace {

constexpr double kPause = 0.5; // s

} // namespace

void ShaderWatch::update(gl::ShaderLibrary& shaders, gl::ContextThread* other, Messages& messages, double now) {
    if (now < next_) return;
    next_ = now + kPause;
    std::string faults;
    const auto reload = [&faults](gl::ShaderLibrary& library) {
        library.reloadChanged();
        for (const std::string& fault : library.standingFaults())
            faults += "\n" + fault;
    };
    reload(shaders);
    if (other != nullptr) other->run([&] { reload(other->shaders()); });
    if (faults.empty())
        messages.clear("shader");
    else
        messages.hold(phrase("desk.message.shader_refused") + faults, "shader");
}

} // namespace meltpool
