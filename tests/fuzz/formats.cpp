#include "tests/fuzz/formats.hpp"

#include "app/commands/command_line.hpp"
#include "app/library/best_scores.hpp"
#include "app/session/lesson_session.hpp"
#include "app/session/settings.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/metal/material/materials.hpp"
#include "core/training/attempt/recording_csv.hpp"
#include "core/training/attempt/recording_reader.hpp"
#include "core/training/judging/verdict.hpp"
#include "core/training/lesson/changed_path.hpp"
#include "core/training/lesson/lesson.hpp"
#include "core/training/lesson/lesson_check.hpp"
#include "core/training/lesson/recorded_attempt.hpp"
#include "core/training/lesson/what_if.hpp"
#include "core/validation/validation_case.hpp"
#include "core/weld/torch/torch_path.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/recording_bytes.hpp"
#include "xr/pivot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <stdexcept>

namespace meltpool::test {

namespace {

namespace fs = std::filesystem;
using Texts = std::vector<std::string>;

void require(bool sound, const std::string& what) {
    if (!sound) throw std::logic_error("taken, but " + what);
}

void addFolder(Texts& texts, const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end()); // folders have different orders on different machines
    for (const fs::path& file : files)
        texts.push_back(readTextFile(file));
}

/// Returns the stored texts of this format and those of a folder of the source tree.
Texts corpusOf(const char* name, const char* shipped) {
    Texts texts;
    addFolder(texts, testFolder() / "fuzz" / "corpus" / name);
    if (shipped != nullptr) addFolder(texts, testFolder().parent_path() / shipped);
    return texts;
}

/// Checks that every value reads back from its own text, so that it is in its range.
void requireInRange(const ParameterList& list) {
    for (const Parameter& p : list)
        setParameter(list, p.key, parameterText(p), "taken, but out of range");
}

Texts lessonTexts() {
    Texts texts = corpusOf("lesson", "app/data/lessons");
    const std::string paths = (testFolder().parent_path() / "app" / "data" / "paths").string();
    for (std::string& text : texts)
        if (const size_t at = text.find("../paths"); at != std::string::npos) text.replace(at, 8, paths);
    return texts;
}

Answer readLessonFile(const fs::path& file) {
    Lesson lesson = readLesson(file);
    requireInRange(lesson.parameters());
    require(!lesson.pictures.empty(), "a lesson has no picture");
    return Answer::taken;
}

void requireSound(const Property& property) {
    for (const double kelvin : {0.0, 300.0, 1800.0, 1e5})
        require(std::isfinite(property.at(kelvin)), "a property is not finite");
    require(std::isfinite(property.integral(0, 1e4)), "a property's integral is not finite");
}

Answer readMaterialFile(const fs::path& file) {
    const Material m = readMaterial(file);
    for (const Property* property :
         {&m.solidDensity, &m.liquidDensity, &m.solidConductivity, &m.liquidConductivity, &m.solidSpecificHeat,
          &m.liquidSpecificHeat, &m.viscosity, &m.expansion, &m.surfaceTension, &m.emissivity})
        requireSound(*property);
    require(m.tensionAt(m.solidus) > 0 && std::isfinite(m.tensionSlopeAt(m.solidus)), "it has no surface tension");
    require(m.solidus > 0 && m.liquidus >= m.solidus && m.latentHeat >= 0, "it does not melt");
    require(m.boilingPoint == 0 || m.boilingPoint > m.liquidus, "it boils before it melts");
    return Answer::taken;
}

/// Checks that the limits are numbers and that a weld can be judged by them.
Answer readAcceptanceFile(const fs::path& file) {
    const Acceptance acceptance = readAcceptance(file);
    require(!acceptance.items.empty(), "an acceptance has no item");
    for (const AcceptanceItem& item : acceptance.items) {
        require(!item.appliesTo.empty(), "an item applies to nothing");
        require(std::isfinite(item.formula.at({8, 4, 6, 5})), "a limit is not finite");
        if (item.shortOnes) require(std::isfinite(item.shortOnes->allowed(40)), "an allowance is not finite");
    }
    NominalWeld nominal;
    nominal.thickness = 6e-3;
    nominal.leg = 5e-3;
    Section section;
    section.layers = 1;
    section.fillet.emplace().toes[0].place = 5e-3;
    section.fusedFaces.emplace();
    const WeldMeasures weld = summarise({stationOf(section, WeldKind::fillet, 0)}, WeldKind::fillet, 2e-3, 1e-3);
    for (const VerdictItem& item : judge(weld, acceptance, nominal).items)
        require(!item.value || std::isfinite(*item.value), "a verdict's value is not finite");
    return Answer::taken;
}

Answer readCaseFile(const fs::path& file) {
    const ValidationCase one = readValidationCase(file);
    require(one.kind != nullptr && one.spacing > 0 && std::isfinite(one.time), "a case has no size");
    for (const auto& [name, value] : one.numbers)
        require(std::isfinite(value), name + " is not finite");
    for (const auto& [name, values] : one.lists)
        for (const double value : values)
            require(std::isfinite(value), name + " is not finite");
    return Answer::taken;
}

void requireSound(const TorchPath& path) {
    require(std::isfinite(path.duration()), "a path's time is not finite");
    for (int i = -1; i <= 21; ++i) {
        const TorchSample s = path.sample(path.duration() * i / 20);
        require(std::isfinite(s.tip.x + s.tip.y + s.tip.z), "a place is not finite");
        require(std::abs(glm::length(s.orientation) - 1) < 1e-3F, "an orientation is not of length 1");
        require(s.trigger >= 0 && s.trigger <= 1, "a trigger is out of range");
    }
}

Answer readPath(const fs::path& file) {
    requireSound(TorchPath::read(file));
    return Answer::taken;
}

/// Reads the record's own lines and applies them to its lesson.
Answer readRecord(const fs::path& file) {
    static const Lesson standard = loadLesson(std::string(kDefaultLesson));
    const auto attempt = readRecordedAttempt(file);
    if (!attempt) return Answer::refused;
    for (const RecordedChange& change : attempt->changes)
        require(change.steps <= attempt->rows && change.line > 0, "a change stands behind the end");
    Lesson lesson = standard;
    repeatAttempt(lesson, *attempt);
    requireInRange(lesson.metalParameters());
    return readPath(file);
}

Texts recordingTexts() {
    Texts texts;
    texts.push_back(recordingOf(std::string(kDefaultLesson), 4));
    texts.push_back(recordingOf(std::string(kDefaultLesson), 40));
    texts.push_back(texts.back().substr(0, texts.back().size() / 2));
    RecordingBytes wentBack;
    wentBack.head(recordedHead(std::string(kDefaultLesson)));
    for (int i = 1; i <= 6; ++i)
        wentBack.step(recordedStep(i));
    wentBack.checkpoint({2, 0}, "a state").note(FrameKind::event, 3, "redo", "3").checkpoint({5, 0}, "another");
    texts.push_back(wentBack.step(recordedStep(4)).bytes());
    return texts;
}

/// Reads the file as it is and with corrected hashes; else every damage ends at the first hash.
Answer readRecordingFile(const fs::path& file) {
    static const Lesson standard = loadLesson(std::string(kDefaultLesson));
    const fs::path sealed = fs::path(file).replace_filename("sealed.meltrec");
    std::ofstream(sealed, std::ios::binary | std::ios::trunc) << resealed(readTextFile(file));
    Answer answer = Answer::refused;
    for (const fs::path& each : {file, sealed}) {
        try {
            const Recording recording = readRecording(each);
            require(!recording.stateSentence().empty(), "nothing is told of it");
            for (const RecordingCheckpoint& checkpoint : recording.checkpoints)
                require(readCheckpoint(each, checkpoint).size() == checkpoint.size, "a checkpoint is not whole");
            if (recording.frames > 0) readRecordingSummary(each);
            require(!recordingCsv(recording).empty(), "its table is empty");
            Lesson lesson = standard;
            takeTorch(lesson, each);
            requireInRange(lesson.metalParameters());
            requireSound(lesson.torch);
            answer = Answer::taken;
        } catch (const InputError&) {
            if (each == sealed && answer == Answer::refused) throw;
        }
    }
    return answer;
}

/// Returns the stored checks and those of the shipped lessons, which find their paths from anywhere.
Texts checkTexts() {
    Texts texts = corpusOf("check", nullptr);
    std::vector<fs::path> folders;
    for (const auto& entry : fs::directory_iterator(testFolder() / "checks"))
        if (entry.is_directory()) folders.push_back(entry.path());
    std::sort(folders.begin(), folders.end());
    for (const fs::path& folder : folders) {
        Texts found;
        addFolder(found, folder);
        for (std::string& text : found) {
            if (text.find("[expect]") == std::string::npos) continue; // a torch path
            constexpr std::string_view kTorch = "torch = \"";
            if (const size_t at = text.find(kTorch); at != std::string::npos)
                text.insert(at + kTorch.size(), folder.string() + "/");
            texts.push_back(std::move(text));
        }
    }
    return texts;
}

/// Checks that the lesson is sound, that the bent path has places, and that an empty attempt can be compared with it.
Answer readCheckFile(const fs::path& file) {
    LessonCheck check = readLessonCheck(file, testFolder().parent_path() / "app" / "data" / "lessons");
    requireInRange(check.lesson.parameters());
    require(!check.expectations.empty(), "a check expects nothing");
    require(check.lesson.model == LessonModel::Weld, "a check is of no weld");
    const Seam seam = seamOf(check.lesson.workpiece);
    const PerturbedPath path(check.lesson.torch, seam, check.bend);
    for (int i = 0; i <= 20; ++i) {
        const TorchSample s = path.sample(check.lesson.torch.duration() * check.bend.time * i / 20);
        require(std::isfinite(s.tip.x + s.tip.y + s.tip.z), "a bent path's place is not finite");
        require(std::abs(glm::length(s.orientation) - 1) < 1e-3F, "a bent path's orientation is not of length 1");
    }
    const std::vector<CheckedValue> values = checkJudgement(check, {});
    require(values.size() == check.expectations.size(), "not every expectation is looked at");
    for (const CheckedValue& value : values)
        require(!value.passed || value.found == value.expected, "a value passes that is not there");
    return Answer::taken;
}

Texts settingsTexts() {
    Texts texts = corpusOf("settings", nullptr);
    Lesson lesson = loadLesson(std::string(kDefaultLesson));
    LessonSections sections(lesson);
    std::vector<SettingsSection> list;
    for (const ParameterSection* each : sections.all())
        list.push_back({each->name, each->parameters});
    texts.push_back(settingsText(list));
    return texts;
}

Answer readSettings(const fs::path& file) {
    static const Lesson standard = loadLesson(std::string(kDefaultLesson));
    Lesson lesson = standard;
    LessonSections sections(lesson);
    std::vector<SettingsSection> list;
    for (const ParameterSection* each : sections.all())
        list.push_back({each->name, each->parameters});
    const std::vector<std::string> faults = loadSettings(file, list);
    for (const std::string& fault : faults)
        require(fault == printable(fault, 3000), "a fault is not printable: " + printable(fault, 300));
    for (const auto& entry : fs::directory_iterator(file.parent_path()))
        fs::remove(entry.path());
    for (const SettingsSection& section : list)
        requireInRange(section.parameters);
    return faults.empty() ? Answer::taken : Answer::refused;
}

Answer readBestScores(const fs::path& file) {
    const BestScores scores(file);
    for (const std::string& fault : scores.faults())
        require(fault == printable(fault, 3000), "a fault is not printable: " + printable(fault, 300));
    for (const char* lesson : {"gmaw-bead", "tee-fillet"})
        if (const BestScore* best = scores.find(lesson))
            require(best->score >= 0 && best->score <= 100 && best->zoom >= 1, "a score is out of range");
    for (const auto& entry : fs::directory_iterator(file.parent_path()))
        fs::remove(entry.path());
    return scores.faults().empty() ? Answer::taken : Answer::refused;
}

Answer readTip(const fs::path& file) {
    const xr::TipCalibration tip = xr::readCalibration(file);
    require(glm::length(tip.offset) < 4, "the tip is metres from the hand");
    require(std::abs(glm::length(tip.orientation) - 1) < 1e-3F, "the orientation is not of length 1");
    require(tip.residualMm >= 0, "a residual is negative");
    return Answer::taken;
}

/// Splits the text into words, one per line.
std::vector<std::string> wordsIn(const std::string& text) {
    std::vector<std::string> words;
    for (const std::string_view word : splitText(text, '\n'))
        if (!word.empty()) words.emplace_back(word);
    return words;
}

Answer readWords(const fs::path& file) {
    checkCommandLine(wordsIn(readTextFile(file)));
    return Answer::taken;
}

/// A short motion of the hand along the seam with a burning arc.
std::vector<AttemptStep> anySteps() {
    std::vector<AttemptStep> steps(40);
    for (size_t i = 0; i < steps.size(); ++i) {
        const auto moved = static_cast<float>(i);
        TorchSample& torch = steps[i].torch;
        torch.time = static_cast<double>(i + 1) / 90;
        torch.tip = {-0.01F + 1e-4F * moved, 0.003F + 1e-4F * std::sin(moved), 0.002F};
        torch.orientation = heldOrientation(0.8, 0.2, {1, 0, 0});
        torch.trigger = 1;
        steps[i].burntOff = 1e-5 * static_cast<double>(i);
        steps[i].burned = i > 3;
    }
    return steps;
}

void requireSound(const ChangedPath& path) {
    require(std::isfinite(path.duration()) && path.duration() > 0, "a changed path's time is not finite");
    for (int i = -1; i <= 21; ++i) {
        const TorchSample s = path.sample(path.duration() * i / 20, 1e-4);
        require(std::isfinite(s.tip.x + s.tip.y + s.tip.z), "a changed place is not finite");
        require(std::abs(glm::length(s.orientation) - 1) < 1e-3F, "a changed orientation is not of length 1");
    }
}

/// Reads wishes, one per line, for an attempt in one of four lessons, which the text's length selects.
Answer readWishes(const fs::path& file) {
    static const std::array<Lesson, 4> lessons{loadLesson("gmaw-bead"), loadLesson("gtaw-rod"),
                                               loadLesson("tee-fillet"), loadLesson("classic")};
    const std::string text = readTextFile(file);
    Lesson lesson = lessons[text.size() % lessons.size()];
    const std::vector<std::string> wishes = wordsIn(text);
    const WhatIf whatIf = readWhatIf(wishes, lesson);
    require(whatIf.asked.size() == wishes.size(), "not every wish was taken");
    const PathChange change = whatIf.path.resolved(5e-3);
    require(change.speed >= 0.1 && change.speed <= 10, "a speed is out of range");
    RecordedAttempt& recorded = lesson.recorded.emplace();
    recorded.changes = {{20, "no-key", "1", 1}};
    recorded.events = {{30, "torch", "lost"}};
    takeWhatIf(lesson, whatIf, change.speed);
    require(recorded.changes[0].steps <= 200 && recorded.events[0].steps <= 300, "a change stands behind the end");
    requireInRange(lesson.metalParameters());
    if (lesson.model == LessonModel::Weld) requireSound(ChangedPath(anySteps(), seamOf(lesson.workpiece), change));
    return Answer::taken;
}

const std::array<Format, 14> kFormats{{
    {"lesson", "lesson.toml", lessonTexts, readLessonFile},
    {"material", "material.toml", [] { return corpusOf("material", "app/data/materials"); }, readMaterialFile},
    {"acceptance", "acceptance.toml", [] { return corpusOf("acceptance", "app/data/acceptance"); }, readAcceptanceFile},
    {"validation case", "case.toml", [] { return corpusOf("case", "tests/validation/cases"); }, readCaseFile},
    {"recorded torch path", "path.csv", [] { return corpusOf("torch-csv", "tests/data/brought"); }, readPath},
    {"record", "record.csv", [] { return corpusOf("record", nullptr); }, readRecord},
    {"recording", "attempt.meltrec", recordingTexts, readRecordingFile},
    {"authored torch path", "path.toml", [] { return corpusOf("torch-toml", "app/data/paths"); }, readPath},
    {"check", "check.toml", checkTexts, readCheckFile},
    {"settings", "settings.toml", settingsTexts, readSettings},
    {"best scores", "best-scores.toml", [] { return corpusOf("best-scores", nullptr); }, readBestScores},
    {"torch tip", "torch-tip.txt", [] { return corpusOf("torch-tip", nullptr); }, readTip},
    {"command line", "words.txt", [] { return corpusOf("command-line", nullptr); }, readWords},
    {"what-if", "wishes.txt", [] { return corpusOf("what-if", nullptr); }, readWishes},
}};

} // namespace

std::span<const Format> formats() {
    return kFormats;
}

} // namespace meltpool::test
