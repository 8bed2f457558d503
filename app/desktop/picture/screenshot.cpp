#include "app/desktop/picture/screenshot.hpp"

#include "core/gl/texture.hpp"

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <string>

namespace meltpool {

namespace fs = std::filesystem;

namespace {

fs::path folderNamedBy(const char* variable, const char* below) {
    const char* value = std::getenv(variable);
    if (value == nullptr || *value == '\0') return {};
    return fs::path(value) / below;
}

} // namespace

fs::path picturesFolder() {
    std::error_code unreadable;
    for (const fs::path& folder : {folderNamedBy("XDG_PICTURES_DIR", ""), folderNamedBy("HOME", "Pictures"),
                                   folderNamedBy("USERPROFILE", "Pictures")})
        if (!folder.empty() && fs::is_directory(folder, unreadable)) return folder;
    return fs::current_path();
}

fs::path pictureName(const fs::path& folder) {
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    char text[64];
    std::strftime(text, sizeof text, "meltpool-%Y-%m-%d-%H.%M.%S", std::localtime(&now));
    fs::path name = folder / (std::string(text) + ".png");
    for (int i = 2; fs::exists(name); ++i)
        name = folder / (std::string(text) + "-" + std::to_string(i) + ".png");
    return name;
}

fs::path saveScreenshot(glm::ivec2 pixels) {
    return savePicture(gl::readPixels(0, pixels.x, pixels.y));
}

fs::path savePicture(const Image& image) {
    const fs::path name = pictureName(picturesFolder());
    writePng(name, image);
    return name;
}

} // namespace meltpool
