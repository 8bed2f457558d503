#include "app/report/compared_run.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

using nlohmann::json;

/// Object in a result; an empty one if it is missing.
const json& objectIn(const json& result, const char* key) {
    static const json none = json::object();
    if (!result.is_object()) return none;
    const auto found = result.find(key);
    return found != result.end() && found->is_object() ? *found : none;
}

std::optional<double> numberIn(const json& object, const std::string& key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_number() ? std::optional(found->get<double>()) : std::nullopt;
}

void addNumbers(const json& object, std::map<std::string, double>& values) {
    for (const auto& [key, value] : object.items())
        if (value.is_number()) values[key] = value.get<double>();
}

/// Mean of a column of technique.csv over the judged millimetres; NaN if it has none.
double judgedMean(const NumberTable& table, std::string_view column) {
    const std::vector<double> values = table.column(column), judged = table.column("judged");
    double sum = 0;
    int count = 0;
    for (size_t i = 0; i < std::min(values.size(), judged.size()); ++i)
        if (judged[i] > 0 && std::isfinite(values[i])) {
            sum += values[i];
            ++count;
        }
    return count > 0 ? sum / count : std::nan("");
}

} // namespace

AttemptFigures figuresOf(const RunResults& results) {
    AttemptFigures figures;
    const std::vector<std::string>& columns = results.technique.columns;
    const bool electrode = std::find(columns.begin(), columns.end(), "arc_length_mm") != columns.end();
    figures.distance = electrode ? DistanceKind::arcLength : DistanceKind::ctwd;
    const json& weld = objectIn(results.result, "weld");
    addNumbers(weld, figures.values);
    if (!weld.empty())
        figures.spacing = numberIn(objectIn(results.result, "parameters"), "spacing_mm").value_or(0) * 1e-3;
    addNumbers(objectIn(results.result, "arc"), figures.values);
    for (const QuantityInfo& info : quantities(figures.distance))
        if (const double mean = judgedMean(results.technique, info.column); !info.key.empty() && std::isfinite(mean))
            figures.values[std::string(info.key)] = mean;
    const json& score = objectIn(results.result, "score");
    figures.score = numberIn(score, "total");
    if (figures.score) addNumbers(objectIn(score, "parameters"), figures.points);
    return figures;
}

Comparison compareRuns(const ComparedRun& first, const ComparedRun& second) {
    return compareAttempts(figuresOf(first.results), figuresOf(second.results));
}

} // namespace meltpool
