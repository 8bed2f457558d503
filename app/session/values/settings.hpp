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
/// fault. A file that cannot be read or is not TOML is renamed to settings.broken-N.toml; one with unknown keys or
/// values out of range is copied to that name and its valid values are used. Never throws for the contents of the file.
std::vector<std::string> loadSettings(const std::filesystem::path& file, const std::vector<SettingsSection>& sections);

/// The file's text, every value with its label, unit and range as a comment.
std::string settingsText(const std::vector<SettingsSection>& sections);

/// Throws InputError or RuntimeFault where saveSettings() would; makes the folder.
void requireSavableSettings(const std::filesystem::path& file);

/// Writes the file atomically, making its folder. Throws InputError or RuntimeFault when that fails.
void saveSettings(const std::filesystem::path& file, const std::vector<SettingsSection>& sections);

} // namespace meltpool
