// Simple painted solids: the heat source, torches, tables, clamps; and markers that are signs rather than things.
#pragma once

#include "core/gl/buffer.hpp"
#include "core/gl/texture.hpp"
#include "core/render/measured_program.hpp"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <span>

namespace meltpool {

/// All fit into the cube -0.5..0.5; the axis of cylinder and cone is z, the tip of the cone lies at -z.
enum class SolidShape { box, cylinder, cone, sphere };

struct Solid {
    SolidShape shape = SolidShape::box;
    glm::mat4 toWorld{1.0f};
    glm::vec3 colour{0.5f}; ///< linear sRGB reflectance
    float gloss = 0.2f;     ///< 0 dull .. 1 polished
    glm::vec3 glow{0.0f};   ///< emitted light
};

/// A solid that shows its own colour whatever light falls on it, also through the visor, and lets what is behind it
/// through.
struct Marker {
    SolidShape shape = SolidShape::box;
    glm::mat4 toWorld{1.0f};
    glm::vec3 colour{0.5f}; ///< linear sRGB, as displayed
    float opacity = 1;      ///< 0..1
    float face = 1;         ///< share of it where the surface faces the eye; below 1 the outline stands out
};

/// The transform of a solid that reaches from `from` to `to` with the given width; its -z end lies at `to`.
glm::mat4 alongLine(const glm::vec3& from, const glm::vec3& to, float width);

/// The shapes' meshes and the programs that draw them.
class SolidPainter {
  public:
    explicit SolidPainter(gl::ShaderLibrary& shaders);

    /// Loads the programs' forms for one way of submission. Throws InputError when the driver does not compile it.
    void load(ViewSubmission submission) {
        program_.load(submission);
        markers_.load(submission);
    }

    /// Call before the first draw of a frame. `measures`: see measuresOf().
    void prepare(unsigned measures) { program_.choose(measures); }

    /// Expects the frame's uniform blocks bound and its state set.
    void draw(std::span<const Solid> solids, const ViewBatch& views, const RenderTarget& target) const;
    /// The same; expects blending by alpha. Later ones cover earlier ones.
    void draw(std::span<const Marker> markers, const ViewBatch& views, const RenderTarget& target) const;

  private:
    struct Range {
        int first = 0;
        int count = 0;
    };

    MeasuredProgram program_;
    TonedProgram markers_;
    gl::Buffer vertices_;
    gl::VertexArray layout_;
    std::array<Range, 4> shapes_;
};

} // namespace meltpool
