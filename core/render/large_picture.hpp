// Pictures of any size, drawn tile by tile with more pixels than they get.
#pragma once

#include "core/base/image.hpp"
#include "core/render/view.hpp"

#include <glm/vec2.hpp>

#include <functional>

namespace meltpool {

/// Returns a camera's view of a part of its picture. `size`: of the picture, pixels; `corner`: the part's lower left
/// one, in the picture or outside; `part`: the part's size.
View viewOfPart(const View& whole, glm::ivec2 size, glm::ivec2 corner, glm::ivec2 part);

/// Returns the largest size of this shape that fits into `most`, at least one pixel each way.
glm::ivec2 fitInto(glm::ivec2 shape, glm::ivec2 most);

/// Settings of a large picture. The defaults take 70 MB however large it is.
struct LargePicture {
    glm::ivec2 size{3840, 2160};
    int finer = 2;             ///< drawn pixels for each pixel, each way; their light is averaged
    int samples = 4;           ///< samples of a drawn pixel
    glm::ivec2 tile{960, 540}; ///< pixels that are drawn at a time
    /// Pixels around a tile that are drawn too and thrown away: particles drawn as points vanish with their middle.
    int margin = 0;
};

/// Draws the view by `draw`, which receives the view of each tile and the target for it. Waits for the GPU. Throws
/// RuntimeFault when the driver cannot draw a tile.
Image drawLargePicture(const LargePicture& wish, const View& view,
                       const std::function<void(const View&, const RenderTarget&)>& draw);

} // namespace meltpool
