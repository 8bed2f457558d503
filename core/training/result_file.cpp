#include "core/training/result_file.hpp"

#include "core/base/text.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>

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

Json valueOf(const Parameter& p) {
    if (!p.choices.empty()) return parameterText(p);
    if (const auto* number = std::get_if<float*>(&p.value)) return shortNumber(**number);
    if (const auto* whole = std::get_if<int*>(&p.value)) return **whole;
    if (const auto* flag = std::get_if<bool*>(&p.value)) return **flag;
    if (const auto* v = std::get_if<glm::vec3*>(&p.value))
        return {shortNumber((*v)->x), shortNumber((*v)->y), shortNumber((*v)->z)};
    return parameterText(p);
}

double millimetres(double metres) {
    return metres * 1e3;
}

double squareMillimetres(double area) {
    return area * 1e6;
}

Json boxOf(const SectionBox& box) {
    return {{"width_mm", number(millimetres(box.width))},
            {"height_mm", number(millimetres(box.height))},
            {"depth_mm", number(millimetres(box.depth))},
            {"area_mm2", number(squareMillimetres(box.area))}};
}

double degrees(double radians) {
    return radians * 180 / std::numbers::pi;
}

/// The bead on a level workpiece.
void addBead(Json& json, const Section& figures) {
    const BeadShape& bead = *figures.bead;
    const auto overlap = bead.overlap(figures.fusion.stretch);
    json["toe_width_mm"] = number(millimetres(bead.toeWidth()));
    json["height_mm"] = number(millimetres(bead.height));
    json["reinforcement_mm2"] = number(squareMillimetres(bead.reinforcement));
    if (!bead.toes) return;
    json["edge_angle_left_deg"] = number(degrees((*bead.toes)[0].angle));
    json["edge_angle_right_deg"] = number(degrees((*bead.toes)[1].angle));
    json["overlap_left_mm"] = number(millimetres(overlap[0]));
    json["overlap_right_mm"] = number(millimetres(overlap[1]));
}

/// The fillet in the corner of a tee or a lap joint.
void addFillet(Json& json, const FilletShape& fillet) {
    json["leg_lying_mm"] = number(millimetres(fillet.toes[0].place));
    json["leg_standing_mm"] = number(millimetres(fillet.toes[1].place));
    json["throat_mm"] = number(millimetres(fillet.throat));
    json["fillet_mm2"] = number(squareMillimetres(fillet.area));
    json["edge_angle_lying_deg"] = number(degrees(fillet.toes[0].angle));
    json["edge_angle_standing_deg"] = number(degrees(fillet.toes[1].angle));
}

/// The figures that do not apply to this workpiece or metal are left out.
Json sectionOf(const WeldSection& section) {
    const Section& figures = section.figures;
    Json json;
    json["at_mm"] = number(millimetres(section.cut.at()));
    json["length_mm"] = number(millimetres(section.cut.to - section.cut.from));
    json["layers"] = figures.layers;
    json["fused_width_mm"] = number(millimetres(figures.fusion.width));
    json["penetration_mm"] = number(millimetres(figures.fusion.depth));
    if (figures.bead) addBead(json, figures);
    if (figures.fillet) addFillet(json, *figures.fillet);
    if (figures.rootFusion) json["root_fusion_mm"] = number(millimetres(*figures.rootFusion));
    json["deposited_mm2"] = number(squareMillimetres(figures.deposited));
    json["fused_plate_mm2"] = number(squareMillimetres(figures.fusion.area));
    if (figures.heatAffected) {
        json["heat_affected_width_mm"] = number(millimetres(figures.heatAffected->width));
        json["heat_affected_depth_mm"] = number(millimetres(figures.heatAffected->depth));
    }
    json["fusion"] = boxOf(figures.fusion.box);
    if (figures.heatAffected) json["heat_affected"] = boxOf(figures.heatAffected->box);
    return json;
}

Json parameterScores(const TechniqueScore& score, DistanceKind distance) {
    Json json = Json::object();
    for (const ParameterScore& each : score.parameters)
        json[std::string(quantityInfo(each.quantity, distance).key)] = number(each.score);
    return json;
}

/// Means and deviations of the judged parameters, and what was asked for, in their bands' units.
Json parameterValues(const TechniqueScore& score, DistanceKind distance, const TechniqueBands* bands) {
    Json json = Json::object();
    for (const ParameterScore& each : score.parameters) {
        const QuantityInfo& info = quantityInfo(each.quantity, distance);
        json[std::string(info.key)] = {{"unit", info.unit},
                                       {"mean", number(each.mean)},
                                       {"deviation", number(each.deviation)},
                                       {"spread", number(each.spread)},
                                       {"worst_at_mm", number(each.worstPlaceMm)}};
        const TechniqueBand* band = bands == nullptr ? nullptr : bands->find(each.quantity);
        if (band == nullptr) continue;
        json[std::string(info.key)]["ideal"] = number(band->ideal);
        json[std::string(info.key)]["inner"] = number(band->inner);
        json[std::string(info.key)]["outer"] = number(band->outer);
    }
    return json;
}

Json scoreOf(const Judgement& judgement, const TechniqueBands* bands) {
    const TechniqueScore& score = *judgement.score;
    Json json{{"total", score.scored ? number(score.total) : Json(nullptr)}, {"scored", score.scored}};
    if (!score.scored) json["reason"] = score.reason;
    json["parameters"] = parameterScores(score, judgement.distance);
    json["values"] = parameterValues(score, judgement.distance, bands);
    json["coverage_percent"] = number(score.coverage * 100);
    json["corrections"] = Json::array();
    for (const Correction& each : judgement.corrections)
        json["corrections"].push_back(each.sentence);
    return json;
}

Json optionalNumber(const std::optional<double>& value) {
    return value ? number(*value) : Json(nullptr);
}

Json verdictOf(const Verdict& verdict) {
    Json json{{"standard", verdict.standard},
              {"edition", verdict.edition},
              {"level", verdict.level},
              {"accepted", verdict.accepted},
              {"items", Json::array()}};
    for (const VerdictItem& item : verdict.items) {
        Json entry{{"name", item.name},
                   {"value", optionalNumber(item.value)},
                   {"limit", optionalNumber(item.limit)},
                   {"unit", item.unit},
                   {"state", nameOf(item.state)}};
        if (item.place) entry["at_mm"] = number(millimetres(*item.place));
        if (item.state == VerdictState::estimated) entry["rule"] = item.rule;
        json["items"].push_back(std::move(entry));
    }
    return json;
}

/// Means over the stations; a figure that does not apply is left out.
Json weldOf(const WeldMeasures& weld) {
    Json json{{"kind", nameOf(weld.kind)}, {"stations", weld.stations.size()}};
    for (const StationColumn& column : stationColumns())
        if (const auto& value = weld.mean.*column.value) json[std::string(column.name)] = number(*value / column.unit);
    if (weld.straightness) json["straightness_mm"] = number(millimetres(*weld.straightness));
    return json;
}

/// Means while the arc burned. Heat input over the whole millimetres of seam on which it did.
Json arcOf(const Judgement& judgement, const ProcessSettings& process) {
    const ArcAccount& arc = judgement.arc;
    Json json{{"seconds", number(arc.seconds)},
              {"mean_current_a", number(arc.meanCurrent())},
              {"mean_voltage_v", number(arc.meanVoltage())},
              {"energy_kj", number(arc.energy * 1e-3)}};
    const double length = static_cast<double>(judgement.seam.size()) * 1e-3;
    if (const auto efficiency = standardEfficiency(process); efficiency && length > 0) {
        json["efficiency_en_1011_1"] = *efficiency;
        json["heat_input_kj_mm"] = number(arc.heatInput(*efficiency, length) * 1e-6);
    }
    return json;
}

/// Technique, verdict and measured weld, each where there is one.
void addJudgement(Json& json, const Judgement& judgement, const Lesson& lesson) {
    if (judgement.score) json["score"] = scoreOf(judgement, lesson.technique ? &*lesson.technique : nullptr);
    if (judgement.arc.seconds > 0) json["arc"] = arcOf(judgement, lesson.process);
    if (judgement.verdict) json["verdict"] = verdictOf(*judgement.verdict);
    if (judgement.weld) json["weld"] = weldOf(*judgement.weld);
}

/// Wire that was fed is found again: in drops, or standing out of the contact tip.
Json wireOf(const WireAccount& wire) {
    return {{"fed_mm", number(wire.fed * 1e3)},
            {"melted_mm", number(wire.melted * 1e3)},
            {"standing_out_mm", number(wire.standing * 1e3)},
            {"fed_g", number(wire.fed * wire.area * wire.density * 1e3)},
            {"melted_g", number(wire.melted * wire.area * wire.density * 1e3)}};
}

/// The attempt that the run repeats, and whether the metal ended in the same bits.
Json recordedOf(const RecordedAttempt& attempt, const LessonResult& result) {
    Json json{{"record", attempt.file.filename().string()}, {"ended", attempt.ended}, {"steps", attempt.rows}};
    if (attempt.realTime) json["real_time"] = number(*attempt.realTime);
    if (const auto same = sameEnd(attempt, result.steps, result.stateHash)) json["same"] = *same;
    return json;
}

/// The entries before the figures of a run.
Json beginning(const Lesson& lesson, const ResultContext& context) {
    Json json;
    json["lesson"] = lesson.key;
    json["finished"] = context.error.empty();
    if (!context.error.empty()) json["error"] = context.error;
    json["renderer"] = context.renderer;
    return json;
}

/// Adds the entries behind the figures and writes the file.
void finish(const std::filesystem::path& file, Json json, Lesson& lesson, const ResultContext& context) {
    json["torch"] = lesson.torchFile.filename().string();
    json["version"] = context.version;
    json["commit"] = context.commit;
    if (!lesson.choose.empty()) json["chosen"] = Json::array();
    for (const ChosenSetting& each : lesson.choose)
        json["chosen"].push_back(each.key);
    Json& parameters = json["parameters"];
    for (const Parameter& parameter : lesson.parameters())
        parameters[std::string(parameter.key)] = valueOf(parameter);
    writeTextFileAtomically(file, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

} // namespace

void writeUnfinishedResult(const std::filesystem::path& file, Lesson& lesson, const ResultContext& context) {
    finish(file, beginning(lesson, context), lesson, context);
}

void writeResult(const std::filesystem::path& file, Lesson& lesson, const LessonResult& result,
                 const ResultContext& context) {
    Json json = beginning(lesson, context);
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
    addJudgement(json, context.judgement, lesson);
    if (result.wire.area > 0) json["wire"] = wireOf(result.wire);
    json["state_hash"] = formatHexadecimal(result.stateHash);
    if (lesson.recorded) json["recorded"] = recordedOf(*lesson.recorded, result);
    json["wall_seconds"] = number(context.wallSeconds);
    json["metal_bytes"] = result.metalBytes;
    json["surface_bytes"] = result.surfaceBytes;
    finish(file, std::move(json), lesson, context);
}

} // namespace meltpool
