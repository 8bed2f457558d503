// The uniform block of a frame from what a person chose and what there is to see.
#pragma once

#include "core/render/look/look.hpp"
#include "core/render/scene.hpp"
#include "core/render/view/view.hpp"
#include "shaders/shared/render.h"

namespace meltpool {

/// Everything but the views.
FrameData makeFrame(const SceneView& scene, const LookParameters& look);

/// `viewport`: the pixels of this view alone.
ViewData makeViewData(const View& view, const Viewport& viewport);

} // namespace meltpool
