#include "app/report/report_page.hpp"

#include "app/report/curve_drawing.hpp"
#include "core/base/text.hpp"
#include "core/training/technique/quantity.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace meltpool {

namespace {

using nlohmann::json;

constexpr double kInch = 25.4; // mm

constexpr const char* kStyle = R"(
@page { size: A4; margin: 14mm }
body { font: 10pt/1.35 sans-serif; color: #1c1f24; max-width: 190mm; margin: 8mm auto; padding: 0 4mm }
h1 { font-size: 17pt; margin: 0 } h2 { font-size: 12pt; margin: 6mm 0 2mm }
table { border-collapse: collapse; width: 100% } td, th { padding: 0.6mm 2mm; text-align: left; border-bottom: 1px solid #dde1e6 }
td.n { text-align: right; white-space: nowrap } .quiet { color: #5b6470 } .score { font-size: 30pt; font-weight: bold }
.pass { color: #17692f } .fail { color: #b3261e; font-weight: bold } .not_resolved, .estimated { color: #6a5200 }
svg { width: 100%; height: auto; display: block } svg text { font: 9px sans-serif; fill: #3a424c }
.outer { fill: #f2efe2 } .inner { fill: #d9ead9 } .ideal { stroke: #2f7d4a; stroke-dasharray: 5 4 }
.axis { stroke: #8a929c } .curve { fill: none; stroke: #1f5fbf; stroke-width: 1.4 }
.seam { fill: #c3c8ce } .seam-fail { stroke: #b3261e; stroke-width: 2 } .seam-other { stroke: #8a6d00; stroke-width: 2 }
img { max-width: 49%; vertical-align: top } .turn { break-before: page }
input[name=unit] { accent-color: #1f5fbf } .in { display: none }
#inch:checked ~ main .in { display: inline } #inch:checked ~ main .mm { display: none }
@media print { input, label { display: none } }
)";

std::string rounded(double value, int decimals) {
    char text[48];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

std::optional<double> numberIn(const json& object, const char* key) {
    if (!object.is_object()) return std::nullopt;
    const auto found = object.find(key);
    return found != object.end() && found->is_number() ? std::optional(found->get<double>()) : std::nullopt;
}

std::string rawIn(const json& object, const char* key) {
    if (!object.is_object()) return {};
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::string textIn(const json& object, const char* key) {
    return escaped(rawIn(object, key));
}

/// Lengths, areas and speeds in both systems, of which the page shows one; others as they are.
std::string measure(std::optional<double> value, const std::string& unit) {
    if (!value) return "\xE2\x80\x93";
    const auto both = [&](double inches, const char* inchUnit, int decimals) {
        return "<span class=\"mm\">" + rounded(*value, 2) + " " + escaped(unit) + "</span><span class=\"in\">" +
               rounded(inches, decimals) + " " + inchUnit + "</span>";
    };
    if (unit == "mm") return both(*value / kInch, "in", 3);
    if (unit == "mm2") return both(*value / (kInch * kInch), "in\xC2\xB2", 4);
    if (unit == "mm/s") return both(*value / kInch * 60, "in/min", 1);
    if (unit == "kJ/mm") return both(*value * kInch, "kJ/in", 1);
    return rounded(*value, 2) + " " + escaped(unit == "deg" ? "\xC2\xB0" : unit);
}

std::string row(const std::string& name, const std::string& value) {
    return "<tr><td>" + name + "</td><td class=\"n\">" + value + "</td></tr>\n";
}

/// "toe_width_mm" as "toe width" and its unit.
struct Figure {
    std::string words, unit;
};

Figure figureOf(const std::string& key) {
    // The longest ending first.
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kEndings{
        {{"_kj_mm", "kJ/mm"}, {"_mm2", "mm2"}, {"_mm", "mm"}, {"_deg", "deg"}, {"_percent", "%"}, {"_s", "s"}}};
    Figure figure{key, ""};
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

std::string scorePart(const json& result) {
    if (!result.contains("score"))
        return "<p class=\"quiet\">This lesson asks for no technique: there is no score.</p>\n";
    const json& score = result["score"];
    std::string html;
    if (const auto total = numberIn(score, "total"))
        html += "<p><span class=\"score\">" + rounded(*total, 0) + "</span> of 100 points of technique</p>\n";
    else
        html += "<p class=\"fail\">Not scored: " + textIn(score, "reason") + "</p>\n";
    if (!score.contains("corrections") || score["corrections"].empty()) return html;
    html += "<h2>What to correct first</h2>\n<ol>\n";
    for (const json& sentence : score["corrections"])
        if (sentence.is_string()) html += "<li>" + escaped(sentence.get<std::string>()) + "</li>\n";
    return html + "</ol>\n";
}

/// The quantity of a key of result.json, whichever kind of distance the process has; null for none.
const QuantityInfo* quantityOf(const std::string& key) {
    for (const DistanceKind kind : {DistanceKind::ctwd, DistanceKind::arcLength})
        for (const QuantityInfo& info : quantities(kind))
            if (!info.key.empty() && info.key == key) return &info;
    return nullptr;
}

std::string techniquePart(const RunResults& results) {
    if (!results.result.contains("score")) return {};
    const json& score = results.result["score"];
    if (!score.contains("values") || !score["values"].is_object()) return {};
    std::string table = "<table><tr><th>technique</th><th>points</th><th>mean</th><th>asked for</th></tr>\n", curves;
    for (const auto& [key, value] : score["values"].items()) {
        const QuantityInfo* info = quantityOf(key);
        if (info == nullptr) continue;
        const std::string unit(info->unit);
        const json points = score.contains("parameters") ? score["parameters"] : json::object();
        const auto ideal = numberIn(value, "ideal"), inner = numberIn(value, "inner"), outer = numberIn(value, "outer");
        table += "<tr><td>" + escaped(std::string(info->words)) + "</td><td class=\"n\">" +
                 measure(numberIn(points, key.c_str()), "") + "</td><td class=\"n\">" +
                 measure(numberIn(value, "mean"), unit) + "</td><td class=\"n\">" + measure(ideal, unit) +
                 " \xC2\xB1 " + measure(inner, unit) + "</td></tr>\n";
        Curve curve{std::string(info->words), unit, results.technique.column("place_mm"),
                    results.technique.column(info->column), std::nullopt};
        if (ideal && inner && outer) curve.band = CurveBand{*ideal, *inner, *outer};
        curves += curveDrawing(curve);
    }
    return "<h2>The hand</h2>\n" + table + "</table>\n" + curves +
           "<p class=\"quiet\">Dashed: what the lesson asks for. Green: full points. Outside the pale strip: "
           "none.</p>\n";
}

/// Where on the seam the verdict's items have their worst place.
std::string seamStrip(const RunResults& results, const json& items) {
    const std::vector<double> places = results.weld.column("place_mm");
    if (places.size() < 2) return {};
    const double from = places.front(), to = places.back();
    constexpr double kLeft = 20, kWidth = 600;
    const auto x = [&](double place) { return rounded(kLeft + (place - from) / (to - from) * kWidth, 1); };
    std::string svg = "<svg viewBox=\"0 0 640 64\" role=\"img\" aria-label=\"the seam with its imperfections\"><rect "
                      "class=\"seam\" x=\"20\" y=\"26\" width=\"600\" height=\"12\" rx=\"3\"/>";
    int number = 0, high = 0;
    for (const json& item : items) {
        ++number;
        const auto place = numberIn(item, "at_mm");
        const std::string state = textIn(item, "state");
        if (!place || state == "pass" || *place < from || *place > to) continue;
        svg += "<line class=\"" + std::string(state == "fail" ? "seam-fail" : "seam-other") + "\" x1=\"" + x(*place) +
               "\" x2=\"" + x(*place) + "\" y1=\"20\" y2=\"44\"/><text text-anchor=\"middle\" x=\"" + x(*place) +
               "\" y=\"" + (high++ % 2 == 0 ? "15" : "55") + "\">" + std::to_string(number) + "</text>";
    }
    svg += "<text x=\"20\" y=\"62\">" + rounded(from, 0) + " mm</text><text text-anchor=\"end\" x=\"620\" y=\"62\">" +
           rounded(to, 0) + " mm</text>";
    return svg + "</svg>\n";
}

std::string verdictPart(const RunResults& results) {
    if (!results.result.contains("verdict")) return {};
    const json& verdict = results.result["verdict"];
    const bool accepted = verdict.contains("accepted") && verdict["accepted"] == true;
    std::string html = "<h2>The weld by " + textIn(verdict, "standard") + " " + textIn(verdict, "level") + " (" +
                       textIn(verdict, "edition") + "): <span class=\"" +
                       (accepted ? "pass\">accepted" : "fail\">not accepted") + "</span></h2>\n";
    const json items = verdict.contains("items") && verdict["items"].is_array() ? verdict["items"] : json::array();
    html += seamStrip(results, items);
    html += "<table><tr><th>no.</th><th>imperfection</th><th>value</th><th>limit</th><th></th></tr>\n";
    int number = 0;
    for (const json& item : items) {
        const std::string state = textIn(item, "state"), unit = textIn(item, "unit");
        const Figure name = figureOf(rawIn(item, "name")), words = figureOf(rawIn(item, "state"));
        html += "<tr><td>" + std::to_string(++number) + "</td><td>" + name.words + "</td><td class=\"n\">" +
                measure(numberIn(item, "value"), unit) + "</td><td class=\"n\">" +
                measure(numberIn(item, "limit"), unit) + "</td><td class=\"" + state + "\">" + words.words +
                "</td></tr>\n";
    }
    return html + "</table>\n<p class=\"quiet\">Not resolved: finer than the particles, or nothing that the metal "
                  "contains. Estimated: from the technique. Neither passes nor fails.</p>\n";
}

std::string weldPart(const json& result) {
    std::string rows;
    for (const char* part : {"weld", "arc"}) {
        if (!result.contains(part) || !result[part].is_object()) continue;
        for (const auto& [key, value] : result[part].items()) {
            if (!value.is_number() || key == "stations") continue;
            if (key == "mean_current_a") {
                rows += row("mean current", rounded(value, 0) + " A");
            } else if (key == "mean_voltage_v") {
                rows += row("mean voltage", rounded(value, 1) + " V");
            } else if (key == "energy_kj") {
                rows += row("energy of the arc", rounded(value, 1) + " kJ");
            } else if (key == "seconds") {
                rows += row("time of the arc", rounded(value, 1) + " s");
            } else if (key == "efficiency_en_1011_1") {
                rows += row("efficiency by EN 1011-1", rounded(value, 1));
            } else {
                const Figure figure = figureOf(key);
                rows += row(figure.words, measure(value.get<double>(), figure.unit));
            }
        }
    }
    return rows.empty() ? std::string() : "<h2>The weld in figures</h2>\n<table>\n" + rows + "</table>\n";
}

std::string picturesPart(const RunResults& results) {
    std::string html;
    for (const std::filesystem::path& picture : results.pictures)
        html += "<img alt=\"" + escaped(picture.stem().string()) + "\" src=\"data:image/png;base64," +
                base64(readTextFile(picture)) + "\">\n";
    return html;
}

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

std::string reportPage(const RunResults& results) {
    const json& result = results.result;
    const std::string lesson = textIn(result, "lesson");
    std::string html = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>" + lesson +
                       " \xE2\x80\x93 Meltpool</title>\n<style>" + kStyle + "</style>\n</head>\n<body>\n";
    html += "<input type=\"radio\" name=\"unit\" id=\"metric\" checked><label for=\"metric\">mm</label>\n"
            "<input type=\"radio\" name=\"unit\" id=\"inch\"><label for=\"inch\">inch</label>\n<main>\n";
    html += "<h1>" + lesson + "</h1>\n<p class=\"quiet\">" + textIn(result, "torch") + " \xC2\xB7 " +
            measure(numberIn(result, "seconds"), "s") + " \xC2\xB7 Meltpool " + textIn(result, "version") + " " +
            textIn(result, "commit") + " \xC2\xB7 " + textIn(result, "renderer") + " \xC2\xB7 state " +
            textIn(result, "state_hash") + "</p>\n";
    html += scorePart(result) + picturesPart(results) + techniquePart(results);
    html += "<div class=\"turn\"></div>\n" + verdictPart(results) + weldPart(result);
    return html + "</main>\n</body>\n</html>\n";
}

} // namespace meltpool
