// Shows a file to the person with the program that their desktop has for it.
#pragma once

#include <filesystem>

namespace meltpool {

/// Starts `xdg-open` on the file. False where there is no desktop or no such program; whether something was shown
/// nobody knows. Never waits and never throws for what fails.
bool openForPerson(const std::filesystem::path& file);

} // namespace meltpool
