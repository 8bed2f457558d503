// Pictures of a lesson's metal by the looks that the lesson names, for runs and for pages of attempts.
#pragma once

#include "core/base/image.hpp"
#include "core/render/picture_target.hpp"
#include "core/render/renderer.hpp"
#include "core/training/trainer/lesson_scene.hpp"

#include <functional>

namespace meltpool {

/// Draws the metal in its present state, with the surface of the last updateSurface(), into `target` and reads it.
/// Waits for the GPU. `adorn`, if set, adds objects that this view sees to the scene.
Image takePicture(Renderer& renderer, const PictureTarget& target, LessonScene& shown, const PictureLook& picture,
                  const std::function<void(SceneView&, const View&)>& adorn = {});

} // namespace meltpool
