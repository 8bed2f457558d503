// Painter of the workshop as geometry: near things shift against far ones, and the floor does not move.
#pragma once

#include "core/gl/texture.hpp"
#include "core/render/scene.hpp"
#include "core/render/toned_program.hpp"

#include <span>

namespace meltpool {

/// Returns true if the room can be drawn for these views: an eye outside its walls sees the sky instead.
bool insideRoom(const WorkshopView& room, std::span<const View> views);

class WorkshopPainter {
  public:
    explicit WorkshopPainter(gl::ShaderLibrary& shaders);

    /// Loads the program's form for one way of submission. Throws InputError when the driver does not compile it.
    void load(ViewSubmission submission) { program_.load(submission); }

    /// Draws the room. Expects the frame's uniform blocks and the environment bound, the frame's state set and no clip
    /// plane but those of the views. Geometry beyond a view's far plane is drawn at that plane.
    void draw(const WorkshopView& room, const ViewBatch& views, const RenderTarget& target) const;

  private:
    TonedProgram program_;
    gl::VertexArray empty_;
};

} // namespace meltpool
