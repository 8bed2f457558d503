// Painter of strokes in the plane of a section.
#pragma once

#include "core/gl/buffer.hpp"
#include "core/gl/texture.hpp"
#include "core/render/toned_program.hpp"
#include "shaders/shared/render.h"

#include <span>

namespace meltpool {

class StrokePainter {
  public:
    explicit StrokePainter(gl::ShaderLibrary& shaders);

    /// Copies the strokes to the GPU for the draws to come.
    void upload(std::span<const SectionStroke> strokes);

    /// Loads the program's form for one way of submission. Throws InputError when the driver does not compile it.
    void load(ViewSubmission submission) { program_.load(submission); }

    /// Draws the strokes of the last upload() in the plane `at` along x (model units), blended over the picture.
    /// Expects the frame's uniform blocks bound and blending on.
    void draw(float at, const ViewBatch& views, const RenderTarget& target) const;

  private:
    TonedProgram program_;
    gl::VertexArray empty_;
    gl::Buffer strokes_;
    size_t count_ = 0;
};

} // namespace meltpool
