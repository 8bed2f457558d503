// The settings file: named sections of parameters as TOML in the user's configuration folder.
#pragma once

#include "core/base/parameter.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <utility>
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

/// Values of sections as text, by section and key.
using SettingsValues = std::map<std::pair<std::string, std::string>, std::string>;
SettingsValues valuesOf(const std::vector<SettingsSection>& sections);

/// Text of the file, every value with its label, unit and range as a comment.
std::string settingsText(const std::vector<SettingsSection>& sections);

/// Throws InputError or RuntimeFault if saveSettings() would; creates the folder. Returns a sentence for the person if
/// the folder has no locks, so that two programs that save at one moment may lose values; otherwise an empty string.
std::string requireSavableSettings(const std::filesystem::path& file);

/// Writes the file atomically and creates its folder. Values equal to those in `before`, taken at the start, stay as
/// the file has them: another program may have changed them since. Returns sentences as loadSettings() does, for faults
/// that came into the file since. Throws InputError or RuntimeFault when writing fails.
std::vector<std::string> saveSettings(const std::filesystem::path& file, const std::vector<SettingsSection>& sections,
                                      const SettingsValues& before = {});

} // namespace meltpool
