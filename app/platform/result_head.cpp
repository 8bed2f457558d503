#include "app/platform/result_head.hpp"

#include "app/platform/program_info.hpp"
#include "core/base/error.hpp"
#include "core/base/moment.hpp"
#include "core/base/text.hpp"
#include "core/gl/software_driver/software_driver.hpp"

#include <nlohmann/json.hpp>

#include <cctype>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace meltpool {

namespace {

/// Programs that wanted a processor at a time over the last minute, this one among them; -1 if the system has no count.
double loadAverage() {
    double load = -1;
    std::ifstream("/proc/loadavg") >> load;
    return load;
}

/// Letters and digits in lower case and points; one "-" for anything between them.
std::string slug(std::string_view words) {
    std::string name;
    for (const char letter : words) {
        const auto code = static_cast<unsigned char>(letter);
        if (std::isalnum(code) != 0 || letter == '.')
            name += static_cast<char>(std::tolower(code));
        else if (!name.empty() && name.back() != '-')
            name += '-';
    }
    while (!name.empty() && name.back() == '-')
        name.pop_back();
    return name;
}

std::string textOf(const nlohmann::json& head, const char* key) {
    const auto found = head.find(key);
    return found != head.end() && found->is_string() ? found->get<std::string>() : std::string("unknown");
}

/// "4.5 (Core Profile) Mesa 22.3.6" as "Mesa 22.3.6": the profile is not the machine.
std::string driverName(const std::string& version) {
    const size_t profile = version.find(") ");
    return profile == std::string::npos ? version : version.substr(profile + 2);
}

} // namespace

std::string processorName() {
    std::ifstream stream("/proc/cpuinfo");
    for (std::string line; std::getline(stream, line);)
        if (line.starts_with("model name")) return std::string(trimText(line.substr(line.find(':') + 1)));
    return "unknown";
}

nlohmann::ordered_json resultHead(const gl::ContextInfo& driver) {
    nlohmann::ordered_json json;
    json["renderer"] = driver.renderer;
    json["driver"] = driver.version;
    json["processor"] = processorName();
    json["threads"] = std::thread::hardware_concurrency();
    json["driver_threads_spared"] = gl::driverIsSingleThreaded();
    if (const double load = loadAverage(); load >= 0) json["load_average"] = load;
    json["version"] = programVersion();
    json["commit"] = programCommit();
    json["date"] = utcSecond(momentNow());
    return json;
}

std::string machineOf(const nlohmann::json& head) {
    const auto threads = head.find("threads");
    const std::string count =
        threads != head.end() && threads->is_number_unsigned() ? threads->dump() + " threads" : std::string();
    return slug(textOf(head, "processor") + " " + count + " " + textOf(head, "renderer") + " " +
                driverName(textOf(head, "driver")));
}

std::filesystem::path ResultPlace::file(const gl::ContextInfo& driver, std::string_view name) const {
    if (!named.empty() || folder.empty()) return named;
    const nlohmann::json head = resultHead(driver);
    const std::filesystem::path place = folder / machineOf(head);
    std::error_code failed;
    std::filesystem::create_directories(place, failed);
    if (failed)
        throw RuntimeFault(place.string() + ": the folder cannot be made: " + failed.message() +
                           "; expected a folder that can be written");
    return place / (slug(textOf(head, "commit")) + "-" + slug(name) + ".json");
}

} // namespace meltpool
