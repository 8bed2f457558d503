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

/// Reads what `file` holds into `sections` and returns what has to be told to the person, one sentence each with file
/// and line. A missing file is no fault. A file that is no TOML, or holds unknown keys or values out of range, is set
/// aside beside itself (renamed or copied to settings.broken-N.toml); good values of it are still taken. Never throws
/// for what is in the file.
std::vector<std::string> loadSettings(const std::filesystem::path& file, const std::vector<SettingsSection>& sections);

/// The file's text, every value with its label, unit and range as a comment.
std::string settingsText(const std::vector<SettingsSection>& sections);

/// Writes the file atomically, making its folder. Throws InputError when that fails.
void saveSettings(const std::filesystem::path& file, const std::vector<SettingsSection>& sections);

} // namespace meltpool
