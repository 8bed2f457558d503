#include "app/report/run_results.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace meltpool {

namespace {

namespace fs = std::filesystem;

std::vector<std::string_view> cellsOf(std::string_view line) {
    std::vector<std::string_view> cells;
    for (size_t from = 0;;) {
        const size_t comma = line.find(',', from);
        cells.push_back(line.substr(from, comma - from));
        if (comma == std::string_view::npos) return cells;
        from = comma + 1;
    }
}

nlohmann::json readJson(const fs::path& file) {
    try {
        return nlohmann::json::parse(readTextFile(file));
    } catch (const nlohmann::json::exception&) {
        throw InputError(file, 0, "is no JSON; expected the result.json of a run");
    }
}

/// Pictures are called by their time, "012.000s-metal.png": those of the last time.
std::vector<fs::path> lastPictures(const fs::path& folder) {
    std::vector<fs::path> pictures;
    std::error_code failed;
    for (const auto& entry : fs::directory_iterator(folder, failed))
        if (entry.path().extension() == ".png" && entry.path().filename().string().find("s-") != std::string::npos)
            pictures.push_back(entry.path());
    std::sort(pictures.begin(), pictures.end());
    if (pictures.empty()) return pictures;
    const auto timeOf = [](const fs::path& picture) {
        const std::string name = picture.filename().string();
        return name.substr(0, name.find("s-"));
    };
    const std::string last = timeOf(pictures.back());
    std::erase_if(pictures, [&](const fs::path& picture) { return timeOf(picture) != last; });
    return pictures;
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
    NumberTable table;
    std::istringstream lines(readTextFile(file));
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        const std::vector<std::string_view> cells = cellsOf(line);
        if (number == 1) {
            table.columns.assign(cells.begin(), cells.end());
            continue;
        }
        if (cells.size() != table.columns.size())
            throw InputError(file, number,
                             "has " + std::to_string(cells.size()) + " cells; expected " +
                                 std::to_string(table.columns.size()) + ", as in the first line");
        std::vector<double> row;
        for (const std::string_view cell : cells)
            row.push_back(parseDouble(cell).value_or(std::numeric_limits<double>::quiet_NaN()));
        table.rows.push_back(std::move(row));
    }
    return table;
}

RunResults readRunResults(const fs::path& folder) {
    const fs::path file = folder / "result.json";
    std::error_code failed;
    if (!fs::is_regular_file(file, failed))
        throw InputError(folder, 0, "holds no result.json; expected the folder of a run");
    RunResults results;
    results.folder = folder;
    results.result = readJson(file);
    if (!results.result.is_object() || !results.result.contains("lesson") || !results.result.contains("finished"))
        throw InputError(file, 0, "is not what a run writes; expected \"lesson\" and \"finished\"");
    if (results.result["finished"] != true)
        throw InputError(file, 0, "is of a run that has not ended; expected a finished one");
    if (fs::exists(folder / "technique.csv", failed)) results.technique = readNumberTable(folder / "technique.csv");
    if (fs::exists(folder / "weld.csv", failed)) results.weld = readNumberTable(folder / "weld.csv");
    results.pictures = lastPictures(folder);
    return results;
}

} // namespace meltpool
