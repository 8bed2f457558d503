// Draws the left eye's view in the desk's window: its picture, and the flat pictures that the runtime lays over it.
#pragma once

#include "core/gl/program.hpp"
#include "xr/headset.hpp"

#include <array>

namespace meltpool {

class Mirror {
  public:
    /// Begins a frame without flat pictures.
    void forgetFlat() { count_ = 0; }
    /// Adds a flat picture that this frame shows at `pose` of the session's space, behind the one before: the runtime
    /// lays the notice over the panel. `width`: m. `picture` must live until draw().
    void addFlat(const xr::Panel& picture, const xr::Pose& pose, float width);
    /// Fills the window's frame buffer with the middle of the left eye's view, in the window's shape. Throws InputError
    /// if the shaders cannot be used.
    void draw(const xr::Headset& headset, glm::ivec2 pixels, gl::ShaderLibrary& shaders);

  private:
    struct Flat {
        const xr::Panel* picture = nullptr;
        xr::Pose pose;
        float width = 0; ///< m
    };

    void drawFlat(const xr::Headset& headset) const;

    std::array<Flat, 2> flat_; ///< notice and panel
    size_t count_ = 0;
    const gl::Program* program_ = nullptr; ///< loaded by the first draw()
    gl::VertexArray empty_{"mirror"};
};

} // namespace meltpool
