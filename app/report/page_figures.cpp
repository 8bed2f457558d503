// The part of the page with the measured weld and the arc in figures, in the order in which an inspector writes them.
#include "app/report/page_parts.hpp"
#include "app/report/page_text.hpp"
#include "app/report/svg_text.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

namespace meltpool {

namespace {

using nlohmann::json;

/// An entry of `weld` or `arc` in result.json, and its words on the page.
struct Figure {
    std::string_view key, words, unit;
    int decimals = -1; ///< -1: as many as its unit has
};

constexpr std::array kWeldFigures{
    Figure{"toe_width_mm", "width, toe to toe", "mm"},
    Figure{"fused_width_mm", "fused width", "mm"},
    Figure{"height_mm", "reinforcement", "mm"},
    Figure{"leg1_mm", "leg on the lying plate", "mm"},
    Figure{"leg2_mm", "leg on the standing plate", "mm"},
    Figure{"throat_mm", "throat", "mm"},
    Figure{"convexity_mm", "convexity", "mm"},
    Figure{"penetration_mm", "penetration", "mm"},
    Figure{"root_fused_percent", "root fused", "%", 0},
    Figure{"root_fusion_mm", "root fused beyond the corner by", "mm"},
    Figure{"root_missing_mm", "root missing (below 0: fused beyond)", "mm"},
    Figure{"root_width_mm", "root's breadth", "mm"},
    Figure{"root_concavity_mm", "root concavity", "mm"},
    Figure{"faces_fused_percent", "faces fused", "%", 0},
    Figure{"lack_of_fusion_mm", "lack of fusion (below 0: fused beyond)", "mm"},
    Figure{"edge_angle_1_deg", "edge angle, side 1", "deg"},
    Figure{"edge_angle_2_deg", "edge angle, side 2", "deg"},
    Figure{"overlap_1_mm", "overlap, side 1 (below 0: none)", "mm"},
    Figure{"overlap_2_mm", "overlap, side 2 (below 0: none)", "mm"},
    Figure{"undercut_1_mm", "undercut, side 1", "mm"},
    Figure{"undercut_2_mm", "undercut, side 2", "mm"},
    Figure{"underfill_mm", "underfill", "mm"},
    Figure{"excess_penetration_mm", "excess penetration", "mm"},
    Figure{"hole_mm", "burn-through", "mm"},
    Figure{"deposited_mm2", "section of deposited metal", "mm2"},
    Figure{"middle_mm", "middle of the weld beside the seam", "mm"},
    Figure{"straightness_mm", "distance from a straight line", "mm"},
    Figure{"haz_width_mm", "heat-affected zone", "mm"},
    Figure{"t85_s",
           "cooling from 800 to 500 \xC2\xB0"
           "C",
           "s"},
    Figure{"stations", "sections measured", "", 0},
    Figure{"pitch_mm", "seam that each stands for", "mm"},
    Figure{"spacing_mm", "particles lie apart", "mm"},
};

constexpr std::array kArcFigures{
    Figure{"mean_current_a", "mean current", "A", 0},   Figure{"mean_voltage_v", "mean voltage", "V", 1},
    Figure{"energy_kj", "energy of the arc", "kJ", 1},  Figure{"seconds", "time of the arc", "s", 1},
    Figure{"seam_mm", "seam on which it burned", "mm"}, Figure{"travel_speed_mm_s", "travel speed", "mm/s"},
};

/// Entries that stand in the formula below the table.
constexpr std::array<std::string_view, 2> kInFormula{"efficiency_en_1011_1", "heat_input_kj_mm"};

std::string valueText(const Figure& figure, double value) {
    if (figure.decimals < 0) return measure(value, figure.unit);
    return rounded(value, figure.decimals) + (figure.unit.empty() ? "" : " ") + std::string(figure.unit);
}

/// The known entries in their order, then those that a newer program wrote, by their keys.
std::string figuresOf(const json& part, std::span<const Figure> known) {
    std::string rows;
    if (!part.is_object()) return rows;
    for (const Figure& figure : known)
        if (const auto value = numberIn(part, std::string(figure.key).c_str()))
            rows += tableRow(std::string(figure.words), valueText(figure, *value));
    for (const auto& [key, value] : part.items()) {
        const auto named = [&key = key](const Figure& figure) { return figure.key == key; };
        if (!value.is_number() || std::any_of(known.begin(), known.end(), named) ||
            std::find(kInFormula.begin(), kInFormula.end(), key) != kInFormula.end())
            continue;
        const NamedUnit other = namedUnit(key);
        rows += tableRow(other.words, measure(value.get<double>(), other.unit));
    }
    return rows;
}

std::string table(const std::string& rows) {
    return rows.empty() ? rows : "<table>\n" + rows + "</table>\n";
}

/// The formula with its numbers, so that a reader can repeat it.
std::string heatPart(const json& arc) {
    const auto heat = numberIn(arc, "heat_input_kj_mm"), k = numberIn(arc, "efficiency_en_1011_1");
    if (!heat) return {};
    std::string html = "<h2>Heat input by EN 1011-1</h2>\n<p><b>" + measure(heat, "kJ/mm") + "</b>";
    const auto volts = numberIn(arc, "mean_voltage_v"), amperes = numberIn(arc, "mean_current_a"),
               speed = numberIn(arc, "travel_speed_mm_s");
    if (k && volts && amperes && speed)
        html += " = k \xC2\xB7 U \xC2\xB7 I / v = " + rounded(*k, 1) + " \xC2\xB7 " + rounded(*volts, 1) +
                " V \xC2\xB7 " + rounded(*amperes, 0) + " A / (" + measure(speed, "mm/s") + ")";
    html +=
        "</p>\n<p class=\"quiet\">k is the thermal efficiency by EN 1011-1: 0.8 for GMAW and covered electrodes, 0.6 "
        "for GTAW. U and I are means while the arc burned, v the seam on which it burned over that time.</p>\n";
    return html;
}

} // namespace

std::string figurePart(const RunResults& results) {
    const json& arc = partIn(results.result, "arc");
    const std::string weld = figuresOf(partIn(results.result, "weld"), kWeldFigures);
    const std::string burned = figuresOf(arc, kArcFigures);
    if (weld.empty() && burned.empty()) return {};
    return "<h2>The weld in figures</h2>\n<div class=\"columns\">\n" + table(weld) + table(burned) + "</div>\n" +
           heatPart(arc);
}

} // namespace meltpool
