// The head of the page: lesson, how the attempt was made, score, corrections, and the weld's pictures.
#include "app/report/page_parts.hpp"
#include "app/report/page_text.hpp"
#include "app/report/section_drawing.hpp"
#include "app/report/svg_text.hpp"
#include "core/base/words.hpp"
#include "core/training/judging/quantity.hpp"
#include "core/weld/process/shielding_gas.hpp"

#include <algorithm>

namespace meltpool {

namespace {

using nlohmann::json;

/// List item of the head, `name` of page.fact; empty without a value.
std::string fact(const char* name, const std::string& value) {
    return value.empty() ? std::string() : "<li><b>" + phraseOf("page.fact", name) + "</b> " + value + "</li>\n";
}

std::string numberFact(const char* name, std::optional<double> value, int decimals, const char* unit) {
    return value ? fact(name, numberText(*value, decimals) + unit) : std::string();
}

/// Leader of the torch, and how the attempt counts.
std::string kindOf(const json& result) {
    const json& attempt = partIn(result, "attempt");
    if (attempt.is_null()) return phrase("page.kind.path");
    const json& forScore = partIn(attempt, "for_score");
    if (forScore == true) return phrase("page.kind.for_score");
    if (forScore == false) return phrase("page.kind.practice");
    return phrase("page.kind.not_recorded");
}

/// Help for the hand; "none" only if all of it is known.
std::string helpOf(const json& attempt) {
    std::string help;
    const auto add = [&](const std::string& word) { help += (help.empty() ? "" : phrase("list.separator")) + word; };
    if (partIn(attempt, "guided") == true) add(phrase("page.help.guided"));
    if (partIn(attempt, "swung") == true) add(phrase("page.help.swung"));
    if (const std::string held = rawIn(attempt, "held"); !held.empty())
        add(phrase("page.help.held", {{"quantities", escaped(wordsOfKeys(held))}}));
    if (partIn(attempt, "changed") == true) add(phrase("page.help.changed"));
    if (const std::string cues = textIn(attempt, "cues"); !cues.empty())
        add(phrase("page.help.cues", {{"cues", cues}}));
    if (const std::string ghost = textIn(attempt, "ghost"); !ghost.empty())
        add(phrase("page.help.ghost", {{"ghost", ghost}}));
    const bool known = attempt.is_object() && attempt.contains("guided") && attempt.contains("changed");
    return help.empty() && known ? phrase("page.help.none") : help;
}

/// Date of the attempt if a person made it, else of the run.
std::string dateOf(const json& result) {
    const std::string attempt = textIn(partIn(result, "attempt"), "date");
    return attempt.empty() ? textIn(result, "date") : attempt;
}

std::string programOf(const json& result) {
    const std::string version = textIn(result, "version");
    const std::string run = version.empty() ? version : version + " (" + textIn(result, "commit") + ")";
    const std::string attempt = textIn(partIn(result, "attempt"), "program");
    return attempt.empty() || attempt == run ? run
                                             : phrase("page.other_program", {{"program", run}, {"attempt", attempt}});
}

std::string driverOf(const json& result) {
    const std::string run = textIn(result, "renderer"), attempt = textIn(partIn(result, "attempt"), "driver");
    return attempt.empty() || attempt == run ? run
                                             : phrase("page.other_driver", {{"driver", run}, {"attempt", attempt}});
}

/// Sentence that a repeated record ended in the attempt's bits of metal, or did not.
std::string sameOf(const json& result) {
    const json& same = partIn(partIn(result, "recorded"), "same");
    if (same == true) return phrase("page.repeated.same");
    return same == false ? phrase("page.repeated.other") : std::string();
}

std::string realTimeOf(const json& attempt) {
    const auto ratio = numberIn(attempt, "real_time");
    return ratio ? phrase("page.of_the_clock", {{"share", PhraseNumber(*ratio * 100)}}) : std::string();
}

/// Sizes of the weld in a result: `section`, else the means of `weld`.
SectionSizes sizesOf(const json& result) {
    SectionSizes sizes;
    const json& section = partIn(result, "section");
    const json& weld = partIn(result, "weld");
    const auto known = [&](const char* inSection, const char* inWeld) {
        const auto cut = numberIn(section, inSection);
        return cut ? cut : numberIn(weld, inWeld);
    };
    sizes.thickness = numberIn(partIn(result, "parameters"), "thickness_mm");
    sizes.toeWidth = known("toe_width_mm", "toe_width_mm");
    sizes.height = known("height_mm", "height_mm");
    sizes.legBase = known("leg_lying_mm", "leg1_mm");
    sizes.legUpright = known("leg_standing_mm", "leg2_mm");
    sizes.throat = known("throat_mm", "throat_mm");
    sizes.fusedWidth = known("fused_width_mm", "fused_width_mm");
    sizes.penetration = known("penetration_mm", "penetration_mm");
    return sizes;
}

bool isSection(const ReportPicture& picture) {
    return picture.name.find("section") != std::string::npos;
}

/// Picture of the weld from outside: the lesson's "metal", else its first picture that is no section.
const ReportPicture* outsideOf(const std::vector<ReportPicture>& pictures) {
    const auto metal = std::find_if(pictures.begin(), pictures.end(), [](const auto& p) { return p.name == "metal"; });
    if (metal != pictures.end()) return &*metal;
    const auto first = std::find_if(pictures.begin(), pictures.end(), [](const auto& p) { return !isSection(p); });
    return first == pictures.end() ? nullptr : &*first;
}

std::string imageOf(const ReportPicture& picture, const std::string& caption) {
    return "<figure><img alt=\"" + escaped(caption) + "\" src=\"data:image/png;base64," + base64(picture.png) +
           "\"><figcaption>" + escaped(caption) + "</figcaption></figure>\n";
}

/// Lines of a sentence below each other.
std::string withBreaks(const std::string& sentence) {
    std::string html;
    for (const char c : sentence)
        html += c == '\n' ? std::string("<br>") : std::string(1, c);
    return html;
}

std::string sectionCaption(const json& result) {
    const auto at = numberIn(partIn(result, "section"), "at_mm");
    return at ? phrase("page.picture.section_at", {{"place", PhraseNumber(*at, 1)}}) : phrase("page.picture.section");
}

/// Returns the gas of the weld with its flow; empty without one, as in results of programs that had no such setting.
std::string gasOf(const json& result) {
    const json& parameters = partIn(result, "parameters");
    const ShieldingGas* gas = findShieldingGas(rawIn(parameters, "gas"));
    if (gas == nullptr) return {};
    const auto flow = numberIn(parameters, "gas_flow_l_min");
    const std::string name = escaped(gasText(*gas));
    return flow && gas != &shieldingGas(GasKind::none)
               ? phrase("page.gas_with_flow", {{"gas", name}, {"flow", numberText(*flow, 1)}})
               : name;
}

} // namespace

std::string headPart(const RunResults& results) {
    const json& result = results.result;
    const json& attempt = partIn(result, "attempt");
    const std::string key = textIn(result, "lesson"), title = textIn(result, "title");
    std::string html = "<h1>" + (title.empty() ? key : title) + "</h1>\n<ul class=\"facts\">\n";
    html += fact("person", textIn(attempt, "person"));
    html += fact("lesson", key) + fact("kind", kindOf(result)) + fact("date", dateOf(result));
    html += fact("settings", textIn(result, "chosen_text"));
    html += fact("gas", gasOf(result));
    html += fact("sizes", textIn(result, "simulated_text"));
    html += fact("torch_path", textIn(result, "torch")) + numberFact("simulated", numberIn(result, "seconds"), 1, " s");
    html += fact("metal_ran_at", realTimeOf(attempt)) + numberFact("zoom", numberIn(attempt, "zoom"), 1, "");
    html += fact("help", helpOf(attempt)) + fact("repeated", sameOf(result));
    html += fact("program", programOf(result)) + fact("driver", driverOf(result));
    html += fact("state", textIn(result, "state_hash")) + "</ul>\n";
    for (const std::string& note : results.notes)
        html += "<p class=\"quiet\">" + escaped(note) + "</p>\n";
    return html;
}

std::string scorePart(const RunResults& results) {
    const json& score = partIn(results.result, "score");
    if (!score.is_object()) return "<p class=\"quiet\">" + phrase("page.score.none") + "</p>\n";
    const auto total = numberIn(score, "total");
    if (!total)
        return "<p class=\"fail\">" + phrase("page.score.not_scored", {{"reason", textIn(score, "reason")}}) + "</p>\n";
    const std::string points = "<span class=\"score\">" + numberText(*total, 0) + "</span>";
    std::string html = "<div class=\"top\"><div>" + withBreaks(phrase("page.score.of_technique", {{"points", points}}));
    const auto welded = numberIn(score, "welded_mm"), wanted = numberIn(score, "wanted_mm");
    if (welded && wanted)
        html += "<br>" + withBreaks(phrase("page.score.welded",
                                           {{"welded", measure(welded, "mm")}, {"wanted", measure(wanted, "mm")}}));
    html += "</div>\n<div>\n";
    if (const std::string unknown = textIn(score, "unknown"); !unknown.empty()) html += "<p>" + unknown + "</p>\n";
    const json& corrections = partIn(score, "corrections");
    if (corrections.is_array() && !corrections.empty()) {
        html += "<h2>" + phrase("page.score.corrections") + "</h2>\n<ol>\n";
        for (const json& sentence : corrections)
            if (sentence.is_string()) html += "<li>" + escaped(sentence.get<std::string>()) + "</li>\n";
        html += "</ol>\n";
    } else {
        html += "<p>" + phrase("page.score.no_corrections") + "</p>\n";
    }
    return html + "</div></div>\n";
}

std::string picturePart(const RunResults& results) {
    std::string html;
    if (const ReportPicture* outside = outsideOf(results.pictures))
        html += imageOf(*outside, phrase("page.picture.outside"));
    const auto cut = std::find_if(results.pictures.begin(), results.pictures.end(), isSection);
    if (cut != results.pictures.end())
        html += imageOf(*cut, sectionCaption(results.result));
    else if (const std::string drawn = sectionDrawing(sizesOf(results.result)); !drawn.empty())
        html += "<figure>" + drawn + "<figcaption>" + phrase("page.picture.drawn") + "</figcaption></figure>\n";
    return html.empty() ? "<p class=\"quiet\">" + phrase("page.picture.none") + "</p>\n"
                        : "<div class=\"pair\">\n" + html + "</div>\n";
}

} // namespace meltpool
