#include "app/desktop/screenshot.hpp"

#include "core/base/places.hpp"
#include "core/gl/texture.hpp"

#include <chrono>
#include <ctime>
#include <string>
#include <system_error>

namespace meltpool {

namespace fs = std::filesystem;

fs::path picturesFolder() {
    const fs::path folder = userPictures();
    return folder.empty() ? fs::current_path() : folder;
}

fs::path pictureName(const fs::path& folder) {
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    char text[64];
    std::strftime(text, sizeof text, "meltpool-%Y-%m-%d-%H.%M.%S", std::localtime(&now));
    fs::path name = folder / (std::string(text) + ".png");
    std::error_code unreadable;
    for (int i = 2; fs::exists(name, unreadable); ++i)
        name = folder / (std::string(text) + "-" + std::to_string(i) + ".png");
    return name;
}

fs::path saveScreenshot(glm::ivec2 pixels) {
    return savePicture(gl::readPixels(0, pixels.x, pixels.y));
}

fs::path savePicture(const Image& image) {
    const fs::path folder = picturesFolder();
    std::error_code failed; // writing the picture reports the failure
    fs::create_directories(folder, failed);
    const fs::path name = pictureName(folder);
    writePng(name, image);
    return name;
}

} // namespace meltpool
