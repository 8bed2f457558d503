// The sky behind a camera that does not move: drawn once, then copied.
#pragma once

#include "core/gl/texture.hpp"
#include "core/render/view.hpp"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <optional>

namespace meltpool {

/// All variables that the colours of a picture's sky depend on, and their target.
struct SkyKey {
    glm::mat4 worldToEye{0.0f};
    glm::mat4 eyeToClip{0.0f};
    glm::vec3 exposure{0.0f};
    int width = 0; ///< pixels
    int height = 0;
    bool encodesSrgb = false; ///< the target, see RenderTarget
    GLuint framebuffer = 0;   ///< one framebuffer has as many samples as before
    GLuint program = 0;       ///< a reload of the shaders makes another

    bool operator==(const SkyKey&) const = default;
};

/// A copy of the sky: shading it is a fifth of a picture on a driver that draws on the processor; a copy is a fraction
/// of that. The copy has identical bits.
class KeptSky {
  public:
    /// Returns true if the sky of the coming picture can be copied. `draw` draws it into a target of its own when a
    /// camera does not move for its second picture: a moving camera costs nothing.
    template <typename Draw>
    bool prepare(const SkyKey& key, const RenderTarget& target, const Draw& draw) {
        const State state = look(key, target);
        if (state == State::due) draw(begin());
        return state != State::other;
    }

    /// Copies the sky over the target's whole viewport. Leaves GL_FRAMEBUFFER_SRGB off.
    void copyTo(const RenderTarget& target) const;

  private:
    enum class State { other, due, kept };
    struct Picture {
        Picture() : framebuffer("kept sky") {}
        gl::Texture colour;
        gl::Framebuffer framebuffer;
    };

    State look(const SkyKey& key, const RenderTarget& target);
    RenderTarget begin();

    SkyKey key_;
    std::optional<Picture> picture_; ///< picture of key_
};

} // namespace meltpool
