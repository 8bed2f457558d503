// Measured figures in the handbook against tests/bench/results: a comment after a figure names its place in the newest
// result of a machine.
#include "core/base/text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/places.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <regex>

namespace meltpool::test {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr size_t kFewestFigures = 110; ///< with fewer, the comments no longer match kFigure

std::string textOf(const Json& value) {
    return value.is_string() ? value.get<std::string>() : value.dump();
}

/// Returns the number at the end of the path `steps`, whose parts '/' separates; the largest of several. A step NAME
/// goes to that member, and to all elements of an array. A step NAME=TEXT selects the objects whose member NAME has
/// that text. Returns nothing if no number is found or if one of several is not a number.
std::optional<double> findFigure(const Json& root, const std::string& steps) {
    std::vector<Json> found(1, root);
    for (const std::string_view step : splitText(steps, '/')) {
        const size_t equals = step.find('=');
        const std::string name(step.substr(0, equals));
        std::vector<Json> next;
        for (const Json& object : found) {
            if (!object.is_object() || !object.contains(name)) continue;
            const Json& member = object[name];
            if (equals != std::string_view::npos) {
                if (textOf(member) == step.substr(equals + 1)) next.push_back(object);
            } else if (member.is_array()) {
                next.insert(next.end(), member.begin(), member.end());
            } else {
                next.push_back(member);
            }
        }
        found = std::move(next);
    }
    std::optional<double> largest;
    for (const Json& value : found) {
        if (!value.is_number()) return std::nullopt;
        largest = std::max(largest.value_or(value.get<double>()), value.get<double>());
    }
    return largest;
}

/// Returns `value` with as many decimals as `shown` has.
std::string withDecimalsOf(const std::string& shown, double value) {
    const size_t point = shown.find('.');
    std::array<char, 400> text{};
    std::snprintf(text.data(), text.size(), "%.*f",
                  point == std::string::npos ? 0 : static_cast<int>(shown.size() - point - 1), value);
    return text.data();
}

/// A result that a page names: "bench-weld" of the page's machine, or "bench-weld@MACHINE".
struct NamedResult {
    std::string name, machine;
};

NamedResult namedResult(const std::string& words, const std::string& machineOfPage) {
    const size_t at = words.find('@');
    return at == std::string::npos ? NamedResult{words, machineOfPage}
                                   : NamedResult{words.substr(0, at), words.substr(at + 1)};
}

/// Returns the newest complete result COMMIT-NAME.json of a machine; null if there is none.
Json newestResult(const fs::path& results, const NamedResult& named) {
    Json newest;
    std::error_code missing;
    for (const auto& entry : fs::directory_iterator(results / named.machine, missing)) {
        if (!entry.path().stem().string().ends_with("-" + named.name)) continue;
        // "COMMIT-bench-stereo-monado" is no result of "monado": the name begins behind the commit.
        const std::string stem = entry.path().stem().string();
        const std::string commit = stem.substr(0, stem.size() - named.name.size() - 1);
        if (commit.find("bench") != std::string::npos || commit.find("validate") != std::string::npos) continue;
        Json result = Json::parse(readTextFile(entry.path()));
        if (!result.value("complete", true)) continue;
        if (newest.is_null() || newest.at("date") < result.at("date")) newest = std::move(result);
    }
    return newest;
}

/// Returns the command that makes a result.
std::string commandFor(const std::string& name) {
    const bool validates = name.starts_with("validate-");
    const std::string what = name.substr(name.find('-') + 1);
    return "meltpool " + (validates ? "validate tests/validation/" + what : "bench " + what) +
           " --results tests/bench/results";
}

/// A page with the figures of the results, and a sentence for each figure without a result.
struct FilledPage {
    std::string text;
    std::vector<std::string> changed, faults;
    size_t figures = 0;
};

FilledPage fillIn(const std::string& page, const fs::path& results) {
    // The form is NUMBER<!-- figure: NAME/STEPS -->; an empty number has question marks for its digits.
    static const std::regex kFigure(R"((-?[0-9?]+(?:\.[0-9?]+)?)(<!-- figure: ([^/\n]+)/(.+?) -->))");
    static const std::regex kMachine(R"(<!-- machine: (\S+) -->)");
    FilledPage filled;
    std::smatch machine;
    std::regex_search(page, machine, kMachine);
    std::map<std::string, Json> found;
    auto rest = page.begin();
    for (std::sregex_iterator mark(page.begin(), page.end(), kFigure), end; mark != end; ++mark) {
        const std::string shown = (*mark)[1], words = (*mark)[3], steps = (*mark)[4];
        const NamedResult named = namedResult(words, machine.empty() ? std::string() : machine[1].str());
        ++filled.figures;
        filled.text.append(rest, (*mark)[0].first);
        rest = (*mark)[2].first; // the comment remains
        if (!found.contains(words)) found[words] = newestResult(results, named);
        const std::optional<double> value = findFigure(found[words], steps);
        const std::string now = value ? withDecimalsOf(shown, *value) : shown;
        filled.text += now;
        if (!value)
            filled.faults.push_back(named.name + " of machine '" + named.machine + "' has no number at " + steps +
                                    "; " + commandFor(named.name) + " makes it");
        if (now != shown) filled.changed.push_back(shown + " is " + now + " at " + steps + " of " + words);
    }
    filled.text.append(rest, page.end());
    return filled;
}

} // namespace

TEST_CASE("figures in the handbook equal the results", "[house]") {
    const char* approve = std::getenv("MELTPOOL_APPROVE");
    const bool approved = approve != nullptr && std::string(approve) == "1";
    size_t figures = 0;
    for (const auto& entry : fs::directory_iterator(sourceFolder() / "app" / "handbook")) {
        if (entry.path().extension() != ".md") continue;
        const std::string page = readTextFile(entry.path());
        const FilledPage filled = fillIn(page, sourceFolder() / "tests" / "bench" / "results");
        figures += filled.figures;
        INFO(entry.path().filename().string());
        for (const std::string& fault : filled.faults)
            FAIL_CHECK(fault);
        if (approved && filled.text != page) writeTextFileAtomically(entry.path(), filled.text);
        if (approved) continue;
        for (const std::string& change : filled.changed)
            FAIL_CHECK(change << "; MELTPOOL_APPROVE=1 build/release/bin/test_house \"figures*\" writes it");
    }
    CHECK(figures >= kFewestFigures);
}

TEST_CASE("a comment behind a figure names its place in the results", "[house]") {
    const Json results =
        Json::parse(R"({"rows": [{"what": "a step", "size": 8, "ms": 1.5}, {"what": "a step", "size": 9,
        "ms": 2.5}, {"what": "other", "ms": null}], "percent": -3.46})");
    CHECK(findFigure(results, "percent") == -3.46);
    CHECK(findFigure(results, "rows/what=a step/size=8/ms") == 1.5);
    CHECK(findFigure(results, "rows/what=a step/ms") == 2.5); // the larger one
    CHECK_FALSE(findFigure(results, "rows/ms").has_value());  // one value is not a number
    CHECK_FALSE(findFigure(results, "rows/what=no such/ms").has_value());
    CHECK(withDecimalsOf("?.?", -3.46) == "-3.5");
    CHECK(withDecimalsOf("12", 2.5001) == "3");
    CHECK(commandFor("validate-clad") == "meltpool validate tests/validation/clad --results tests/bench/results");
    CHECK(commandFor("bench-weld") == "meltpool bench weld --results tests/bench/results");
    CHECK(namedResult("bench-weld@a-card", "here").machine == "a-card");
    CHECK(namedResult("bench-weld", "here").machine == "here");
}

} // namespace meltpool::test
