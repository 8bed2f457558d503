#include "core/training/trainer/result_file.hpp"

#include "core/base/text.hpp"
#include "core/training/attempt/record_text.hpp"
#include "core/training/trainer/repetition.hpp"
#include "core/training/trainer/result_judgement.hpp"
#include "core/weld/workpiece/simulated_size.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace meltpool {

namespace {

using Json = nlohmann::ordered_json;

/// A float as the shortest decimal that reads back to it; without this the JSON writer prints its long double.
Json shortNumber(float value) {
    return jsonNumber(parseDouble(formatNumber(value)).value_or(NAN));
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
    return {{"width_mm", jsonNumber(millimetres(box.width))},
            {"height_mm", jsonNumber(millimetres(box.height))},
            {"depth_mm", jsonNumber(millimetres(box.depth))},
            {"area_mm2", jsonNumber(squareMillimetres(box.area))}};
}

double degrees(double radians) {
    return radians * 180 / std::numbers::pi;
}

/// Adds the bead on a level workpiece.
void addBead(Json& json, const Section& figures) {
    const BeadShape& bead = *figures.bead;
    const auto overlap = bead.overlap(figures.fusion.stretch);
    json["toe_width_mm"] = jsonNumber(millimetres(bead.toeWidth()));
    json["height_mm"] = jsonNumber(millimetres(bead.height));
    json["reinforcement_mm2"] = jsonNumber(squareMillimetres(bead.reinforcement));
    if (!bead.toes) return;
    json["edge_angle_left_deg"] = jsonNumber(degrees((*bead.toes)[0].angle));
    json["edge_angle_right_deg"] = jsonNumber(degrees((*bead.toes)[1].angle));
    json["overlap_left_mm"] = jsonNumber(millimetres(overlap[0]));
    json["overlap_right_mm"] = jsonNumber(millimetres(overlap[1]));
}

/// Adds the fillet in the corner of a tee or a lap joint.
void addFillet(Json& json, const FilletShape& fillet) {
    json["leg_lying_mm"] = jsonNumber(millimetres(fillet.toes[0].place));
    json["leg_standing_mm"] = jsonNumber(millimetres(fillet.toes[1].place));
    json["throat_mm"] = jsonNumber(millimetres(fillet.throat));
    json["fillet_mm2"] = jsonNumber(squareMillimetres(fillet.area));
    json["edge_angle_lying_deg"] = jsonNumber(degrees(fillet.toes[0].angle));
    json["edge_angle_standing_deg"] = jsonNumber(degrees(fillet.toes[1].angle));
}

/// Leaves out figures that do not apply to this workpiece or metal.
Json sectionOf(const WeldSection& section) {
    const Section& figures = section.figures;
    Json json;
    json["at_mm"] = jsonNumber(millimetres(section.cut.at()));
    json["length_mm"] = jsonNumber(millimetres(section.cut.to - section.cut.from));
    json["layers"] = figures.layers;
    json["fused_width_mm"] = jsonNumber(millimetres(figures.fusion.width));
    json["penetration_mm"] = jsonNumber(millimetres(figures.fusion.depth));
    if (figures.bead) addBead(json, figures);
    if (figures.fillet) addFillet(json, *figures.fillet);
    if (figures.rootFusion) json["root_fusion_mm"] = jsonNumber(millimetres(*figures.rootFusion));
    json["deposited_mm2"] = jsonNumber(squareMillimetres(figures.deposited));
    json["fused_plate_mm2"] = jsonNumber(squareMillimetres(figures.fusion.area));
    if (figures.heatAffected) {
        json["heat_affected_width_mm"] = jsonNumber(millimetres(figures.heatAffected->width));
        json["heat_affected_depth_mm"] = jsonNumber(millimetres(figures.heatAffected->depth));
    }
    json["fusion"] = boxOf(figures.fusion.box);
    if (figures.heatAffected) json["heat_affected"] = boxOf(figures.heatAffected->box);
    return json;
}

/// Accounts for the fed wire: in drops, or sticking out of the contact tip.
Json wireOf(const WireAccount& wire) {
    return {{"fed_mm", jsonNumber(wire.fed * 1e3)},
            {"melted_mm", jsonNumber(wire.melted * 1e3)},
            {"standing_out_mm", jsonNumber(wire.standing * 1e3)},
            {"fed_g", jsonNumber(wire.fed * wire.area * wire.density * 1e3)},
            {"melted_g", jsonNumber(wire.melted * wire.area * wire.density * 1e3)}};
}

/// The attempt that the run repeats, and if the metal ended in equal bits. A run that changes a value has no such
/// comparison. `result`: null without a metal.
Json recordedOf(const RecordedAttempt& attempt, const LessonResult* result, const ResultContext& context) {
    Json json{{"record", attempt.file.filename().string()},
              {"ended", attempt.ended},
              {"steps", attempt.rows},
              {"program", attempt.head.program},
              {"driver", attempt.head.driver}};
    if (attempt.realTime) json["real_time"] = jsonNumber(*attempt.realTime);
    if (attempt.redone > 0) json["redone"] = attempt.redone;
    if (result == nullptr || !context.whatIf.empty()) return json;
    if (const auto same = sameEnd(attempt, result->steps, result->stateHash)) json["same"] = *same;
    const std::string program = context.version + " (" + context.commit + ")"; // name in the form of records
    json["repetition"] = nameOf(repetitionOf(attempt, *result, program, context.renderer));
    return json;
}

/// Leaves out unknown values.
Json attemptOf(const AttemptFacts& facts) {
    Json json = Json::object();
    const auto text = [&](const char* key, const std::string& value) {
        if (!value.empty()) json[key] = value;
    };
    text("person", facts.head.person);
    text("person_id", facts.head.personId);
    text("date", facts.head.date);
    text("program", facts.head.program);
    text("driver", facts.head.driver);
    if (facts.forScore) json["for_score"] = *facts.forScore;
    if (facts.realTime) json["real_time"] = jsonNumber(*facts.realTime);
    if (facts.zoom) json["zoom"] = jsonNumber(*facts.zoom);
    if (facts.guided) json["guided"] = *facts.guided;
    if (facts.swung) json["swung"] = *facts.swung;
    text("held", facts.held);
    if (facts.changed) json["changed"] = *facts.changed;
    text("cues", facts.cues);
    text("ghost", facts.ghost);
    return json;
}

/// The entries before the figures of a run.
Json beginning(const Lesson& lesson, const ResultContext& context) {
    Json json;
    json["lesson"] = lesson.key;
    json["title"] = lesson.title;
    json["finished"] = context.error.empty();
    if (!context.error.empty()) json["error"] = context.error;
    json["renderer"] = context.renderer;
    if (!context.date.empty()) json["date"] = context.date;
    if (!context.warnings.empty()) json["warnings"] = context.warnings;
    return json;
}

/// Adds the metal's figures at the end.
void addFigures(Json& json, const LessonResult& result, LessonModel model) {
    const bool weld = model == LessonModel::Weld; // the classic metal's temperatures have no unit
    const std::string unit = weld ? "_c" : "";
    const auto shown = [&](double temperature) { return jsonNumber(weld ? celsius(temperature) : temperature); };

    json["seconds"] = jsonNumber(result.seconds);
    json["steps"] = result.steps;
    json["particles"] = result.metal.particles;
    json["min_temperature" + unit] = shown(result.metal.minTemperature);
    json["mean_temperature" + unit] = shown(result.metal.meanTemperature);
    json["max_temperature" + unit] = shown(result.metal.maxTemperature);
    json["molten"] = result.metal.molten;
    json["lost"] = result.metal.lost;
    json["non_finite"] = result.metal.nonFinite;
}

/// Adds the cost of the run, and the hash of its final state.
void addEnd(Json& json, const LessonResult& result, const ResultContext& context) {
    if (result.wire.area > 0) json["wire"] = wireOf(result.wire);
    json["state_hash"] = formatHexadecimal(result.stateHash);
    json["wall_seconds"] = jsonNumber(context.wallSeconds);
    json["metal_bytes"] = result.metalBytes;
    json["surface_bytes"] = context.surfaceBytes;
}

/// Assumptions of the torch path's reader about its table.
Json torchFormOf(const TorchForm& form) {
    Json json;
    json["encoding"] = encodingName(form.table.encoding);
    json["separator"] = std::string(1, form.table.separator);
    json["decimal_comma"] = form.table.decimalComma;
    json["lines_above_header"] = form.table.linesAbove;
    json["time_unit"] = form.clock.unit;
    json["time_unit_judged_by_size"] = form.clock.judged;
    if (form.clock.shifted) json["began_at_s"] = jsonNumber(form.clock.begin);
    json["positions_taken_to_be_mm"] = form.placesWithoutUnit;
    json["rows_without_pose"] = form.unseenRows;
    return json;
}

/// Adds sizes of the workpiece that are simulated differently from the parameters, also in words.
void addSimulatedSizes(Json& json, const Lesson& lesson) {
    if (lesson.model != LessonModel::Weld) return;
    const std::vector<SimulatedSize> sizes = simulatedSizes(lesson.workpiece);
    for (const SimulatedSize& size : sizes)
        json["simulated"][std::string(size.key)] = shortNumber(size.simulated);
    if (!sizes.empty()) json["simulated_text"] = simulatedSizesText(lesson.workpiece);
}

/// Adds the entries behind the figures.
Json finished(Json json, Lesson& lesson, const ResultContext& context) {
    json["torch"] = lesson.torchFile.filename().string();
    if (const auto& form = lesson.torch.form(); form && !form->ours) json["torch_form"] = torchFormOf(*form);
    json["version"] = context.version;
    json["commit"] = context.commit;
    if (!lesson.choose.empty()) json["chosen"] = Json::array();
    for (const ChosenSetting& each : lesson.choose)
        json["chosen"].push_back(each.key);
    if (!lesson.choose.empty()) json["chosen_text"] = lesson.chosenText();
    addSimulatedSizes(json, lesson);
    Json& parameters = json["parameters"];
    for (const Parameter& parameter : lesson.parameters())
        parameters[std::string(parameter.key)] = valueOf(parameter);
    return json;
}

std::string textOf(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// Adds a name to a list in words, once.
void addName(std::string& list, const std::string& name) {
    if (name.empty() || name == "none" || list.find(name) != std::string::npos) return;
    list += (list.empty() ? "" : ", ") + name;
}

} // namespace

AttemptFacts factsOf(const RecordedAttempt& attempt) {
    AttemptFacts facts;
    facts.head = attempt.head;
    facts.realTime = attempt.realTime;
    // A person's attempt has this line if it was a test; without the line it was practice.
    if (attempt.realTime) facts.forScore = false;
    for (const RecordedEvent& note : attempt.notes) {
        if (note.name == "for_score") facts.forScore = note.value == "yes";
        if (note.name == "desk_swings" && note.value == "on") facts.swung = true;
        if (note.name == "desk_holds") facts.held = note.value == "none" ? std::string() : note.value;
        if (note.name == "zoom") facts.zoom = parseDouble(note.value);
        if (note.name == "cues") addName(facts.cues, note.value);
        if (note.name == "ghost") addName(facts.ghost, note.value.substr(0, note.value.find(' '))); // "expert place"
    }
    return facts;
}

nlohmann::ordered_json resultEntries(Lesson& lesson, const LessonResult* result, const ResultContext& context) {
    Json json = beginning(lesson, context);
    if (result != nullptr) addFigures(json, *result, lesson.model);
    if (context.section) json["section"] = sectionOf(*context.section);
    addJudgement(json, context.judgement, lesson);
    if (context.attempt) json["attempt"] = attemptOf(*context.attempt);
    if (lesson.recorded) json["recorded"] = recordedOf(*lesson.recorded, result, context);
    for (const auto& [key, value] : context.whatIf)
        json["what_if"][key] = value;
    if (result != nullptr) addEnd(json, *result, context);
    return finished(std::move(json), lesson, context);
}

void writeUnfinishedResult(const std::filesystem::path& file, Lesson& lesson, const ResultContext& context) {
    writeTextFileAtomically(file, textOf(finished(beginning(lesson, context), lesson, context)));
}

void writeResult(const std::filesystem::path& file, Lesson& lesson, const LessonResult& result,
                 const ResultContext& context) {
    writeTextFileAtomically(file, textOf(resultEntries(lesson, &result, context)));
}

} // namespace meltpool
