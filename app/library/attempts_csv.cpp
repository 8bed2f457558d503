#include "app/library/attempts_csv.hpp"

#include "core/base/text.hpp"
#include "core/training/attempt/recording_reader.hpp"

namespace meltpool {

namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kMostBytes = 1000; ///< bytes of a text from a file

std::string cell(const Json& value) {
    if (value.is_null()) return {};
    if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
    if (value.is_number_float()) return formatNumber(value.get<double>());
    if (!value.is_string()) return value.dump();
    const std::string text = printable(value.get<std::string>(), kMostBytes);
    if (text.find_first_of(",\"") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

Json known(const std::string& text) {
    return text.empty() ? Json() : Json(text);
}

} // namespace

std::array<Json, kAttemptColumns.size()> attemptRow(const KeptAttempt& kept) {
    const RecordingSummary summary = readRecordingSummary(kept.file);
    const auto& end = summary.end;
    return {summary.head.date,
            kept.lesson,
            kept.lessonFile,
            summary.head.attempt,
            kept.seconds,
            end && end->score ? Json(*end->score) : Json(),
            known(kept.verdict),
            kept.practice,
            end ? Json(end->realTime) : Json(),
            kept.ended,
            end ? end->stateHash : std::string(),
            kept.bytes,
            summary.head.program,
            summary.head.driver,
            kept.file.string(),
            kept.person,
            kept.personId,
            kept.title,
            kept.test};
}

std::string attemptsCsv(std::span<const KeptAttempt> attempts) {
    std::string text;
    for (const char* column : kAttemptColumns)
        text += (text.empty() ? "" : ",") + std::string(column);
    for (const KeptAttempt& kept : attempts) {
        const auto row = attemptRow(kept);
        for (size_t i = 0; i < row.size(); ++i)
            text += (i == 0 ? "\n" : ",") + cell(row[i]);
    }
    return text + "\n";
}

} // namespace meltpool
