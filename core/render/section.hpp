// A cut through the metal, shown as an etched macro-section: what was molten, what heat has changed, what is as before.
#pragma once

#include "core/gl/buffer.hpp"
#include "core/gl/texture.hpp"
#include "core/metal/state/particle_view.hpp"
#include "core/render/toned_program.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <optional>

namespace meltpool {

/// Where to cut and what is known about the inside.
struct SectionView {
    bool shown = false;
    glm::vec3 point{0.0f};        ///< on the plane, model units
    glm::vec3 normal{1.0f, 0, 0}; ///< what lies on this side is taken away
    /// One vec4 a particle, z = its highest temperature so far (K). Null: the present temperature stands for it.
    const gl::Buffer* heat = nullptr;
    float spacing = 0.037f; ///< distance of neighbouring particles, model units
};

/// Sizes of a zone of the section, model units.
struct SectionZone {
    double area = 0;
    double width = 0;  ///< along the plane's horizontal
    double height = 0; ///< highest point over the level asked for, at least 0
    double depth = 0;  ///< deepest point under it, at least 0
};

/// The plane's own axes: `across` is horizontal, `up` as near to +y as the plane allows.
struct SectionFrame {
    glm::vec3 across{1, 0, 0};
    glm::vec3 up{0, 1, 0};
    glm::vec2 low{0.0f};  ///< corner of the cut through the box, model units along the axes from the origin
    glm::vec2 size{0.0f}; ///< its size
};
SectionFrame sectionFrame(const SectionView& section, const glm::vec3& boxMin, const glm::vec3& boxMax);

class SectionPainter {
  public:
    explicit SectionPainter(gl::ShaderLibrary& shaders);

    /// Gathers the particles around the plane into a picture of it: their weight, peak and present temperature.
    void gather(const SectionView& section, const ParticleView& particles, const glm::vec3& boxMin,
                const glm::vec3& boxMax);

    /// Loads the program's form for one way of submission. Throws InputError when the driver does not compile it.
    void load(ViewSubmission submission) { draw_.load(submission); }

    /// Draws the cut with the frame's uniforms and state as they are.
    void draw(const SectionView& section, const ViewBatch& views, const RenderTarget& target) const;

    /// Sizes of the zone whose peak temperature reached `peak` (K), from the last gather(); `level` is the height of
    /// the plate's surface along the plane's up axis. Waits for the GPU.
    SectionZone measure(double peak, double level) const;

  private:
    struct Picture {
        gl::Texture sums; ///< weight, weight * peak, weight * temperature
        gl::Framebuffer framebuffer{"section"};
    };

    const gl::Program& gather_;
    TonedProgram draw_;
    gl::VertexArray layout_;
    gl::VertexArray empty_;
    std::optional<Picture> picture_;
    SectionFrame frame_;
};

} // namespace meltpool
