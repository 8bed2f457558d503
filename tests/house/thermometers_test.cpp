// Counts of the source tree: checked on small trees, listed for the real one.
#include "tests/house/thermometers.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/places.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace meltpool::test {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kFewUnits = 5;  ///< folders with fewer units are probably too small
constexpr int kFewLines = 60; ///< shorter files with one user probably belong to that user
constexpr size_t kShown = 10; ///< number of listed classes and headers
constexpr int kMostPublicFunctions = 40, kMostMembers = 30;

std::vector<SourceFile> programSources(const std::filesystem::path& root) {
    return readSources(root, {"core", "xr", "app"}, {".cpp", ".hpp"});
}

std::string variable(const char* name, const std::string& otherwise) {
    const char* value = std::getenv(name);
    return value == nullptr ? otherwise : value;
}

std::vector<NamedCount> smallFolders(const std::vector<SourceFile>& files) {
    std::vector<NamedCount> small;
    for (const auto& [folder, units] : unitsOfFolders(files))
        if (units < kFewUnits) small.push_back({folder, units});
    return small;
}

std::string listed(const char* heading, const std::vector<NamedCount>& counts, const char* unit) {
    std::string text = std::string(heading) + ": " + std::to_string(counts.size()) + "\n";
    for (const NamedCount& each : counts)
        text += "    " + each.name + ": " + std::to_string(each.count) + " " + unit + "\n";
    return text;
}

std::vector<LocatedClass> largest(const std::vector<SourceFile>& files) {
    return largestClasses(classesOf(files), kShown, kMostPublicFunctions, kMostMembers);
}

/// Returns the headers with the most dependents.
std::vector<NamedCount> hottestHeaders(const std::map<std::string, int>& dependents) {
    std::vector<NamedCount> headers;
    for (const auto& [header, count] : dependents)
        headers.push_back({header, count});
    std::stable_sort(headers.begin(), headers.end(), [](const auto& a, const auto& b) { return a.count > b.count; });
    headers.resize(std::min(kShown, headers.size()));
    return headers;
}

int dependentsOf(const std::map<std::string, int>& dependents, std::string_view name) {
    for (const auto& [header, count] : dependents)
        if (header.ends_with(name)) return count;
    return 0;
}

/// Returns the counts of the tree at `root`, which may be another version of this one.
Json measured(const std::filesystem::path& root) {
    const std::vector<SourceFile> program = programSources(root);
    const std::vector<SourceFile> shaders =
        readSources(root, {"shaders"}, {".comp", ".vert", ".frag", ".geom", ".glsl", ".h"});
    std::vector<SourceFile> all = readSources(root, {"tests"}, {".cpp", ".hpp"});
    all.insert(all.end(), program.begin(), program.end());
    all.insert(all.end(), shaders.begin(), shaders.end());
    const auto isSource = [](const SourceFile& file) { return file.path.extension() == ".cpp"; };
    const std::map<std::string, int> dependents = dependentsOfHeaders(all);
    Json json;
    json["folders"] = unitsOfFolders(program).size();
    json["files"] = program.size() + shaders.size();
    json["sources_with_tests"] = std::count_if(all.begin(), all.end(), isSource);
    json["small_folders"] = smallFolders(program).size();
    json["small_files_of_one_user"] = smallFilesOfOneUser(program, kFewLines).size();
    json["process_checks_outside_process"] = processChecks(program);
    json["software_driver_words_outside_their_room"] = softwareDriverWords(program) + softwareDriverWords(shaders);
    json["dependents_of_weld_constants"] = dependentsOf(dependents, "/weld_constants.hpp");
    for (const auto& [size, place] : largest(program))
        json["largest_classes"].push_back(
            {{"name", size.name}, {"public_functions", size.publicFunctions}, {"members", size.members}});
    for (const NamedCount& header : hottestHeaders(dependents))
        json["hottest_headers"].push_back({{"name", header.name}, {"dependents", header.count}});
    return json;
}

} // namespace

TEST_CASE("thermometers count what they name") {
    const std::vector<SourceFile> files{
        {"core/base/a.hpp", "int a();\n"},
        {"core/base/a.cpp", "#include \"core/base/a.hpp\"\n// llvmpipe of Mesa\n"},
        {"core/base/b.hpp", "#include \"core/base/a.hpp\"\n"},
        {"core/gl/c.cpp", "#include \"core/base/b.hpp\"\nbool c = p.is<Gmaw>() || p.is<Smaw>();\n"},
        {"core/gl/software_driver/d.cpp", "// llvmpipe\n#include \"core/base/b.hpp\"\n"},
        {"core/weld/process/e.cpp", "bool e = p.is<Gmaw>();\n"}};
    CHECK(unitsOfFolders(files).at("core/base") == 2);
    CHECK(dependentsOfHeaders(files).at("core/base/a.hpp") == 3);
    CHECK(dependentsOfHeaders(files).at("core/base/b.hpp") == 2);
    CHECK(processChecks(files) == 2);
    CHECK(softwareDriverWords(files) == 2);
    const std::vector<NamedCount> small = smallFilesOfOneUser(files, 2);
    REQUIRE(small.size() == 1); // a.cpp is longer, b has two users
    CHECK(small[0].name == "core/base/a.hpp, of core/base/b");
    CHECK(small[0].count == 1);
    CHECK(smallFilesOfOneUser(files, 3).size() == 2);

    const std::vector<LocatedClass> classes{
        {{1, "Few", 4, 3}, ""}, {{1, "Functions", 20, 0}, ""}, {{1, "Members", 0, 29}, ""}};
    const std::vector<LocatedClass> two = largestClasses(classes, 2, 40, 30);
    REQUIRE(two.size() == 2);
    CHECK(two[0].size.name == "Members");
    CHECK(two[1].size.name == "Functions");
}

TEST_CASE("small folders, small files and the largest classes are listed") {
    const std::vector<SourceFile> files = programSources(sourceFolder());
    std::string text =
        listed("Folders of fewer than 5 units", smallFolders(files), "units") +
        listed("Files of fewer than 60 lines with one user", smallFilesOfOneUser(files, kFewLines), "lines") +
        "The largest classes:\n";
    const std::vector<LocatedClass> classes = largest(files);
    for (const auto& [size, place] : classes)
        text += "    " + size.name + ": " + std::to_string(size.publicFunctions) + " public functions, " +
                std::to_string(size.members) + " members (" + place + ")\n";
    std::fputs(text.c_str(), stdout);
    REQUIRE(classes.size() == kShown);
    CHECK(classes.front().size.publicFunctions + classes.front().size.members > 10);
}

/// This test is run by tests/house/thermometers.sh, which names tree and file.
TEST_CASE("the thermometers of a tree are written", "[by_hand][thermometers]") {
    Json json{{"commit", variable("MELTPOOL_COMMIT", "")}};
    json.update(measured(variable("MELTPOOL_TREE", sourceFolder().string())));
    std::ofstream out(variable("MELTPOOL_THERMOMETERS", (buildFolder() / "thermometers.json").string()));
    out << json.dump(2) << '\n';
    REQUIRE(out.good());
}

} // namespace meltpool::test
