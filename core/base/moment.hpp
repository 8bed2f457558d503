// UTC times as text that sorts in time order, whatever the zone in which they were written.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace meltpool {

/// A time since 1970 in UTC, ms.
using Moment = std::chrono::sys_time<std::chrono::milliseconds>;

Moment momentNow();

/// The text of a time: "2026-11-23T07:10:43.125Z".
std::string utcText(Moment moment);

/// A time as text in whole seconds: "2026-11-23T07:10:43Z".
std::string utcSecond(Moment moment);

/// The time of a date with a UTC offset, such as "2026-11-23T08:10:43+0100" or the result of utcText(); nothing for any
/// other text, or for a date without an offset.
std::optional<Moment> parseMoment(std::string_view text);

/// The time of a file's last change; nothing if the file does not exist.
std::optional<Moment> writtenAt(const std::filesystem::path& file);

} // namespace meltpool
