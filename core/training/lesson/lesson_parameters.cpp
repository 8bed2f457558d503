#include "core/training/lesson/lesson.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/base/words.hpp"
#include "core/weld/workpiece/simulated_size.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <variant>

namespace meltpool {

namespace {

constexpr std::array<std::string_view, 2> kSources{"hot", "cold"};

void append(ParameterList& list, ParameterList more) {
    list.insert(list.end(), more.begin(), more.end());
}

/// A label within an English sentence: "Wire feed" -> "wire feed".
std::string lowerFirst(std::string_view label) {
    std::string text(label);
    if (!text.empty() && text[0] >= 'A' && text[0] <= 'Z') text[0] = static_cast<char>(text[0] - 'A' + 'a');
    return text;
}

/// A setting's label within a sentence; in other languages the label keeps its capitals.
std::string labelWithin(std::string_view process, const Parameter& setting) {
    const std::string_view label = translatedLabel(process, setting);
    return label == setting.label ? lowerFirst(label) : std::string(label);
}

constexpr double kAsGiven = 0.02; ///< share by which a given setting may differ

/// Adds the numeric parameters of one list; `own`: that list with the values of the file.
void addFacts(std::vector<SettingFact>& facts, const ParameterList& now, const ParameterList& own,
              std::string_view words, bool ofMachine) {
    for (const Parameter& each : now) {
        const auto* number = std::get_if<float*>(&each.value);
        if (number == nullptr) continue;
        SettingFact fact{std::string(each.key), labelWithin(words, each), std::string(each.unit)};
        fact.value = fact.asked = static_cast<double>(**number);
        if (const Parameter* given = findParameter(own, each.key))
            if (const auto* asked = std::get_if<float*>(&given->value)) fact.asked = static_cast<double>(**asked);
        fact.least = fact.asked - kAsGiven * std::abs(fact.asked);
        fact.most = fact.asked + kAsGiven * std::abs(fact.asked);
        fact.lowest = each.minimum;
        fact.highest = each.maximum;
        fact.ofMachine = ofMachine;
        facts.push_back(std::move(fact));
    }
}

} // namespace

ParameterList describe(RunParameters& r) {
    return {
        {"seconds", "Length", "s", &r.seconds, 0, 3600, "Simulated time of a run without a screen."},
        {"pictures_every", "Pictures every", "s", &r.picturesEvery, 0, 3600, "Interval; 0: one picture at the end."},
        {"width", "Picture width", "pixels", &r.width, 16, 8192, "A wider picture takes longer to draw."},
        {"height", "Picture height", "pixels", &r.height, 16, 8192, "A higher picture takes longer to draw."},
    };
}

ParameterList describe(SourceParameters& s) {
    return {{"source", "Source", "", &s.kind, 0, 1, "Hot melts the metal, cold freezes it.", kSources}};
}

ParameterList describe(CameraParameters& c) {
    return {
        {"azimuth", "Around", "deg", &c.azimuth, -360, 360, "0: in front of the workpiece; 90: on its right."},
        {"elevation", "Over", "deg", &c.elevation, -89, 89, "Height as an angle; 0: level with the table."},
        {"distance", "Distance", "model units", &c.distance, 0.3, 20, "Distance from the middle of the workpiece."},
        {"field_of_view", "Field of view", "deg", &c.fieldOfView, 5, 120, "Angle that the picture's height covers."},
    };
}

ParameterList PictureLook::parameters() {
    ParameterList list = describe(look);
    append(list, describe(camera));
    return list;
}

ParameterList Lesson::metalParameters() {
    ParameterList list;
    if (model == LessonModel::Classic) {
        append(list, describe(setup));
        append(list, describe(metal));
        append(list, describe(source));
    } else {
        append(list, describe(workpiece));
        append(list, processParameters());
    }
    return list;
}

ParameterList Lesson::processParameters() {
    ParameterList list = describe(process);
    for (Parameter& parameter : list)
        for (const ChosenSetting& each : choose)
            if (each.key == parameter.key) {
                parameter.minimum = each.from;
                parameter.maximum = each.to;
            }
    return list;
}

NominalWeld Lesson::nominalWeld() const {
    NominalWeld weld = nominal;
    weld.thickness = static_cast<double>(simulatedWorkpiece(workpiece).thicknessMm) * 1e-3;
    weld.betweenEdges = workpiece.kind == static_cast<int>(WorkpieceKind::Corner);
    return weld;
}

void Lesson::takeStartSettings() {
    const ParameterList list = describe(process); // a start may be outside the limits
    for (const ChosenSetting& each : choose)
        if (each.start && findParameter(list, each.key) != nullptr)
            setParameter(list, each.key, formatNumber(*each.start), "the start of a setting");
}

std::string Lesson::unsetSettings() {
    std::string told;
    const ParameterList list = describe(process);
    for (const ChosenSetting& each : choose) {
        const Parameter* parameter = findParameter(list, each.key);
        if (parameter == nullptr) continue; // another process was chosen
        const double value = parseDouble(parameterText(*parameter)).value_or(each.from);
        if (value >= each.from && value <= each.to) continue;
        if (!told.empty()) told += "; ";
        told += phrase("cue.settings.unset_one", {{"setting", labelWithin(traitsOf(process).name, *parameter)},
                                                  {"least", withDecimalMark(formatNumber(each.from))},
                                                  {"most", withDecimalMark(formatNumber(each.to))},
                                                  {"unit", parameter->unit},
                                                  {"value", withDecimalMark(parameterText(*parameter))}});
    }
    return told.empty() ? told : phrase("cue.settings.unset", {{"settings", told}});
}

std::vector<SettingFact> Lesson::settingFacts() const {
    std::vector<SettingFact> facts;
    if (model != LessonModel::Weld) return facts;
    OwnValues now{workpiece, process}, given = own.value_or(now);
    const bool comparable = given.process.kind == process.kind; // settings of another process have other meanings
    addFacts(facts, describe(now.process), comparable ? describe(given.process) : describe(now.process),
             traitsOf(process).name, true);
    addFacts(facts, describe(now.workpiece), describe(given.workpiece), "start", false);
    for (SettingFact& fact : facts)
        for (const ChosenSetting& each : choose)
            if (fact.ofMachine && fact.key == each.key) {
                fact.least = fact.lowest = each.from;
                fact.most = fact.highest = each.to;
            }
    return facts;
}

std::string Lesson::chosenText() {
    std::string told;
    const ParameterList list = describe(process);
    for (const ChosenSetting& each : choose)
        if (const Parameter* parameter = findParameter(list, each.key))
            told += (told.empty() ? "" : ", ") + lowerFirst(parameter->label) + " " + parameterText(*parameter) +
                    (parameter->unit.empty() ? "" : " " + std::string(parameter->unit));
    return told;
}

ParameterList Lesson::parameters() {
    ParameterList list = describe(run);
    append(list, metalParameters());
    append(list, describe(surface));
    append(list, describe(camera));
    append(list, describe(look));
    return list;
}

void Lesson::set(std::string_view name, std::string_view value, std::string_view where) {
    setParameter(parameters(), name, value, where);
    for (PictureLook& picture : pictures)
        if (const ParameterList list = picture.parameters(); findParameter(list, name) != nullptr)
            setParameter(list, name, value, where);
}

} // namespace meltpool
