#include "core/base/moment.hpp"

#include "core/base/text.hpp"

#include <array>
#include <cstdio>
#include <system_error>

namespace meltpool {

namespace {

using namespace std::chrono;

/// The number of a text of digits, such as "08".
std::optional<int> digits(std::string_view text) {
    if (text.empty() || text.find_first_not_of("0123456789") != std::string_view::npos) return std::nullopt;
    const auto value = parseInteger(text);
    return value ? std::optional(static_cast<int>(*value)) : std::nullopt;
}

/// The offset of "Z", "+0100" or "-0330".
std::optional<minutes> parseZone(std::string_view zone) {
    if (zone == "Z") return minutes(0);
    if (zone.size() != 5 || (zone[0] != '+' && zone[0] != '-')) return std::nullopt;
    const auto hour = digits(zone.substr(1, 2)), minute = digits(zone.substr(3, 2));
    if (!hour || !minute || *hour > 14 || *minute > 59) return std::nullopt;
    const minutes offset(60 * *hour + *minute);
    return zone[0] == '-' ? -offset : offset;
}

} // namespace

Moment momentNow() {
    return time_point_cast<milliseconds>(system_clock::now());
}

std::string utcText(Moment moment) {
    const auto day = floor<days>(moment);
    const year_month_day date(day);
    const hh_mm_ss<milliseconds> time(moment - day);
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "%04d-%02u-%02uT%02d:%02d:%02d.%03dZ", static_cast<int>(date.year()),
                  static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                  static_cast<int>(time.hours().count()), static_cast<int>(time.minutes().count()),
                  static_cast<int>(time.seconds().count()), static_cast<int>(time.subseconds().count()));
    return text.data();
}

std::string utcSecond(Moment moment) {
    return utcText(moment).substr(0, std::string_view("2026-11-23T07:10:43").size()) + "Z";
}

std::optional<Moment> parseMoment(std::string_view text) {
    constexpr std::string_view kForm = "0000-00-00T00:00:00";
    if (text.size() <= kForm.size()) return std::nullopt;
    for (size_t i = 0; i < kForm.size(); ++i)
        if (kForm[i] == '0' ? text[i] < '0' || text[i] > '9' : text[i] != kForm[i]) return std::nullopt;
    const auto part = [text](size_t from, size_t count) { return *digits(text.substr(from, count)); };
    const year_month_day date(year(part(0, 4)), month(static_cast<unsigned>(part(5, 2))),
                              day(static_cast<unsigned>(part(8, 2))));
    const int hour = part(11, 2), minute = part(14, 2), second = part(17, 2);
    if (!date.ok() || hour > 23 || minute > 59 || second > 60) return std::nullopt;
    std::string_view rest = text.substr(kForm.size());
    milliseconds fraction(0);
    if (rest.front() == '.') {
        const auto value = digits(rest.substr(1, 3));
        if (!value || rest.size() < 5) return std::nullopt;
        fraction = milliseconds(*value);
        rest = rest.substr(4);
    }
    const auto zone = parseZone(rest);
    if (!zone) return std::nullopt;
    return sys_days(date) + hours(hour) + minutes(minute) + seconds(second) + fraction - *zone;
}

std::optional<Moment> writtenAt(const std::filesystem::path& file) {
    std::error_code missing;
    const auto written = std::filesystem::last_write_time(file, missing);
    if (missing) return std::nullopt;
    // Computed from the distance from now: the clock of files is not everywhere related to the system's.
    const auto ago = duration_cast<milliseconds>(std::filesystem::file_time_type::clock::now() - written);
    return momentNow() - ago;
}

} // namespace meltpool
