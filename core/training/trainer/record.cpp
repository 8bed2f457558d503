#include "core/training/trainer/record.hpp"

#include "core/base/error.hpp"
#include "core/base/output_file.hpp"
#include "core/base/text.hpp"
#include "core/training/attempt/record_text.hpp"
#include "core/weld/torch/torch_csv.hpp"

#include <algorithm>

namespace meltpool {

namespace {

/// 31 cells of no more than 24 characters each.
constexpr size_t kLongestRow = 800;
/// Bytes of the usual lines of events before a step.
constexpr size_t kUsualNote = 200;
/// Below this the metal does not run, and a ratio of times has no meaning.
constexpr double kLeastPace = 1e-3;

std::string columns(const AttemptHead& head, bool paced) {
    std::string names;
    for (const std::string_view name : torchColumns())
        names += (names.empty() ? "" : ",") + std::string(name);
    names += head.arc ? ",molten,min_temperature_c,mean_temperature_c,max_temperature_c,lost,non_finite"
                      : ",molten,min_temperature,mean_temperature,max_temperature,lost,non_finite";
    for (const std::string_view name : head.rod ? rodColumns() : std::span<const std::string_view>{})
        names += "," + std::string(name);
    if (head.arc) names += "," + std::string(kArcColumns);
    if (paced) names += ",real_time";
    return names + "\n";
}

void appendComment(std::string& text, std::string_view word, std::string_view name, std::string_view value) {
    appendRecordLine(text, "#", word, name, value);
}

} // namespace

Record::Record(const std::filesystem::path& file, const AttemptHead& head, const RecordKind& kind)
    : file_(file), arc_(head.arc), rod_(head.rod), paced_(kind.paced) {
    std::error_code failure;
    if (!kind.replace && std::filesystem::is_regular_file(file, failure))
        throw InputError(file, 0, "already exists; expected a new name, because a record replaces no file");
    stream_.open(file, std::ios::binary | std::ios::trunc);
    if (!stream_) throw InputError(file, 0, "cannot be written; expected a folder with write permission");
    std::string text;
    text += kRecordFirstLine;
    text += '\n';
    appendHeadLines(text, "#", head);
    if (kind.from.empty()) {
        appendStartValues(text, "#", head);
        text += columns(head, paced_);
    } else {
        continueFrom(kind.from, text);
    }
    write(text);
    row_.reserve(kLongestRow);
    before_.reserve(kUsualNote);
    for (Waiting& step : steps_)
        step.before.reserve(kUsualNote);
}

/// Appends the start values and all rows of an ended record, and counts its rows.
void Record::continueFrom(const std::filesystem::path& record, std::string& text) {
    std::ifstream stream(record, std::ios::binary);
    if (!stream) throw InputError(record, 0, "cannot be read; expected the record of the attempt before");
    bool rows = false;
    for (std::string line; std::getline(stream, line) && line.rfind("# ended ", 0) != 0;) {
        const bool comment = line.rfind('#', 0) == 0;
        const bool start = line.rfind("# value ", 0) == 0 || line.rfind("# chosen ", 0) == 0;
        if (rows || start || !comment) text += line + '\n';
        if (rows && !comment) {
            ++rows_;
            if (paced_) pace_.add(parseDouble(line.substr(line.rfind(',') + 1)).value_or(1));
        }
        rows = rows || !comment; // the first line without a mark names the columns
    }
}

void Record::write(std::string_view text) {
    stream_.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream_.flush();
    if (!stream_) throw RuntimeFault(file_.string() + ": the record cannot be continued; " + writeExpectation(errno));
}

void RealTimeCount::add(double ratio) {
    ++steps_;
    realSteps_ += 1 / std::max(ratio, kLeastPace);
    least_ = std::min(least_, ratio);
}

void Record::event(std::string_view name, std::string_view value) {
    appendComment(before_, "event", name, value);
}

void Record::change(std::string_view key, std::string_view value) {
    appendComment(before_, "set", key, value);
}

void Record::add(const RecordStep& step) {
    Waiting& next = steps_[(oldest_ + waiting_) % kWaiting];
    next.step = step;
    next.before.swap(before_);
    before_.clear();
    ++waiting_;
    pace_.add(step.realTime);
}

void Record::complete(const MetalStatistics& metal) {
    const Waiting& oldest = steps_[oldest_];
    oldest_ = (oldest_ + 1) % kWaiting;
    --waiting_;
    row_ = oldest.before;
    appendTorchRow(row_, oldest.step.torch);
    appendCell(row_, std::uint64_t{metal.molten});
    for (const double temperature : {metal.minTemperature, metal.meanTemperature, metal.maxTemperature})
        appendCell(row_, arc_ ? celsius(temperature) : temperature); // the classic metal's temperatures have no unit
    appendCell(row_, std::uint64_t{metal.lost});
    appendCell(row_, std::uint64_t{metal.nonFinite});
    if (rod_) {
        row_ += ',';
        appendRodCells(row_, oldest.step.torch.rod);
    }
    if (arc_) appendArcCells(row_, oldest.step.arc);
    if (paced_) appendCell(row_, static_cast<float>(oldest.step.realTime));
    row_ += '\n';
    ++rows_;
    write(row_);
}

void Record::end(std::string_view reason, std::uint64_t stateHash) {
    std::string text = std::move(before_);
    appendComment(text, "ended", reason, {});
    appendComment(text, "state_hash", formatHexadecimal(stateHash), {});
    if (paced_ && rows_ > 0) {
        appendComment(text, "real_time", formatNumber(static_cast<float>(pace_.ratio())), {});
        appendComment(text, "least_real_time", formatNumber(static_cast<float>(pace_.least())), {});
    }
    write(text);
}

} // namespace meltpool
