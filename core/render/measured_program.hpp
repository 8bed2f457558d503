// A drawing program in one variant for each set of measures that it knows.
#pragma once

#include "core/render/toned_program.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace meltpool {

/// A program whose shaders leave a measure out if its name is not defined. SYNCHRONOUS_DRIVER: a branch would cost as
/// much as the measure, as it computes both sides.
class MeasuredProgram {
  public:
    /// `measures`: the measures of the shaders, as bits of measuresOf(), each with the name that is defined for it.
    /// `always`: defined in each variant. Loads nothing yet.
    MeasuredProgram(gl::ShaderLibrary& shaders, std::string vertex, std::string fragment,
                    std::vector<std::pair<unsigned, std::string>> measures, gl::Defines always = {})
        : shaders_(shaders),
          vertex_(std::move(vertex)),
          fragment_(std::move(fragment)),
          measures_(std::move(measures)),
          always_(std::move(always)),
          variants_(size_t(1) << measures_.size()) {}

    /// Loads the form for this submission of every variant, present and future. Throws InputError when the driver does
    /// not compile one.
    void load(ViewSubmission submission) {
        submission_ = submission;
        for (const auto& variant : variants_)
            if (variant) variant->load(submission);
    }

    /// Takes the variant with these measures (see measuresOf()) for the draws to come; makes a missing one, which takes
    /// the driver some time.
    void choose(unsigned measures) {
        size_t index = 0;
        for (size_t i = 0; i < measures_.size(); ++i)
            if ((measures & measures_[i].first) != 0) index |= size_t(1) << i;
        chosen_ = variants_[index].get();
        if (chosen_ != nullptr) return;
        gl::Defines defines = always_;
        for (size_t i = 0; i < measures_.size(); ++i)
            if ((index >> i & 1) != 0) defines[measures_[i].second] = "1";
        variants_[index] = std::make_unique<TonedProgram>(shaders_, vertex_, fragment_, defines);
        chosen_ = variants_[index].get();
        chosen_->load(submission_);
    }

    /// Makes the chosen variant current and returns it.
    const gl::Program& use(const RenderTarget& target, const ViewBatch& views) const {
        return chosen_->use(target, views);
    }

  private:
    gl::ShaderLibrary& shaders_;
    std::string vertex_;
    std::string fragment_;
    std::vector<std::pair<unsigned, std::string>> measures_;
    gl::Defines always_;
    std::vector<std::unique_ptr<TonedProgram>> variants_;
    TonedProgram* chosen_ = nullptr;
    ViewSubmission submission_ = ViewSubmission::passes;
};

} // namespace meltpool
