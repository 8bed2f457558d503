#include "core/training/telemetry.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/weld/torch/torch_csv.hpp"

namespace meltpool {

namespace {

/// Rows between flushes: a second of welding at most is lost when the power goes.
constexpr size_t kRowsPerFlush = 60;
/// 22 cells of no more than 24 characters each.
constexpr size_t kLongestRow = 640;

} // namespace

Telemetry::Telemetry(const std::filesystem::path& file, bool withArc) : file_(file), stream_(file, std::ios::trunc) {
    if (!stream_) throw InputError(file, 0, "cannot be written; expected a folder with write permission");
    std::string header;
    for (const std::string_view name : torchColumns())
        header += (header.empty() ? "" : ",") + std::string(name);
    stream_ << header << ",molten,min_temperature,mean_temperature,max_temperature,lost,non_finite"
            << (withArc ? ",arc_length_mm,current_a,voltage_v,arc_state,ctwd_mm,extension_mm,power_w\n" : "\n");
    flush();
    row_.reserve(kLongestRow);
}

void Telemetry::add(const TorchSample& torch, const MetalStatistics& metal, const ArcState* arc) {
    const auto cell = [this](auto value) {
        row_ += ',';
        appendNumber(row_, value);
    };
    row_.clear();
    appendTorchRow(row_, torch);
    cell(std::uint64_t{metal.molten});
    cell(metal.minTemperature);
    cell(metal.meanTemperature);
    cell(metal.maxTemperature);
    cell(std::uint64_t{metal.lost});
    cell(std::uint64_t{metal.nonFinite});
    if (arc != nullptr) {
        cell(static_cast<double>(arc->length) * 1e3);
        cell(static_cast<double>(arc->current));
        cell(static_cast<double>(arc->voltage));
        row_ += ',';
        row_ += arcActionName(arc->action);
        cell(static_cast<double>(arc->distance) * 1e3);
        cell(static_cast<double>(arc->extension) * 1e3);
        cell(arc->power);
    }
    row_ += '\n';
    stream_ << row_;
    ++rows_;
    if (rows_ % kRowsPerFlush == 0) flush();
}

void Telemetry::flush() {
    stream_.flush();
    if (!stream_) throw RuntimeFault(file_.string() + ": the record cannot be written on; expected free space");
}

} // namespace meltpool
