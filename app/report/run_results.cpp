#include "app/report/run_results.hpp"

#include "core/base/error.hpp"
#include "core/base/table_reader.hpp"
#include "core/base/text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace meltpool {

namespace {

namespace fs = std::filesystem;

nlohmann::json resultIn(const std::string& text, const fs::path& file) {
    nlohmann::json result;
    try {
        result = nlohmann::json::parse(text);
    } catch (const nlohmann::json::exception&) {
        throw InputError(file, 0, "is no JSON; expected the result.json of a run");
    }
    if (!result.is_object() || !result.contains("lesson") || !result.contains("finished"))
        throw InputError(file, 0, "is not what a run writes; expected \"lesson\" and \"finished\"");
    if (result["finished"] != true)
        throw InputError(file, 0, "is of a run that has not ended; expected a finished one");
    return result;
}

/// Pictures of the last time; their names begin with it: "012.000s-metal.png".
std::vector<ReportPicture> lastPictures(const fs::path& folder) {
    std::vector<fs::path> pictures;
    std::error_code failed;
    for (const auto& entry : fs::directory_iterator(folder, failed))
        if (entry.path().extension() == ".png" && entry.path().filename().string().find("s-") != std::string::npos)
            pictures.push_back(entry.path());
    std::sort(pictures.begin(), pictures.end());
    if (pictures.empty()) return {};
    const auto timeOf = [](const fs::path& picture) {
        const std::string name = picture.filename().string();
        return name.substr(0, name.find("s-"));
    };
    const std::string last = timeOf(pictures.back());
    std::vector<ReportPicture> read;
    for (const fs::path& picture : pictures) {
        if (timeOf(picture) != last) continue;
        const std::string stem = picture.stem().string();
        read.push_back({stem.substr(stem.find("s-") + 2), readTextFile(picture)});
    }
    return read;
}

} // namespace

std::vector<double> NumberTable::column(std::string_view name) const {
    const auto found = std::find(columns.begin(), columns.end(), name);
    if (found == columns.end()) return {};
    const auto place = static_cast<size_t>(found - columns.begin());
    std::vector<double> values;
    values.reserve(rows.size());
    for (const std::vector<double>& row : rows)
        values.push_back(row[place]);
    return values;
}

NumberTable readNumberTable(const fs::path& file) {
    return numberTable(readTextFile(file), file);
}

NumberTable numberTable(const std::string& text, const fs::path& file) {
    NumberTable table;
    TableReader reader(text, file, [](std::string_view) { return false; });
    table.columns = reader.columns();
    for (TableReader::Item item = reader.next(); item != TableReader::Item::end; item = reader.next()) {
        if (item == TableReader::Item::comment) continue;
        reader.requireWidth();
        std::vector<double>& row = table.rows.emplace_back();
        for (const std::string_view cell : reader.cells())
            row.push_back(reader.number(cell).value_or(std::numeric_limits<double>::quiet_NaN()));
    }
    return table;
}

RunResults resultsOf(const nlohmann::ordered_json& entries, const Judgement& judgement) {
    RunResults results;
    results.result = entries;
    results.technique = numberTable(techniqueCsv(judgement.seam, judgement.distance), "technique.csv");
    if (judgement.weld) results.weld = numberTable(weldTable(*judgement.weld), "weld.csv");
    return results;
}

RunResults readRunResults(const fs::path& place) {
    std::error_code failed;
    const fs::path file = place.filename() == "result.json" ? place : place / "result.json";
    const fs::path folder = file.parent_path();
    if (!fs::is_regular_file(file, failed))
        throw InputError(place, 0, "holds no result.json; expected the folder of a run");
    RunResults results;
    results.result = resultIn(readTextFile(file), file);
    if (fs::exists(folder / "technique.csv", failed)) results.technique = readNumberTable(folder / "technique.csv");
    if (fs::exists(folder / "weld.csv", failed)) results.weld = readNumberTable(folder / "weld.csv");
    results.pictures = lastPictures(folder);
    return results;
}

} // namespace meltpool
