// Saves pictures of the window as PNG files named by the time.
#pragma once

#include "core/base/image.hpp"

#include <glm/vec2.hpp>

#include <filesystem>

namespace meltpool {

/// Returns the user's folder for pictures ($XDG_PICTURES_DIR, the one in user-dirs.dirs, ~/Pictures), or the current
/// folder if the user has no home.
std::filesystem::path picturesFolder();

/// Returns an unused name in `folder`, made of the local time, such as meltpool-2031-05-04-13.45.10.png.
std::filesystem::path pictureName(const std::filesystem::path& folder);

/// Saves the picture under such a name in picturesFolder(), which it makes if missing. Throws as saveScreenshot().
std::filesystem::path savePicture(const Image& image);

/// Saves the window's drawn picture (not yet swapped), `pixels` large. Waits for the GPU. Throws what writeFile()
/// throws and leaves no part of a picture then.
std::filesystem::path saveScreenshot(glm::ivec2 pixels);

} // namespace meltpool
