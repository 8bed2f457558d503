// Drawing programs in all their forms: for each way in which views are submitted, and for targets that encode sRGB by
// themselves and those that do not.
#pragma once

#include "core/gl/program.hpp"
#include "core/render/view/view.hpp"
#include "core/render/view/view_submission.hpp"

#include <array>
#include <string>

namespace meltpool {

/// A program whose vertex shader includes render/view.glsl.
class ViewProgram {
  public:
    /// Files relative to the shader folder. Loads the form for single views; throws InputError when it does not
    /// compile.
    ViewProgram(gl::ShaderLibrary& shaders, std::string vertex, std::string fragment, gl::Defines defines = {})
        : shaders_(shaders), vertex_(std::move(vertex)), fragment_(std::move(fragment)), defines_(std::move(defines)) {
        load(ViewSubmission::passes);
    }

    /// Loads the form for one way of submission. Throws InputError when the driver does not compile it.
    void load(ViewSubmission submission) {
        gl::Defines defines = defines_;
        if (submission == ViewSubmission::viewports) defines["VIEWS_BY_VIEWPORT"] = "1";
        if (submission == ViewSubmission::clipping) defines["VIEWS_BY_CLIPPING"] = "1";
        forms_[static_cast<size_t>(submission)] = &shaders_.load({vertex_, fragment_}, std::move(defines));
    }

    /// Makes the form for these views current and returns it.
    const gl::Program& use(const ViewBatch& views) const {
        const gl::Program& program = *forms_[static_cast<size_t>(views.submission)];
        program.use();
        program.set("firstView", views.first);
        return program;
    }

  private:
    gl::ShaderLibrary& shaders_;
    std::string vertex_;
    std::string fragment_;
    gl::Defines defines_;
    std::array<const gl::Program*, kViewSubmissions.size()> forms_{};
};

class TonedProgram {
  public:
    /// As ViewProgram.
    TonedProgram(gl::ShaderLibrary& shaders, const std::string& vertex, const std::string& fragment)
        : light_(shaders, vertex, fragment), shown_(shaders, vertex, fragment, {{"ENCODE_SRGB", "1"}}) {}

    void load(ViewSubmission submission) {
        light_.load(submission);
        shown_.load(submission);
    }

    /// Makes the form for `target` and these views current and returns it.
    const gl::Program& use(const RenderTarget& target, const ViewBatch& views) const {
        return (target.encodesSrgb ? light_ : shown_).use(views);
    }

  private:
    ViewProgram light_;
    ViewProgram shown_;
};

} // namespace meltpool
