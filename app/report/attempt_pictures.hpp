// Pictures of a lesson's metal by the looks that the lesson names, for runs and for pages of attempts.
#pragma once

#include "core/base/image.hpp"
#include "core/render/picture_target.hpp"
#include "core/render/renderer.hpp"
#include "core/training/trainer/lesson_scene.hpp"

#include <functional>

namespace meltpool {

/// Draws the metal as it is, with the surface of the last updateSurface(), into `target` and reads it. Waits for the
/// GPU. `adorn`, where there is one, adds to the scene what is seen from this view.
Image takePicture(Renderer& renderer, const PictureTarget& target, LessonScene& shown, const PictureLook& picture,
                  const std::function<void(SceneView&, const View&)>& adorn = {});

} // namespace meltpool
