#include "core/training/result_file.hpp"

#include "core/base/text.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>

namespace meltpool {

namespace {

using Json = nlohmann::ordered_json;

/// JSON has no number for what is not finite.
Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

/// A float as the shortest decimal that reads back to it, not as the long double that it converts to.
Json shortNumber(float value) {
    return number(parseDouble(formatNumber(value)).value_or(NAN));
}

/// 64 bits as text: JSON readers keep only 53 of a number.
std::string hexadecimal(std::uint64_t value) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(value));
    return text;
}

Json valueOf(const Parameter& p) {
    if (!p.choices.empty()) return parameterText(p);
    if (const auto* number = std::get_if<float*>(&p.value)) return shortNumber(**number);
    if (const auto* whole = std::get_if<int*>(&p.value)) return **whole;
    if (const auto* flag = std::get_if<bool*>(&p.value)) return **flag;
    if (const auto* v = std::get_if<glm::vec3*>(&p.value))
        return {shortNumber((*v)->x), shortNumber((*v)->y), shortNumber((*v)->z)};
    return parameterText(p);
}

/// Heights and depths are from the workpiece's origin.
Json zoneOf(const SectionZone& zone) {
    return {{"width_mm", number(zone.width * 1e3)},
            {"height_mm", number(zone.height * 1e3)},
            {"depth_mm", number(zone.depth * 1e3)},
            {"area_mm2", number(zone.area * 1e6)}};
}

Json sectionOf(const SectionFigures& section) {
    Json json;
    json["at_mm"] = number(section.at * 1e3);
    json["fusion"] = zoneOf(section.fusion);
    if (section.heatAffected) json["heat_affected"] = zoneOf(*section.heatAffected);
    return json;
}

} // namespace

void writeResult(const std::filesystem::path& file, Lesson& lesson, const LessonResult& result,
                 const ResultContext& context) {
    Json json;
    json["lesson"] = lesson.key;
    if (!context.error.empty()) json["error"] = context.error;
    json["renderer"] = context.renderer;
    json["seconds"] = number(result.seconds);
    json["steps"] = result.steps;
    json["particles"] = result.metal.particles;
    json["min_temperature"] = number(result.metal.minTemperature);
    json["mean_temperature"] = number(result.metal.meanTemperature);
    json["max_temperature"] = number(result.metal.maxTemperature);
    json["molten"] = result.metal.molten;
    json["lost"] = result.metal.lost;
    json["non_finite"] = result.metal.nonFinite;
    if (context.section) json["section"] = sectionOf(*context.section);
    json["state_hash"] = hexadecimal(result.stateHash);
    json["wall_seconds"] = number(context.wallSeconds);
    json["metal_bytes"] = result.metalBytes;
    json["surface_bytes"] = result.surfaceBytes;
    json["torch"] = lesson.torchFile.filename().string();
    json["version"] = context.version;
    json["commit"] = context.commit;
    Json& parameters = json["parameters"];
    for (const Parameter& parameter : lesson.parameters())
        parameters[std::string(parameter.key)] = valueOf(parameter);
    writeTextFileAtomically(file, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

} // namespace meltpool
