// A cut through the metal, drawn as an etched macro-section: molten, heat-affected and unchanged metal.
#pragma once

#include "core/gl/texture.hpp"
#include "core/render/toned_program.hpp"
#include "core/weld/gauge/section_map.hpp"
#include "shaders/shared/render.h"

#include <span>

namespace meltpool {

/// A plane across the seam and the drawing on it.
struct SectionView {
    bool shown = false;
    /// Place of the plane along x, model units; the metal beyond it (+x) is taken away.
    float at = 0;
    const SectionMap* map = nullptr; ///< drawn on the plane, in model units; null or empty: the plane stays open
    std::span<const SectionStroke> strokes = {}; ///< measures, a little before the plane; model units
    float lift = 5e-5f;                          ///< distance of the strokes before it, model units
};

class SectionPainter {
  public:
    explicit SectionPainter(gl::ShaderLibrary& shaders);

    /// Copies the map to the GPU for the draws to come.
    void upload(const SectionView& section);

    /// Loads the program's form for one way of submission. Throws InputError when the driver does not compile it.
    void load(ViewSubmission submission) { draw_.load(submission); }

    /// Draws the map of the last upload() with the frame's uniforms and state as they are.
    void draw(const SectionView& section, const ViewBatch& views, const RenderTarget& target) const;

  private:
    TonedProgram draw_;
    gl::VertexArray empty_;
    gl::Texture sums_; ///< SectionMap::sums
};

} // namespace meltpool
