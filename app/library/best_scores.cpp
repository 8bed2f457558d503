#include "app/library/best_scores.hpp"

#include "app/platform/aside_file.hpp"
#include "core/base/error.hpp"
#include "core/base/file_lock.hpp"
#include "core/base/output_file.hpp"
#include "core/base/text.hpp"
#include "core/base/toml_table.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace meltpool {

namespace fs = std::filesystem;

namespace {

constexpr NumberRange kScore{0, 100};
constexpr NumberRange kZoom{1, 10};
constexpr NumberRange kRealTime{0, 1};
constexpr size_t kMostBytes = 2000; ///< bytes of a fault's sentence
constexpr size_t kMostChosen = 200; ///< bytes of the chosen settings
constexpr size_t kMostGhost = 20;   ///< bytes of a ghost's name

CueSet readCues(TomlTable& table) {
    CueSet cues;
    table.allow("cues");
    if (!table.has("cues")) return cues;
    for (const std::string& name : table.texts("cues")) {
        const auto kind = findCue(name);
        if (!kind) table.fail("cues", "has " + quote(name) + "; expected some of " + CueSet::all().names());
        cues.set(*kind);
    }
    return cues;
}

/// Reads `practised`: good attempts by quantity.
CueSkill readSkill(TomlTable& table) {
    CueSkill skill;
    table.allow("practised");
    if (!table.has("practised")) return skill;
    TomlTable counts = table.table("practised");
    for (const CuedQuantity& cued : cuedQuantities())
        skill.setGood(cued.quantity, static_cast<int>(counts.number(cued.name, {0, CueSkill::kMastered}, 0)));
    counts.finish();
    return skill;
}

std::string cueList(CueSet cues) {
    std::string list;
    for (const CueKind kind : kCueKinds)
        if (cues.has(kind)) list += (list.empty() ? "\"" : ", \"") + std::string(cueName(kind)) + "\"";
    return "[" + list + "]";
}

std::string skillTable(const CueSkill& skill) {
    std::string table;
    for (const CuedQuantity& cued : cuedQuantities())
        if (const int good = skill.good(cued.quantity); good > 0)
            table += (table.empty() ? "" : ", ") + std::string(cued.name) + " = " + std::to_string(good);
    return "{ " + table + " }";
}

BestScore readBest(TomlTable& table) {
    BestScore best;
    best.score = table.number("score", kScore);
    best.accepted = table.flag("accepted", false);
    best.zoom = table.number("zoom", kZoom, 1);
    best.forScore = table.flag("for_score", false);
    best.guided = table.flag("guided", false);
    best.swung = table.flag("swung", false);
    best.changed = table.flag("changed", false);
    best.realTime = table.number("real_time", kRealTime, 1);
    best.cues = readCues(table);
    best.ghost = printable(table.text("ghost", ""), kMostGhost);
    best.chosen = printable(table.text("chosen", ""), kMostChosen);
    return best;
}

/// Text in TOML quotes, also usable as a key.
std::string tomlText(const std::string& name) {
    std::string quoted = "\"";
    for (const char c : name) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    return quoted + "\"";
}

std::string flag(bool value) {
    return value ? "true" : "false";
}

std::string entriesOf(const BestScore& best) {
    return "score = " + formatNumber(best.score) + "\naccepted = " + flag(best.accepted) +
           "\nzoom = " + formatNumber(best.zoom) + "\nfor_score = " + flag(best.forScore) +
           "\nguided = " + flag(best.guided) + (best.swung ? "\nswung = true" : "") +
           "\nchanged = " + flag(best.changed) + "\nreal_time = " + formatNumber(static_cast<float>(best.realTime)) +
           "\ncues = " + cueList(best.cues) + "\n" +
           (best.ghost.empty() ? "" : "ghost = " + tomlText(best.ghost) + "\n") +
           (best.chosen.empty() ? "" : "chosen = " + tomlText(best.chosen) + "\n");
}

/// Table of a lesson: its best score in practice and its skill, and below it the best score in tests.
std::string tableOf(const std::string& lesson, const BestScore* best, const BestScore* test, const CueSkill& skill) {
    std::string text = "\n[" + tomlText(lesson) + "]\n" + (best == nullptr ? std::string() : entriesOf(*best)) +
                       "practised = " + skillTable(skill) + "\n";
    if (test != nullptr) text += "[" + tomlText(lesson) + ".test]\n" + entriesOf(*test);
    return text;
}

const BestScore* scoreIn(const std::map<std::string, BestScore, std::less<>>& scores, std::string_view lesson) {
    const auto found = scores.find(lesson);
    return found == scores.end() ? nullptr : &found->second;
}

void takeBetter(std::map<std::string, BestScore, std::less<>>& own,
                const std::map<std::string, BestScore, std::less<>>& others) {
    for (const auto& [lesson, theirs] : others)
        if (const BestScore* best = scoreIn(own, lesson); best == nullptr || theirs.score > best->score)
            own[lesson] = theirs;
}

CueSkill skillIn(const std::map<std::string, CueSkill, std::less<>>& skills, std::string_view lesson) {
    const auto found = skills.find(lesson);
    return found == skills.end() ? CueSkill() : found->second;
}

/// Adds the attempts from `before` to `after` to `skill`, which counts those of another program too.
CueSkill practisedOn(CueSkill skill, const CueSkill& before, const CueSkill& after) {
    for (const CuedQuantity& cued : cuedQuantities()) {
        const int more = after.good(cued.quantity) - before.good(cued.quantity);
        skill.setGood(cued.quantity, std::clamp(skill.good(cued.quantity) + more, 0, CueSkill::kMastered));
    }
    return skill;
}

} // namespace

std::optional<BestScore> countedScore(const Judgement& judgement) {
    if (!judgement.score || !judgement.score->scored) return std::nullopt;
    BestScore best;
    best.score = std::clamp(judgement.score->total, kScore.minimum, kScore.maximum);
    best.accepted = judgement.verdict && judgement.verdict->accepted;
    best.realTime = std::clamp(judgement.realTime, kRealTime.minimum, kRealTime.maximum);
    return best;
}

std::string bestScoreText(const BestScore& best) {
    std::string text =
        phrase(best.forScore ? "best.test" : "best.score", {{"score", PhraseNumber(std::round(best.score))}});
    const auto add = [&](std::string_view more) {
        text += phrase("list.separator");
        text += more;
    };
    if (best.accepted) add(phrase("best.accepted"));
    if (best.zoom > 1) add(phrase("best.zoom", {{"zoom", withDecimalMark(formatNumber(best.zoom))}}));
    if (best.changed) add(phrase("best.changed"));
    const bool helped = best.guided || best.swung || !best.cues.empty() || !best.ghost.empty();
    return helped ? phrase("best.with_help", {{"best", text}}) : text;
}

BestScores::BestScores(fs::path file) : file_(std::move(file)), content_(load(false)), written_(content_.skills) {}

/// Reads the file. A missing one is empty; a faulty one is moved aside and its faults are noted, with `again` only the
/// new ones.
BestScores::Content BestScores::load(bool again) {
    std::error_code unreadable;
    if (!fs::exists(file_, unreadable)) return {};
    const size_t before = faults_.size();
    Content content;
    bool whole = false;
    try {
        // A pipe would block until its writer opens it.
        if (!isPlainFile(file_)) throw InputError(file_, 0, "is no file of best scores; expected a text file");
        content = read();
    } catch (const std::exception& fault) {
        faults_.push_back(printable(fault.what(), kMostBytes) + "; the best scores so far are not shown");
        whole = true;
    }
    if (faults_.size() == before) return content;
    const AsideFile aside = keepAside(file_, whole);
    writable_ = aside.kept;
    if (aside.before && again) {
        faults_.resize(before);
        return content;
    }
    faults_.push_back(aside.sentence + (aside.kept ? "" : " Best scores are not kept from now on."));
    return content;
}

/// Reads a lesson's table. In a file of an earlier version its score may be one of a test.
void BestScores::readLesson(TomlTable& table, const std::string& lesson, Content& content) {
    table.allow("test");
    if (table.has("test")) {
        TomlTable test = table.table("test");
        BestScore best = readBest(test);
        best.forScore = true;
        test.finish();
        content.tests.emplace(lesson, best);
    }
    if (!table.has("test") || table.has("score")) {
        const BestScore best = readBest(table);
        (best.forScore ? content.tests : content.best).emplace(lesson, best);
    }
    content.skills.emplace(lesson, readSkill(table));
    table.finish();
}

BestScores::Content BestScores::read() {
    const toml::table parsed = parseTomlFile(file_);
    TomlTable root(parsed, file_);
    Content content;
    for (const std::string& lesson : root.keys()) {
        try {
            TomlTable table = root.table(lesson);
            Content one;
            readLesson(table, lesson, one);
            content.best.merge(one.best);
            content.tests.merge(one.tests);
            content.skills.merge(one.skills);
        } catch (const InputError& fault) {
            faults_.push_back(printable(fault.what(), kMostBytes));
        }
    }
    return content;
}

const BestScore* BestScores::find(std::string_view lesson) const {
    return scoreIn(content_.best, lesson);
}

const BestScore* BestScores::findTest(std::string_view lesson) const {
    return scoreIn(content_.tests, lesson);
}

bool BestScores::offer(const std::string& lesson, const BestScore& score) {
    Scores& scores = score.forScore ? content_.tests : content_.best;
    if (const BestScore* known = scoreIn(scores, lesson); known != nullptr && known->score >= score.score) return false;
    scores[lesson] = score;
    save();
    return scores[lesson].score <= score.score; // another program may have written a better one
}

CueSkill BestScores::skill(std::string_view lesson) const {
    return skillIn(content_.skills, lesson);
}

CueSkill BestScores::beginAttempt(const std::string& lesson) {
    return attempted_[lesson] = skill(lesson);
}

void BestScores::practise(const std::string& lesson, const CueSkill& skill) {
    if (find(lesson) == nullptr && findTest(lesson) == nullptr) return;
    const CueSkill before = this->skill(lesson);
    const CueSkill after = practisedOn(before, attempted_.try_emplace(lesson, before).first->second, skill);
    attempted_[lesson] = skill;
    if (after == before) return;
    content_.skills[lesson] = after;
    save();
}

void BestScores::save() {
    if (!writable_) return;
    const FileTurn turn(file_);
    const Content others = load(true);
    if (!writable_) return;
    takeBetter(content_.best, others.best);
    takeBetter(content_.tests, others.tests);
    for (const auto& [lesson, theirs] : others.skills)
        content_.skills[lesson] = practisedOn(theirs, skillIn(written_, lesson), skill(lesson));
    std::string text = "# Best scores of the Meltpool trainer; written after an attempt that beats the one before.\n";
    std::set<std::string> lessons;
    for (const Scores* scores : {&content_.best, &content_.tests})
        for (const auto& [lesson, best] : *scores)
            lessons.insert(lesson);
    for (const std::string& lesson : lessons)
        text += tableOf(lesson, find(lesson), findTest(lesson), skill(lesson));
    written_ = others.skills; // new counts add to these until they are in the file
    writeFile(file_, text);
    written_ = content_.skills;
}

} // namespace meltpool
