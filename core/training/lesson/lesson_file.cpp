#include "core/training/lesson/lesson.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/base/toml_table.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <set>

namespace meltpool {

namespace {

/// Sets every described value that is in the table.
void readParameters(TomlTable& table, const ParameterList& list) {
    for (const Parameter& parameter : list) {
        if (!table.has(parameter.key)) continue;
        const std::string where = table.file().string() + ":" + std::to_string(table.lineOf(parameter.key));
        setParameter(list, parameter.key, table.valueText(parameter.key), where);
    }
}

/// Reads [name] if the file has it; every key in it must be described.
void readGroup(TomlTable& root, std::string_view name, const ParameterList& list) {
    root.allow(name); // a known key even if this file omits it
    if (!root.has(name)) return;
    TomlTable group = root.table(name);
    readParameters(group, list);
    // A key without a value in the file is allowed, too.
    for (const Parameter& parameter : list)
        group.allow(parameter.key);
    group.finish();
}

/// Reads [process]: the kind first, as it decides the settings. A setting that the process no longer has is refused,
/// naming its replacement.
void readProcess(TomlTable& root, ProcessSettings& settings) {
    root.allow("process");
    if (!root.has("process")) return;
    TomlTable group = root.table("process");
    const std::string where = group.file().string() + ":" + std::to_string(group.lineOf("process"));
    if (group.has("process")) {
        const std::string kind = group.text("process");
        setParameter(describe(settings), "process", std::string(presentProcessName(kind)), where);
    }
    const ParameterList list = describe(settings);
    for (const Parameter& parameter : list)
        if (parameter.key != "process" && group.has(parameter.key))
            setParameter(list, parameter.key, group.valueText(parameter.key),
                         group.file().string() + ":" + std::to_string(group.lineOf(parameter.key)));
    for (const std::string& key : group.keys())
        if (const std::string_view successor = successorOf(settings, key); !successor.empty())
            group.fail(key, "is no longer a setting of this process; " + std::string(successor));
    for (const Parameter& parameter : list)
        group.allow(parameter.key);
    group.finish();
}

/// Reads the limits of one setting that the trainee chooses.
ChosenSetting readLimits(TomlTable table, const Parameter& setting) {
    if (!std::holds_alternative<float*>(setting.value))
        table.fail("from", "limits " + quote(setting.key) + ", which is not a number; expected a numeric setting");
    ChosenSetting chosen{std::string(setting.key), 0, 0, {}};
    chosen.from = table.number("from", {setting.minimum, setting.maximum});
    chosen.to = table.number("to", {chosen.from, setting.maximum});
    table.allow("start");
    if (table.has("start")) chosen.start = table.number("start", {setting.minimum, setting.maximum});
    table.finish();
    return chosen;
}

/// Reads [choose]: the settings that the trainee sets, and their limits. The lesson's own values must be within them.
void readChoose(TomlTable& root, Lesson& lesson) {
    root.allow("choose");
    if (!root.has("choose")) return;
    TomlTable group = root.table("choose");
    for (const Parameter& setting : describe(lesson.process)) {
        if (setting.onlyAtStart) continue;
        group.allow(setting.key);
        if (!group.has(setting.key)) continue;
        const ChosenSetting chosen = readLimits(group.table(setting.key), setting);
        const double own = parseDouble(parameterText(setting)).value_or(chosen.from);
        if (own < chosen.from || own > chosen.to)
            group.fail(setting.key, "goes from " + formatNumber(chosen.from) + " to " + formatNumber(chosen.to) +
                                        "; expected limits around the lesson's own value, " + formatNumber(own));
        lesson.choose.push_back(chosen);
    }
    group.finish();
}

/// Calls `read` with the value of `key`; the message of a fault names this file's line too.
template <class Read>
void readNamed(const TomlTable& table, std::string_view key, const Read& read) {
    try {
        read();
    } catch (const InputError& fault) {
        table.fail(key, fault.what());
    }
}

/// Reads [workpiece]. A metal of its own is a file in the lesson's folder; it is read once here to find its faults.
void readWorkpiece(TomlTable& root, WorkpieceParameters& workpiece) {
    readGroup(root, "workpiece", describe(workpiece));
    if (!root.has("workpiece")) return;
    const TomlTable group = root.table("workpiece");
    if (const auto fault = workpieceFault(workpiece)) group.fail(fault->key, fault->sentence);
    if (!group.has("metal")) return;
    if (workpiece.metal.ends_with(".toml"))
        workpiece.metal = (group.file().parent_path() / workpiece.metal).lexically_normal().string();
    readNamed(group, "metal", [&] { workpieceMaterial(workpiece); });
}

bool isFileNamePart(const std::string& name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
    });
}

void readSection(TomlTable& table, const Lesson& lesson, PictureLook& picture) {
    constexpr std::string_view kKey = "section_at_mm", kMeasures = "measures";
    table.allow(kKey);
    picture.measures = table.flag(kMeasures, false);
    if (picture.measures && !table.has(kKey)) table.fail(kMeasures, "expected section_at_mm too");
    if (!table.has(kKey)) return;
    if (lesson.model != LessonModel::Weld) table.fail(kKey, "expected a lesson whose model is weld");
    picture.sectionAt = static_cast<float>(table.number(kKey, {-1000, 1000}) * 1e-3);
}

void readPictures(TomlTable& root, Lesson& lesson) {
    std::set<std::string> names;
    for (TomlTable& table : root.tables("picture")) {
        PictureLook picture{table.text("name"), lesson.look, lesson.camera};
        if (!isFileNamePart(picture.name)) table.fail("name", "expected letters, digits, '-' and '_' only");
        if (!names.insert(picture.name).second) table.fail("name", "appears twice; expected a different name");
        const ParameterList list = picture.parameters();
        readParameters(table, list);
        for (const Parameter& parameter : list)
            table.allow(parameter.key);
        readSection(table, lesson, picture);
        table.finish();
        lesson.pictures.push_back(std::move(picture));
    }
    if (lesson.pictures.empty()) lesson.pictures.push_back({"picture", lesson.look, lesson.camera});
}

/// Reads the entries, other than the title, that lists of lessons show and use.
void readListing(TomlTable& root, Lesson& lesson) {
    const double level = root.number("level", {1, kMostLevel}, 0);
    lesson.level = static_cast<int>(level);
    if (lesson.level != level) root.fail("level", "expected a whole number from 1 to " + std::to_string(kMostLevel));
    lesson.next = root.text("next", "");
    if (!lesson.next.empty() && !isFileNamePart(lesson.next))
        root.fail("next", "is " + quote(lesson.next) + "; expected the name of a lesson: letters, digits, '-' and '_'");
    const std::string picture = root.text("list_picture", "pictures/" + lesson.key + ".png");
    lesson.listPicture = (lesson.file.parent_path() / picture).lexically_normal();
}

/// Reads [technique], the bands that the hand is judged by.
void readTechnique(TomlTable& root, Lesson& lesson) {
    root.allow("technique");
    if (!root.has("technique")) return;
    TomlTable group = root.table("technique");
    lesson.technique = readTechniqueBands(group, traitsOf(lesson.process).distance, seamOf(lesson.workpiece));
    lesson.technique->tee = lesson.workpiece.kind == static_cast<int>(WorkpieceKind::Tee);
    group.finish();
}

/// Reads [cues]: the cues that a trainee may see, by default all; and the permission of a ghost, by default given if
/// any cue is.
void readCues(TomlTable& root, Lesson& lesson) {
    root.allow("cues");
    if (!root.has("cues")) return;
    TomlTable group = root.table("cues");
    group.allow("allowed");
    if (group.has("allowed")) {
        lesson.cues = {};
        for (const std::string& name : group.texts("allowed")) {
            const auto kind = findCue(name);
            if (!kind) group.fail("allowed", "has " + quote(name) + "; expected some of " + CueSet::all().names());
            lesson.cues.set(*kind);
        }
    }
    lesson.ghost = group.flag("ghost", !lesson.cues.empty());
    group.finish();
}

/// Reads [acceptance]: the limits for judging the weld, and its nominal sizes. An acceptance of its own is a file in
/// the lesson's folder.
void readAcceptanceOf(TomlTable& root, Lesson& lesson) {
    root.allow("acceptance");
    if (!root.has("acceptance")) return;
    constexpr double kMm = 1e-3;
    constexpr NumberRange kSize{0.5, 100};
    TomlTable group = root.table("acceptance");
    std::string name = group.text("use");
    if (name.ends_with(".toml")) name = (group.file().parent_path() / name).lexically_normal().string();
    readNamed(group, "use", [&] { lesson.acceptance = findAcceptance(name); });
    for (const auto& [key, value] : {std::pair("throat_mm", &lesson.nominal.throat), {"leg_mm", &lesson.nominal.leg}}) {
        group.allow(key);
        if (group.has(key)) *value = group.number(key, kSize) * kMm;
    }
    group.finish();
}

} // namespace

Lesson readLesson(const std::filesystem::path& file) {
    const toml::table parsed = parseTomlFile(file);
    TomlTable root(parsed, file);
    Lesson lesson;
    lesson.file = file;
    lesson.key = file.stem().string();
    lesson.title = root.text("title", lesson.key);
    lesson.text = inChosenUnits(root.text("text", ""));
    readListing(root, lesson);
    const std::string model = root.text("model", "classic");
    if (model != "classic" && model != "weld") root.fail("model", "is " + quote(model) + "; expected classic or weld");
    lesson.model = model == "weld" ? LessonModel::Weld : LessonModel::Classic;
    readGroup(root, "run", describe(lesson.run));
    if (lesson.model == LessonModel::Classic) {
        readGroup(root, "start", describe(lesson.setup));
        readGroup(root, "metal", describe(lesson.metal));
        readGroup(root, "source", describe(lesson.source));
    } else {
        readWorkpiece(root, lesson.workpiece);
        readProcess(root, lesson.process);
        readChoose(root, lesson);
        lesson.own = {lesson.workpiece, lesson.process};
        readTechnique(root, lesson);
        readAcceptanceOf(root, lesson);
        readCues(root, lesson);
        // Metal on a lattice, with at least one particle a cell: its flat faces must look flat.
        lesson.surface.kernel = static_cast<int>(SurfaceKernel::smooth);
        lesson.surface.influence = 3;
    }
    readGroup(root, "surface", describe(lesson.surface));
    readGroup(root, "camera", describe(lesson.camera));
    readGroup(root, "look", describe(lesson.look));
    readPictures(root, lesson);
    root.allow("torch");
    if (root.has("torch")) {
        lesson.torchFile = file.parent_path() / root.text("torch");
        readNamed(root, "torch", [&] { lesson.torch = TorchPath::read(lesson.torchFile); });
    }
    root.allow("expect"); // allowed in a lesson that is a check itself, see readCheck()
    root.finish();
    return lesson;
}

std::vector<std::filesystem::path> lessonSources(const Lesson& lesson) {
    std::vector<std::filesystem::path> files{lesson.file};
    if (!lesson.torchFile.empty()) files.push_back(lesson.torchFile);
    if (lesson.workpiece.metal.ends_with(".toml")) files.emplace_back(lesson.workpiece.metal);
    if (lesson.acceptance) files.push_back(lesson.acceptance->file);
    return files;
}

std::vector<std::string> lessonNames(const std::filesystem::path& folder) {
    return tomlFileNames(folder, "the folder of lessons");
}

} // namespace meltpool
