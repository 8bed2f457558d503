#include "core/training/trainer/result_judgement.hpp"

#include "core/weld/gauge/weld_figures.hpp"

#include <cmath>

namespace meltpool {

namespace {

using Json = nlohmann::ordered_json;

double millimetres(double metres) {
    return metres * 1e3;
}

/// Null if the attempt has no score.
Json ifScored(const TechniqueScore& score, double value) {
    return score.scored ? jsonNumber(value) : Json(nullptr);
}

Json parameterScores(const TechniqueScore& score, DistanceKind distance) {
    Json json = Json::object();
    for (const ParameterScore& each : score.parameters)
        json[std::string(quantityInfo(each.quantity, distance).key)] = ifScored(score, each.score);
    return json;
}

/// Means and deviations of the judged parameters, and their targets, in their bands' units.
Json parameterValues(const TechniqueScore& score, DistanceKind distance, const TechniqueBands* bands) {
    Json json = Json::object();
    for (const ParameterScore& each : score.parameters) {
        const QuantityInfo& info = quantityInfo(each.quantity, distance);
        Json& entry = json[std::string(info.key)];
        entry = {{"unit", info.unit},
                 {"mean", jsonNumber(each.mean)},
                 {"deviation", jsonNumber(each.deviation)},
                 {"spread", jsonNumber(each.spread)},
                 {"least", jsonNumber(each.least)},
                 {"most", jsonNumber(each.most)},
                 {"worst_at_mm", jsonNumber(each.worstPlaceMm)},
                 {"lost_points", ifScored(score, each.lost)}};
        const TechniqueBand* band = bands == nullptr ? nullptr : bands->find(each.quantity);
        if (band == nullptr) continue;
        entry["ideal"] = jsonNumber(band->ideal);
        entry["inner"] = jsonNumber(band->inner);
        entry["outer"] = jsonNumber(band->outer);
        entry["weight"] = jsonNumber(band->weight);
    }
    return json;
}

Json scoreOf(const Judgement& judgement, const TechniqueBands* bands) {
    const TechniqueScore& score = *judgement.score;
    Json json{{"total", ifScored(score, score.total)}, {"scored", score.scored}};
    if (!score.scored) json["reason"] = score.reason;
    json["parameters"] = parameterScores(score, judgement.distance);
    json["values"] = parameterValues(score, judgement.distance, bands);
    json["coverage_percent"] = jsonNumber(score.coverage * 100);
    json["wanted_mm"] = jsonNumber(score.wantedMm);
    json["welded_mm"] = jsonNumber(score.weldedMm);
    json["judged_mm"] = jsonNumber(score.judgedMm);
    json["unknown_mm"] = jsonNumber(score.unknownMm);
    if (score.unknownMm > 0) json["unknown"] = unknownSentence(score);
    json["lost_to_length_points"] = ifScored(score, score.lostToLength);
    json["corrections"] = Json::array();
    for (const Correction& each : judgement.corrections)
        json["corrections"].push_back(each.sentence);
    return json;
}

Json optionalNumber(const std::optional<double>& value) {
    return value ? jsonNumber(*value) : Json(nullptr);
}

/// Word of acceptance files for it.
const char* limitWord(LimitKind kind) {
    if (kind == LimitKind::notPermitted) return "not_permitted";
    return kind == LimitKind::atLeast ? "at_least" : "at_most";
}

Json stretchesOf(const std::vector<FaceStretch>& stretches) {
    Json json = Json::array();
    for (const FaceStretch& each : stretches)
        json.push_back({jsonNumber(millimetres(each.low)), jsonNumber(millimetres(each.high))});
    return json;
}

/// Adds likely cause and remedy to an item that has them, and the wish that tries the remedy.
void addCure(Json& entry, const std::string& imperfection, const std::vector<Cure>& cures) {
    for (const Cure& each : cures) {
        if (each.imperfection != imperfection) continue;
        entry["cure"] = each.sentence;
        if (!each.whatIf.empty()) entry["try"] = each.whatIf;
    }
}

Json verdictOf(const Verdict& verdict, const std::vector<Cure>& cures) {
    Json json{{"standard", verdict.standard},
              {"edition", verdict.edition},
              {"level", verdict.level},
              {"accepted", verdict.accepted},
              {"not_assessed", verdict.notAssessed()},
              {"judged_mm", jsonNumber(millimetres(verdict.judgedLength))},
              {"asked_mm", jsonNumber(millimetres(verdict.askedLength))},
              {"complete", verdict.complete},
              {"items", Json::array()}};
    for (const VerdictItem& item : verdict.items) {
        Json entry{{"name", item.name},
                   {"value", optionalNumber(item.value)},
                   {"limit", optionalNumber(item.limit)},
                   {"unit", item.unit},
                   {"state", nameOf(item.state)}};
        if (item.limit) entry["limit_kind"] = limitWord(item.kind);
        entry["beyond"] = item.beyond;
        entry["uncertainty"] = jsonNumber(item.uncertainty);
        if (item.meanOver > 0) entry["mean_over_mm"] = jsonNumber(millimetres(item.meanOver));
        if (item.place) entry["at_mm"] = jsonNumber(millimetres(*item.place));
        if (!item.failing.empty()) entry["stretches_mm"] = stretchesOf(item.failing);
        if (item.state == VerdictState::estimated) entry["rule"] = item.rule;
        if (item.state == VerdictState::fail) addCure(entry, item.name, cures);
        json["items"].push_back(std::move(entry));
    }
    return json;
}

/// Means over the stations; a figure that does not apply is left out.
Json weldOf(const WeldMeasures& weld) {
    Json json{{"kind", nameOf(weld.kind)},
              {"stations", weld.stations.size()},
              {"pitch_mm", jsonNumber(millimetres(weld.pitch))},
              {"spacing_mm", jsonNumber(millimetres(weld.spacing))}};
    for (const WeldFigure& figure : stationFigures())
        if (const auto& value = weld.mean.*figure.member)
            json[std::string(figure.key)] = jsonNumber(*value / figure.inSi());
    for (const WeldFigure& figure : wholeWeldFigures())
        if (figure.whole != nullptr && weld.*figure.whole)
            json[std::string(figure.key)] = jsonNumber(*(weld.*figure.whole) / figure.inSi());
    return json;
}

/// Means while the arc burned. Heat input is over the whole millimetres of seam with an arc.
Json arcOf(const Judgement& judgement, const ProcessSettings& process) {
    const ArcAccount& arc = judgement.arc;
    const ProcessTraits& traits = traitsOf(process);
    Json json{{"process", traits.name},
              {"seconds", jsonNumber(arc.seconds)},
              {"mean_current_a", jsonNumber(arc.meanCurrent())},
              {"mean_voltage_v", jsonNumber(arc.meanVoltage())},
              {"energy_kj", jsonNumber(arc.energy * 1e-3)}};
    const double length = static_cast<double>(judgement.seam.size()) * 1e-3;
    if (const auto efficiency = traits.efficiency; efficiency && length > 0) {
        json["seam_mm"] = jsonNumber(length * 1e3);
        json["travel_speed_mm_s"] = jsonNumber(length * 1e3 / arc.seconds);
        json["efficiency_en_1011_1"] = *efficiency;
        json["heat_input_kj_mm"] = jsonNumber(arc.heatInput(*efficiency, length) * 1e-6);
    }
    return json;
}

} // namespace

Json jsonNumber(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

void addJudgement(Json& json, const Judgement& judgement, const Lesson& lesson) {
    if (judgement.score) json["score"] = scoreOf(judgement, lesson.technique ? &*lesson.technique : nullptr);
    if (judgement.arc.seconds > 0) json["arc"] = arcOf(judgement, lesson.process);
    if (judgement.verdict) json["verdict"] = verdictOf(*judgement.verdict, judgement.cures);
    if (judgement.weld) json["weld"] = weldOf(*judgement.weld);
}

} // namespace meltpool
