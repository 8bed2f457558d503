// The settings file: named sections of parameters as TOML in the user's configuration folder.
#pragma once

#include "core/base/parameter.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace meltpool {

/// A table of the file and the values it fills.
struct SettingsSection {
    std::string name;
    ParameterList parameters;
};

/// Reads `file` into `sections` and returns one sentence with file and line for each fault in it. A missing file is no
/// fault. A file that is not TOML, or has unknown keys or values out of range, is kept as settings.broken-N.toml beside
/// it; its valid values are still used. Never throws for the contents of the file.
std::vector<std::string> loadSettings(const std::filesystem::path& file, const std::vector<SettingsSection>& sections);

/// The file's text, every value with its label, unit and range as a comment.
std::string settingsText(const std::vector<SettingsSection>& sections);

/// Writes the file atomically, making its folder. Throws InputError when that fails.
void saveSettings(const std::filesystem::path& file, const std::vector<SettingsSection>& sections);

} // namespace meltpool
