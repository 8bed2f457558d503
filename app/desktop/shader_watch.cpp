#include "app/desktop/shader_watch.hpp"

#include <string>

namespace meltpool {

namespace {

constexpr double kPause = 0.5; // s

} // namespace

void ShaderWatch::update(gl::ShaderLibrary& shaders, Messages& messages, double now) {
    if (now < next_) return;
    next_ = now + kPause;
    shaders.reloadChanged();
    std::string faults;
    for (const std::string& fault : shaders.standingFaults())
        faults += "\n" + fault;
    if (faults.empty())
        messages.clear("shader");
    else
        messages.hold("A changed shader was refused; its old version runs on:" + faults, "shader");
}

} // namespace meltpool
