// Pictures of the window as PNG files named by the time.
#pragma once

#include "core/base/image.hpp"

#include <glm/vec2.hpp>

#include <filesystem>

namespace meltpool {

/// The user's folder for pictures ($XDG_PICTURES_DIR, the one in user-dirs.dirs, ~/Pictures), or the current folder
/// where the user has no home.
std::filesystem::path picturesFolder();

/// A name in `folder` made of the local time that no file has yet, such as meltpool-2031-05-04-13.45.10.png.
std::filesystem::path pictureName(const std::filesystem::path& folder);

/// Saves the picture under such a name there, making the folder where it is missing. Throws as saveScreenshot().
std::filesystem::path savePicture(const Image& image);

/// Saves what has been drawn into the window (not yet swapped), `pixels` large. Waits for the GPU. Throws what
/// writeFile() throws; no part of a picture is left then.
std::filesystem::path saveScreenshot(glm::ivec2 pixels);

} // namespace meltpool
