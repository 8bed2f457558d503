// Shows a file to the person with the program that their desktop has for it.
#pragma once

#include <filesystem>

namespace meltpool {

/// Starts `xdg-open` on the file. Returns false if there is no desktop or no such program; it is unknown if the file is
/// really shown. Never waits and never throws for failures.
bool openForPerson(const std::filesystem::path& file);

} // namespace meltpool
