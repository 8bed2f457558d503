// A drawing program in two forms: for targets that encode sRGB by themselves and for those that do not.
#pragma once

#include "core/gl/program.hpp"
#include "core/render/view.hpp"

#include <string>

namespace meltpool {

class TonedProgram {
  public:
    /// Files relative to the shader folder. Throws InputError when one does not compile.
    TonedProgram(gl::ShaderLibrary& shaders, const std::string& vertex, const std::string& fragment)
        : light_(shaders.load({vertex, fragment})), shown_(shaders.load({vertex, fragment}, {{"ENCODE_SRGB", "1"}})) {}

    /// Makes the form for `target` current and returns it.
    const gl::Program& use(const RenderTarget& target) const {
        const gl::Program& program = target.encodesSrgb ? light_ : shown_;
        program.use();
        return program;
    }

  private:
    const gl::Program& light_;
    const gl::Program& shown_;
};

} // namespace meltpool
