// Drawing programs in their variants: for each way of submitting views, and for targets that do or do not encode sRGB.
#pragma once

#include "core/gl/program.hpp"
#include "core/render/view.hpp"
#include "core/render/view_submission.hpp"

#include <array>
#include <string>

namespace meltpool {

/// A program whose vertex shader includes render/view.glsl.
class ViewProgram {
  public:
    /// Takes files relative to the shader folder. Loads the variant for single views; throws InputError when it does
    /// not compile.
    ViewProgram(gl::ShaderLibrary& shaders, std::string vertex, std::string fragment, gl::Defines defines = {})
        : shaders_(shaders), vertex_(std::move(vertex)), fragment_(std::move(fragment)), defines_(std::move(defines)) {
        load(ViewSubmission::passes);
    }

    /// Loads the variant for one way of submission. Throws InputError when the driver does not compile it.
    void load(ViewSubmission submission) {
        gl::Defines defines = defines_;
        if (submission == ViewSubmission::viewports) defines["VIEWS_BY_VIEWPORT"] = "1";
        if (submission == ViewSubmission::clipping) defines["VIEWS_BY_CLIPPING"] = "1";
        variants_[static_cast<size_t>(submission)] = &shaders_.load({vertex_, fragment_}, std::move(defines));
    }

    /// Makes the variant for these views current and returns it.
    const gl::Program& use(const ViewBatch& views) const {
        const gl::Program& program = *variants_[static_cast<size_t>(views.submission)];
        program.use();
        program.set("firstView", views.first);
        return program;
    }

  private:
    gl::ShaderLibrary& shaders_;
    std::string vertex_;
    std::string fragment_;
    gl::Defines defines_;
    std::array<const gl::Program*, kViewSubmissions.size()> variants_{};
};

/// A ViewProgram whose fragment shader includes render/tone.glsl.
class TonedProgram {
  public:
    /// Takes the arguments of ViewProgram.
    TonedProgram(gl::ShaderLibrary& shaders, const std::string& vertex, const std::string& fragment,
                 const gl::Defines& defines = {})
        : light_(shaders, vertex, fragment, defines), shown_(shaders, vertex, fragment, encoding(defines)) {}

    void load(ViewSubmission submission) {
        light_.load(submission);
        shown_.load(submission);
    }

    /// Makes the variant for `target` and these views current and returns it.
    const gl::Program& use(const RenderTarget& target, const ViewBatch& views) const {
        return (target.encodesSrgb ? light_ : shown_).use(views);
    }

  private:
    static gl::Defines encoding(gl::Defines defines) {
        defines["ENCODE_SRGB"] = "1";
        return defines;
    }

    ViewProgram light_;
    ViewProgram shown_;
};

} // namespace meltpool
