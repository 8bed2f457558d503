#include "app/report/result_history.hpp"

#include "app/platform/result_head.hpp"
#include "app/report/page_text.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace meltpool {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Members of a benchmark's row that become a series, with their unit and the word behind the row's name.
struct RowValue {
    const char *key, *unit, *word;
};
constexpr RowValue kRowValues[]{{"step_ms", "ms", ""},
                                {"bytes_per_particle", "bytes", ", memory of a particle"},
                                {"simulated_over_wall", "", ", simulated over real time"}};

std::vector<fs::path> jsonFilesBelow(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code failed;
    for (fs::recursive_directory_iterator each(folder, failed), end; !failed && each != end; each.increment(failed))
        if (each->path().extension() == ".json") files.push_back(each->path());
    if (failed) throw InputError(folder, 0, "cannot be read: " + failed.message() + "; expected a folder of results");
    std::sort(files.begin(), files.end());
    return files;
}

Json parsed(const fs::path& file) {
    try {
        return Json::parse(readTextFile(file));
    } catch (const Json::exception& fault) {
        throw InputError(file, 0,
                         std::string("is no JSON: ") + fault.what() + "; expected a result of bench or validate");
    }
}

/// Collects the points of all files before they are sorted by time.
class Histories {
  public:
    /// Adds a file. Returns false if it is no complete result.
    bool add(const Json& result) {
        // Benchmarks of old versions have no "complete"; each that was kept is whole.
        if (!result.is_object() || !result.value("complete", true)) return false;
        const auto made = parseMoment(rawIn(result, "date"));
        if (!made) return false;
        base_ = {*made, rawIn(result, "commit"), 0};
        machine_ = machineOf(result);
        if (result.contains("rows"))
            addRows(partIn(result, "rows"));
        else if (result.contains("mean_errors"))
            addErrors(result);
        else
            return false;
        return true;
    }

    std::vector<MachineHistory> sorted() {
        std::vector<MachineHistory> machines;
        for (auto& [key, points] : points_) {
            const auto& [machine, group, name, unit] = key;
            if (machines.empty() || machines.back().machine != machine) machines.push_back({machine, {}});
            std::sort(points.begin(), points.end(),
                      [](const HistoryPoint& a, const HistoryPoint& b) { return a.made < b.made; });
            machines.back().series.push_back({group, name, unit, std::move(points)});
        }
        return machines;
    }

  private:
    void add(const std::string& group, const std::string& name, const char* unit, std::optional<double> value) {
        if (!value || !std::isfinite(*value)) return;
        HistoryPoint point = base_;
        point.value = *value;
        points_[{machine_, group, name, unit}].push_back(std::move(point));
    }

    void addRows(const Json& rows) {
        std::map<std::string, int> counts; // rows of one name differ by their particles
        for (const Json& row : rows)
            ++counts[rawIn(row, "what")];
        for (const Json& row : rows) {
            std::string name = rawIn(row, "what");
            if (counts[name] > 1) name += ", " + countText(numberIn(row, "particles").value_or(0)) + " particles";
            for (const RowValue& each : kRowValues)
                if (const auto value = numberIn(row, each.key); value && *value != 0)
                    add("bench " + rawIn(row, "suite"), name + each.word, each.unit, value);
        }
    }

    void addErrors(const Json& result) {
        for (const Json& error : partIn(result, "mean_errors"))
            add("validate " + rawIn(result, "set"), rawIn(error, "name"), "%", numberIn(error, "percent"));
    }

    static std::string countText(double count) { return std::to_string(std::llround(count)); }

    using Key = std::tuple<std::string, std::string, std::string, std::string>; // machine, group, name, unit
    std::map<Key, std::vector<HistoryPoint>> points_;
    HistoryPoint base_;
    std::string machine_;
};

} // namespace

ResultHistory readResultHistory(const fs::path& folder) {
    Histories histories;
    ResultHistory history;
    for (const fs::path& file : jsonFilesBelow(folder))
        if (!histories.add(parsed(file))) history.leftOut.push_back(file);
    history.machines = histories.sorted();
    return history;
}

} // namespace meltpool
