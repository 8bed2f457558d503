#include "app/commands/comparison_output.hpp"

#include "app/platform/say.hpp"
#include "core/base/output_file.hpp"
#include "core/base/text.hpp"
#include "core/base/words.hpp"

#include <cstdio>

namespace meltpool {

namespace {

std::string points(const std::optional<double>& value) {
    char text[24];
    if (!value) return "-";
    std::snprintf(text, sizeof text, "%.0f", *value);
    return text;
}

std::string roundedMm(double metres) {
    char text[24];
    std::snprintf(text, sizeof text, "%.2g", metres * 1e3);
    return withDecimalMark(text);
}

std::string shown(const std::string& text) {
    return printable(text, 200);
}

} // namespace

void tellComparison(const ComparedRun& first, const ComparedRun& second, const std::filesystem::path& folder,
                    bool page) {
    const Comparison comparison = compareRuns(first, second);
    say("%s\n", phrase("run.compare.against", {{"second", shown(second.name)},
                                               {"first", shown(first.name)},
                                               {"differences", comparisonText(comparison)}})
                    .c_str());
    if (comparison.halfSpacing > 0)
        say("%s\n", phrase("run.compare.no_difference", {{"length", roundedMm(comparison.halfSpacing)}}).c_str());
    if (!comparison.scores.empty())
        say("%-32s %12s %12s\n", phrase("run.compare.points").c_str(), shown(first.name).c_str(),
            shown(second.name).c_str());
    for (const ScorePair& pair : comparison.scores)
        say("%-32s %12s %12s\n", pair.name.c_str(), points(pair.first).c_str(), points(pair.second).c_str());
    if (page) {
        const std::filesystem::path file = folder / "comparison.html";
        writeFile(file, comparisonPage(first, second));
        sayResult(phrase("run.compare.page", {{"file", printable(file.string(), 1000)}}), file);
    } else {
        sayResult({}, folder);
    }
    std::fflush(stdout);
}

} // namespace meltpool
