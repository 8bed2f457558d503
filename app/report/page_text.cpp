#include "app/report/page_text.hpp"

#include "app/report/svg_text.hpp"
#include "core/base/units.hpp"
#include "core/base/words.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace meltpool {

namespace {

using nlohmann::json;

} // namespace

std::string base64(std::string_view bytes) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t three = 0;
        for (size_t k = 0; k < 3; ++k)
            three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (size_t k = 0; k < 4; ++k)
            text += i + k > bytes.size() ? '=' : kDigits[three >> (18 - 6 * k) & 63U];
    }
    return text;
}

std::optional<double> numberIn(const json& object, const char* key) {
    const json& found = partIn(object, key);
    return found.is_number() ? std::optional(found.get<double>()) : std::nullopt;
}

std::string rawIn(const json& object, const char* key) {
    const json& found = partIn(object, key);
    return found.is_string() ? found.get<std::string>() : std::string();
}

std::string textIn(const json& object, const char* key) {
    return escaped(rawIn(object, key));
}

const json& partIn(const json& object, const char* key) {
    static const json kNone;
    if (!object.is_object()) return kNone;
    const auto found = object.find(key);
    return found == object.end() ? kNone : *found;
}

std::string numberText(double value, int decimals, bool sign) {
    return std::string(PhraseNumber(value, decimals, sign));
}

std::string measure(std::optional<double> value, std::string_view unit) {
    if (!value || !std::isfinite(*value)) return kDash;
    if (const ShownUnit inch = inchUnit(unit); inch.converts())
        return "<span class=\"mm\">" + numberText(*value, 2) + " " +
               (unit == "mm2" ? "mm\xC2\xB2" : std::string(unit)) + "</span><span class=\"in\">" +
               numberText(*value * inch.perMetric, inch.mostDigits) + " " + std::string(inch.name) + "</span>";
    if (unit.empty()) return numberText(*value, 2);
    if (unit == "deg" || unit == "\xC2\xB0") return numberText(*value, 1) + "\xC2\xB0";
    return numberText(*value, 2) + " " + escaped(unit);
}

std::string unitName(std::string_view unit) {
    return "<span class=\"mm\">" + std::string(unit) + "</span><span class=\"in\">" + std::string(inchUnit(unit).name) +
           "</span>";
}

std::string unitSwitch() {
    const bool inches = chosenUnits() == UnitSystem::inches;
    const auto choice = [](const std::string& id, bool checked, const std::string& label) {
        return "<input type=\"radio\" name=\"unit\" id=\"" + id + "\"" + (checked ? " checked" : "") +
               "><label for=\"" + id + "\">" + label + "</label>\n";
    };
    return choice("metric", !inches, "mm") + choice("inch", inches, phrase("page.inch"));
}

NamedUnit namedUnit(const std::string& key) {
    // Longest ending first.
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 7> kEndings{{{"_kj_mm", "kJ/mm"},
                                                                                            {"_mm_s", "mm/s"},
                                                                                            {"_mm2", "mm2"},
                                                                                            {"_mm", "mm"},
                                                                                            {"_deg", "deg"},
                                                                                            {"_percent", "%"},
                                                                                            {"_s", "s"}}};
    NamedUnit figure{key, ""};
    for (const auto& [ending, unit] : kEndings)
        if (key.ends_with(ending)) {
            figure = {key.substr(0, key.size() - ending.size()), std::string(unit)};
            break;
        }
    for (char& c : figure.words)
        if (c == '_') c = ' ';
    figure.words = escaped(figure.words);
    return figure;
}

std::string tableRow(const std::string& name, const std::string& value) {
    return "<tr><td>" + name + "</td>" + numberCell(value) + "</tr>\n";
}

std::string headCells(std::initializer_list<std::string_view> keys) {
    std::string cells;
    for (const std::string_view key : keys)
        cells += "<th>" + phrase(key) + "</th>";
    return cells;
}

std::string numberCell(const std::string& value) {
    return "<td class=\"n\">" + value + "</td>";
}

} // namespace meltpool
