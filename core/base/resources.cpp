#include "core/base/resources.hpp"

#include "core/base/environment.hpp"
#include "core/base/error.hpp"

namespace meltpool {

std::filesystem::path resourceFolder() {
    const std::string chosen = environmentVariable("MELTPOOL_DATA");
    const std::filesystem::path folder = chosen.empty() ? filesOfProgram() : std::filesystem::path(chosen);
    if (!std::filesystem::is_directory(folder / "shaders"))
        throw InputError(folder, 0,
                         "the program's own files are not here; expected the folders shaders and data "
                         "(set MELTPOOL_DATA to the folder that holds them)");
    return folder;
}

std::filesystem::path settingsFolder() {
    return userSettings() / "meltpool";
}

std::filesystem::path keptFolder() {
    return userFiles() / "meltpool";
}

std::filesystem::path ownFilesFolder() {
    return userDocuments() / "meltpool";
}

std::filesystem::path cacheFolder() {
    const std::filesystem::path folder = userCache();
    return folder.empty() ? folder : folder / "meltpool";
}

} // namespace meltpool
