// Painter of simple painted solids: the heat source, torches, tables, clamps; and of markers, which are signs rather
// than things.
#pragma once

#include "core/gl/buffer.hpp"
#include "core/gl/texture.hpp"
#include "core/render/measured_program.hpp"
#include "core/render/solid_meshes.hpp"

#include <array>
#include <span>
#include <vector>

namespace meltpool {

/// The shapes' meshes and the programs that draw them: all solids of one shape with one draw call.
class SolidPainter {
  public:
    explicit SolidPainter(gl::ShaderLibrary& shaders);

    /// Loads the programs' forms for one way of submission. Throws InputError when the driver does not compile it.
    void load(ViewSubmission submission) {
        program_.load(submission);
        standing_.load(submission);
        markers_.load(submission);
    }

    /// Prepares a frame; call it before the first draw. `measures`: see measuresOf().
    void prepare(unsigned measures) {
        program_.choose(measures);
        standing_.choose(measures);
    }

    /// Begins the solids of a frame; gather() adds to them, upload() copies them to the GPU for the draws to come.
    void begin();
    /// Adds solids. `standing`: on the table, where the workpiece shields them from lamp and room. `coarse`:
    /// replacements for finer ones too.
    void gather(std::span<const Solid> solids, bool standing = false, bool coarse = true);
    void upload();
    /// Draws them. Expects the frame's uniform blocks bound and its state set.
    void draw(const ViewBatch& views, const RenderTarget& target) const;

    /// Draws markers. Expects the state for draw() of solids, and blending by alpha. Later ones cover earlier ones.
    void draw(std::span<const Marker> markers, const ViewBatch& views, const RenderTarget& target) const;

  private:
    /// Data of one solid, as the vertex shader reads it.
    struct Instance {
        glm::mat4 toWorld;
        glm::vec4 paint; ///< colour, gloss
        glm::vec4 glow;
    };
    /// The solids of one shape, free ones before those on the table.
    struct Kind {
        std::vector<Instance> free, standing;
    };
    /// Copying into a buffer that an unfinished frame draws from waits for it: frames take turns.
    static constexpr size_t kFramesInFlight = 3;

    void drawKinds(const MeasuredProgram& program, bool standing, const ViewBatch& views,
                   const RenderTarget& target) const;

    MeasuredProgram program_, standing_;
    TonedProgram markers_;
    std::array<SolidMeshes::Range, kSolidShapes> shapes_;
    gl::Buffer vertices_;
    gl::Buffer indices_;
    gl::VertexArray layout_;
    std::array<Kind, kSolidShapes> kinds_;
    std::vector<Instance> all_;
    std::array<gl::Buffer, kFramesInFlight> instances_;
    size_t current_ = 0;
};

} // namespace meltpool
