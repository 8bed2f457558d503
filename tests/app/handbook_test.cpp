// Correctness of README and handbook: their commands run, their files are read, their names and links exist.
#include "app/bench/bench.hpp"
#include "core/base/text.hpp"
#include "core/training/judging/acceptance.hpp"
#include "core/training/judging/along_seam.hpp"
#include "core/training/lesson/lesson.hpp"
#include "core/training/lesson/lesson_check.hpp"
#include "core/training/trainer/result_file.hpp"
#include "core/validation/validation_case.hpp"
#include "core/weld/gauge/weld_figures.hpp"
#include "core/weld/torch/torch_csv.hpp"
#include "core/weld/torch/torch_moves.hpp"
#include "tests/app/handbook.hpp"
#include "tests/app/program.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/places.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <regex>
#include <sstream>

using namespace meltpool;
using namespace meltpool::test;

namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

/// Limit of words for each page, with table bars and links, without comments.
const std::map<std::string, size_t> kMostWords{
    {"README.md", 500},        {"hello.md", 500},         {"user-guide.md", 3000},     {"command-line.md", 2500},
    {"file-formats.md", 5000}, {"architecture.md", 1800}, {"the-metal.md", 3000},      {"performance.md", 900},
    {"extending.md", 1500},    {"teaching.md", 6000},     {"technique.md", 6000},      {"measured-weld.md", 6000},
    {"headset.md", 6000},      {"glossary.md", 800},      {"troubleshooting.md", 800}, {"contributing.md", 1000},
    {"validation.md", 1800}};

const std::vector<Page>& pages() {
    static const std::vector<Page> all = readPages(sourceFolder());
    return all;
}

std::string place(const fs::path& page, size_t line) {
    return page.filename().string() + ":" + std::to_string(line);
}

std::vector<ShownCommand> allCommands() {
    std::vector<ShownCommand> all;
    for (const Page& page : pages())
        all.insert(all.end(), page.commands.begin(), page.commands.end());
    return all;
}

/// Returns the tables whose head at `column` (the first by default) begins with `head`.
std::vector<ShownTable> tablesOf(const std::string& head, size_t column = 0) {
    std::vector<ShownTable> found;
    for (const Page& page : pages())
        for (const ShownTable& table : page.tables)
            if (column < table.heads.size() && table.heads[column].starts_with(head)) found.push_back(table);
    return found;
}

std::string joined(const Names& names) {
    std::string text;
    for (const std::string& name : names)
        text += (text.empty() ? "" : ", ") + name;
    return text;
}

Names without(const Names& from, const Names& other) {
    Names rest;
    std::set_difference(from.begin(), from.end(), other.begin(), other.end(), std::inserter(rest, rest.end()));
    return rest;
}

/// Makes a folder in which the pages' relative paths lead to the files of the source tree's root.
fs::path workingFolder() {
    const fs::path folder = scratchFolder("handbook");
    for (const char* name : {"app", "tests"})
        fs::create_directory_symlink(sourceFolder() / name, folder / name);
    return folder;
}

/// Returns the arguments to run for those that a page shows. Words in capitals are placeholders for a case or a folder.
/// A run is shortened to kShortRun and its pictures are small; other arguments are unchanged.
std::string runnable(std::string arguments) {
    const std::vector<std::pair<std::string, std::string>> kStandFor{
        {"COMMAND", "run"},
        {"LESSON", "classic"},
        {"CASE.toml", "tests/validation/cases/conduction_step.toml"},
        {"DIR", "out"},
        {"FILE", "file.json"}};
    for (const auto& [word, stands] : kStandFor)
        arguments = std::regex_replace(arguments, std::regex("\\b" + word + "\\b"), stands);
    if (!arguments.starts_with("run ") || arguments.find("--help") != std::string::npos) return arguments;
    arguments = std::regex_replace(arguments, std::regex(" --(seconds|size) \\S+"), "");
    return arguments + " --seconds 0.05 --size 64x36";
}

Names keysOf(const std::string& lessonName, bool withChoices) {
    Lesson lesson = findLesson(lessonName, sourceFolder() / "app" / "data" / "lessons");
    Names names;
    for (const Parameter& parameter : lesson.parameters()) {
        names.emplace(parameter.key);
        if (withChoices) names.insert(parameter.choices.begin(), parameter.choices.end());
    }
    return names;
}

/// Adds every key of an object and of its nested objects.
void addKeys(const nlohmann::json& json, Names& names) {
    if (json.is_object())
        for (const auto& [key, value] : json.items()) {
            names.insert(key);
            addKeys(value, names);
        }
}

Names commaNames(std::string_view text) {
    Names names;
    for (const std::string_view piece : splitText(text, ','))
        names.emplace(trimText(piece));
    return names;
}

/// Returns the complete section of a result.
nlohmann::json wholeSection(const fs::path& file) {
    ResultContext context;
    WeldSection& section = context.section.emplace();
    section.figures.bead.emplace().toes.emplace();
    section.figures.fillet.emplace();
    section.figures.rootFusion = 0;
    section.figures.heatAffected.emplace();
    Lesson lesson = findLesson("gmaw-bead", sourceFolder() / "app" / "data" / "lessons");
    writeResult(file, lesson, {}, context);
    return nlohmann::json::parse(readTextFile(file)).at("section");
}

} // namespace

TEST_CASE("the pages are read as written", "[app][handbook]") {
    const fs::path file = scratchFolder("page") / "page.md";
    writeTextFileAtomically(file,
                            "# A page, and more\n\nSay `meltpool doctor` or `meltpool`. [Link](#a-page-and-more)\n"
                            "`meltpool bench` <!-- not run: slow -->\n\n"
                            "<!-- not run: never -->\n\n```sh\nmeltpool lessons  # all\n./run.sh run x\nls\n```\n"
                            "\n<!-- read as: lesson -->\n```toml\na = 1\n```\n\n```sh\nmeltpool last\n```\n\n"
                            "| keys | b |\n|---|---|\n| `one`, `two` | c |\n\n[gone](gone.md) [no](#heading)\n");
    const Page page = readPage(file);
    REQUIRE(page.commands.size() == 5);
    CHECK(page.commands[0].arguments == "doctor");
    CHECK(page.commands[0].notRun.empty());
    CHECK(page.commands[1].notRun == "slow");
    CHECK(page.commands[2].arguments == "lessons");
    CHECK(page.commands[2].notRun == "never");
    CHECK(page.commands[3].arguments == "run x");
    CHECK(page.commands[4].arguments == "last");
    CHECK(page.commands[4].notRun.empty());
    REQUIRE(page.files.size() == 1);
    CHECK(page.files[0].kind == "lesson");
    CHECK(page.files[0].text == "a = 1\n");
    REQUIRE(page.tables.size() == 1);
    CHECK(page.tables[0].column(0) == Names{"one", "two"});
    CHECK(brokenLinks({page}).size() == 2);
}

TEST_CASE("pages that are read at one sitting stay short", "[app][handbook]") {
    size_t found = 0;
    for (const Page& page : pages()) {
        const auto limit = kMostWords.find(page.file.filename().string());
        if (limit == kMostWords.end()) continue;
        size_t words = 0;
        for (const std::string& line : page.lines) {
            std::istringstream stream(withoutComments(line));
            for (std::string word; stream >> word;)
                ++words;
        }
        INFO(limit->first);
        CHECK(words <= limit->second);
        ++found;
    }
    CHECK(found == kMostWords.size());
}

TEST_CASE("the handbook's links and pictures exist", "[app][handbook]") {
    CHECK(pages().size() >= 8);
    for (const std::string& broken : brokenLinks(pages()))
        FAIL_CHECK(broken);
    Names shown;
    for (const Page& page : pages())
        for (const ShownLink& link : page.links)
            shown.insert(fs::path(link.target.substr(0, link.target.find('#'))).filename().string());
    for (const auto& entry : fs::directory_iterator(sourceFolder() / "app" / "handbook")) {
        INFO(entry.path());
        CHECK(shown.contains(entry.path().filename().string())); // every page and picture is reached
    }
}

TEST_CASE("files and folders that the handbook names exist", "[app][handbook]") {
    const std::regex kPath(R"((app|core|xr|shaders|tests)/[a-z0-9_/.-]*)");
    size_t named = 0;
    for (const Page& page : pages())
        for (const std::string& span : page.code)
            if (std::regex_match(span, kPath)) {
                INFO(page.file.filename() << ": " << span);
                CHECK(fs::exists(sourceFolder() / span));
                ++named;
            }
    CHECK(named > 30);
}

TEST_CASE("commands that the handbook shows run", "[app][handbook]") {
    const fs::path folder = workingFolder();
    size_t runs = 0;
    for (const ShownCommand& command : allCommands()) {
        if (!command.notRun.empty()) continue;
        if (command.arguments == "validate" || command.arguments.starts_with("bench")) {
            FAIL_CHECK(place(command.page, command.line)
                       << ": takes minutes; expected a comment \"not run: REASON\" beside it");
            continue;
        }
        const std::string arguments = runnable(command.arguments);
        INFO(place(command.page, command.line) << ": meltpool " << command.arguments << ", run as " << arguments);
        const Outcome outcome =
            runMeltpool(arguments, "cd '" + folder.string() + "' && env -u DISPLAY -u WAYLAND_DISPLAY");
        INFO(outcome.errors);
        CHECK(outcome.code == 0);
        ++runs;
    }
    CHECK(runs > 10);
    // The page of commands says that the second run repeats the first.
    const auto hash = [&](const char* name) {
        return nlohmann::json::parse(readTextFile(folder / name / "result.json")).at("state_hash");
    };
    CHECK(hash("bead") == hash("again"));
}

TEST_CASE("suites and options that the handbook shows exist", "[app][handbook]") {
    Names options;
    for (const char* command : {"", "run ", "replay ", "compare ", "demonstration ", "check ", "bench ", "validate ",
                                "lessons ", "recordings ", "doctor "}) {
        const std::string help = runMeltpool(std::string(command) + "--help").output;
        const std::regex kOption("--[a-z-]+");
        for (std::sregex_iterator option(help.begin(), help.end(), kOption), end; option != end; ++option)
            options.insert(option->str());
    }
    Names suites{"SUITE"};
    for (const BenchPart& part : benchParts())
        suites.emplace(part.suite);
    const auto checkOptions = [&](const std::string& text) {
        std::istringstream words(text);
        for (std::string word; words >> word;)
            if (word.starts_with("--")) CHECK(options.contains(word));
    };
    for (const ShownCommand& command : allCommands()) {
        INFO(place(command.page, command.line) << ": meltpool " << command.arguments);
        checkOptions(command.arguments);
        std::istringstream words(command.arguments);
        std::string name, suite;
        words >> name >> suite;
        if (name == "bench" && !suite.empty() && !suite.starts_with("--")) CHECK(suites.contains(suite));
    }
    const auto tables = tablesOf("option");
    CHECK(tables.size() == 2);
    for (const ShownTable& table : tables)
        for (const std::string& span : table.column(0)) {
            INFO(place(table.page, table.line) << ": " << span);
            checkOptions(span);
        }
}

TEST_CASE("files that the handbook shows are read", "[app][handbook]") {
    const fs::path folder = scratchFolder("handbook-files");
    fs::create_directory_symlink(sourceFolder() / "app" / "data" / "paths", folder / "paths");
    fs::create_directory(folder / "lessons");
    const std::map<std::string, std::pair<std::string, std::function<void(const fs::path&)>>> readers{
        {"lesson", {"lesson.toml", [](const fs::path& file) { readLesson(file); }}},
        {"torch.csv", {"torch.csv", [](const fs::path& file) { TorchPath::read(file); }}},
        {"torch.toml", {"torch.toml", [](const fs::path& file) { TorchPath::read(file); }}},
        {"material", {"material.toml", [](const fs::path& file) { readMaterial(file); }}},
        {"check",
         {"check.toml",
          [](const fs::path& file) { readLessonCheck(file, sourceFolder() / "app" / "data" / "lessons"); }}},
        {"acceptance", {"acceptance.toml", [](const fs::path& file) { readAcceptance(file); }}},
        {"validation case", {"case.toml", [](const fs::path& file) { readValidationCase(file); }}}};
    Names kinds;
    for (const Page& page : pages())
        for (const ShownFile& shown : page.files) {
            INFO(place(page.file, shown.line) << ": " << shown.kind);
            const auto reader = readers.find(shown.kind);
            REQUIRE(reader != readers.end());
            const fs::path file = folder / "lessons" / reader->second.first;
            writeTextFileAtomically(file, shown.text);
            CHECK_NOTHROW(reader->second.second(file));
            kinds.insert(shown.kind);
        }
    CHECK(kinds.size() == readers.size());
}

TEST_CASE("poses that the handbook shows hold the torch as they say", "[app][handbook]") {
    const auto tables = tablesOf("pose of a torch");
    REQUIRE(tables.size() == 1);
    const std::array<std::pair<double, double>, 4> kAngles{{{90, 0}, {90, 10}, {90, -10}, {45, 0}}}; // work, travel
    REQUIRE(tables[0].rows.size() == kAngles.size());
    for (size_t row = 0; row < kAngles.size(); ++row) {
        const std::string cells = tables[0].code(row, 1).at(0);
        INFO(cells);
        const fs::path file = scratchFolder("pose") / "pose.csv";
        writeTextFileAtomically(file, "time_s,x_mm,y_mm,z_mm,qx,qy,qz,qw,trigger\n0,0,0,0," + cells + ",1\n");
        const glm::vec3 axis = TorchPath::read(file).sample(0).axis();
        const auto& [work, travel] = kAngles[row];
        TorchSample held;
        held.orientation = heldOrientation(glm::radians(work), glm::radians(travel), {1, 0, 0});
        CHECK(glm::distance(axis, held.axis()) < 1e-3f);
    }
}

TEST_CASE("keys in the handbook's tables of lessons are the program's", "[app][handbook]") {
    const Names classic = keysOf("classic", true), weld = keysOf("gmaw-bead", true);
    Names both;
    std::set_intersection(classic.begin(), classic.end(), weld.begin(), weld.end(), std::inserter(both, both.end()));
    const std::map<std::string, Names> known{{"table of every lesson", both},
                                             {"table of a lesson of the classic model", classic},
                                             {"table of a weld lesson", weld}};
    for (const auto& [head, keys] : known) {
        const auto tables = tablesOf(head);
        INFO(head);
        REQUIRE(tables.size() == 1);
        CHECK(joined(without(tables[0].column(1), keys)) == "");
    }
    const auto processes = tablesOf("settings", 1);
    REQUIRE(processes.size() == 1);
    Names kinds;
    for (size_t row = 0; row < processes[0].rows.size(); ++row) {
        const std::string kind = processes[0].code(row, 0).at(0);
        INFO(kind);
        kinds.insert(kind);
        ProcessSettings settings;
        setParameter(describe(settings), "process", kind, "the handbook");
        Names own;
        for (const Parameter& parameter : describe(settings))
            if (parameter.key != "process") own.emplace(parameter.key);
        const auto shown = processes[0].code(row, 1);
        CHECK(joined(Names(shown.begin(), shown.end())) == joined(own));
    }
    CHECK(kinds.size() == AllProcesses::kCount);
    for (const ShownTable& table : tablesOf("parameter")) {
        INFO(place(table.page, table.line));
        CHECK(joined(without(table.column(0), keysOf("classic", false))) == "");
    }
}

TEST_CASE("the handbook names every lesson", "[app][handbook]") {
    const auto tables = tablesOf("exercise", 1);
    REQUIRE(tables.size() == 1);
    const auto names = lessonNames(sourceFolder() / "app" / "data" / "lessons");
    CHECK(joined(tables[0].column(0)) == joined(Names(names.begin(), names.end())));
}

TEST_CASE("the handbook names every column of weld.csv and every imperfection", "[app][handbook]") {
    Names columns{"place_mm"}, known;
    for (const WeldFigure& figure : stationFigures())
        columns.emplace(figure.key);
    for (const WeldFigure& each : imperfections())
        known.emplace(each.key);
    const auto weld = tablesOf("column of weld.csv"), judged = tablesOf("imperfection");
    REQUIRE(weld.size() == 1);
    REQUIRE(judged.size() == 1);
    CHECK(joined(weld[0].column(0)) == joined(columns));
    CHECK(joined(judged[0].column(0)) == joined(known));
}

TEST_CASE("the handbook names every kind of validation case, its keys and its results", "[app][handbook]") {
    const auto tables = tablesOf("keys of `[case]`", 1);
    REQUIRE(tables.size() == 1);
    std::map<std::string, Names> shown;
    for (size_t row = 0; row < tables[0].rows.size(); ++row) {
        const auto keys = tables[0].code(row, 1);
        shown[tables[0].code(row, 0).at(0)] = Names(keys.begin(), keys.end());
    }
    Names results;
    for (const CaseKind& kind : caseKinds()) {
        INFO(kind.name);
        Names all, needed;
        for (const CaseKey& key : kind.keys) {
            all.emplace(key.key);
            if (!key.fallback) needed.emplace(key.key);
        }
        const Names& own = shown[std::string(kind.name)];
        CHECK(joined(without(own, all)) == "");
        CHECK(joined(without(needed, own)) == "");
        results.merge(commaNames(kind.results));
    }
    CHECK(shown.size() == caseKinds().size());
    Names told;
    for (const size_t column : {0, 1})
        for (const ShownTable& table : tablesOf("result", column))
            told.merge(table.column(column));
    CHECK(joined(without(told, results)) == "");
    CHECK(joined(without(results, told)) == "");
}

TEST_CASE("the handbook names every quantity of technique", "[app][handbook]") {
    const auto tables = tablesOf("column of technique.csv");
    REQUIRE(tables.size() == 1);
    Names columns, keys;
    for (const DistanceKind kind : {DistanceKind::ctwd, DistanceKind::arcLength}) {
        const std::string head = techniqueCsv({}, kind);
        columns.merge(commaNames(trimText(head)));
        for (const QuantityInfo& info : quantities(kind))
            if (!info.key.empty()) keys.emplace(info.key);
    }
    CHECK(joined(tables[0].column(0)) == joined(columns));
    CHECK(joined(tables[0].column(1)) == joined(keys));
}

TEST_CASE("the handbook names what the program writes", "[app][handbook]") {
    const auto told = [](const std::string& head) {
        const auto tables = tablesOf(head);
        REQUIRE(tables.size() == 1);
        return tables[0];
    };
    const auto& required = torchColumns();
    Names columns(required.begin(), required.end());
    for (const std::string_view column : rodColumns())
        columns.emplace(column);
    CHECK(told("columns of a torch path").column(0) == columns);

    // A weld whose pictures show the cut fills in the whole result.
    const fs::path folder = scratchFolder("handbook-run");
    REQUIRE(
        runMeltpool("run gmaw-bead --seconds 0.05 --pictures 0 --size 64x36 --out '" + folder.string() + "'").code ==
        0);
    const TorchRecording record = readTorchCsv(folder / "telemetry.csv");
    Names further(record.furtherColumns.begin(), record.furtherColumns.end());
    further.insert("real_time"); // only in results of a person's attempt
    CHECK(told("columns of telemetry.csv").column(0) == further);
    const auto result = nlohmann::json::parse(readTextFile(folder / "result.json"));
    Names section, top{"error",    "recorded",   "attempt",   "what_if",       "arc",
                       "warnings", "torch_form", "simulated", "simulated_text"}; // not in every run
    addKeys(result.at("section"), section);
    addKeys(wholeSection(folder / "section.json"), section);
    for (const auto& [key, value] : result.items())
        top.insert(key);
    CHECK(joined(without(told("entries of result.json").column(0), top)) == "");
    CHECK(joined(without(top, told("entries of result.json").column(0))) == "");
    const ShownTable entries = told("entries of section");
    Names shown = entries.column(0);
    CHECK(joined(without(shown, section)) == "");
    shown.merge(entries.column(1)); // names of the boxes
    CHECK(joined(without(section, shown)) == "");

    Names bench;
    const auto json = nlohmann::json::parse(benchJson(context().info(), {BenchRow{}}, true));
    addKeys(json, bench);
    addKeys(json.at("rows").at(0), bench);
    CHECK(told("entries of the benchmark").column(0) == bench);
}
