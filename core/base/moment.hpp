// Moments of the world's clock as text, which keep their order wherever and whenever they were written.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace meltpool {

/// To the millisecond, since 1970 in UTC.
using Moment = std::chrono::sys_time<std::chrono::milliseconds>;

Moment momentNow();

/// "2026-11-23T07:10:43.125Z"
std::string utcText(Moment moment);

/// The moment of a date with its distance from UTC, such as "2026-11-23T08:10:43+0100" and what utcText() makes;
/// nothing for any other text, and for a date without that distance.
std::optional<Moment> parseMoment(std::string_view text);

/// When a file was last written; nothing where it is not there.
std::optional<Moment> writtenAt(const std::filesystem::path& file);

} // namespace meltpool
