// The uniform block of a frame, from look parameters and scene.
#pragma once

#include "core/render/look/look.hpp"
#include "core/render/scene.hpp"
#include "core/render/view.hpp"
#include "shaders/shared/render.h"

namespace meltpool {

/// Fills in everything except the views.
FrameData makeFrame(const SceneView& scene, const LookParameters& look);

/// Makes the data of one view, to which nothing hides the arc. `viewport`: the pixels of this view only.
ViewData makeViewData(const View& view, const Viewport& viewport);

} // namespace meltpool
