#include "app/bench/bench.hpp"

#include "app/platform/lock_notice.hpp"
#include "app/platform/program_info.hpp"
#include "app/platform/result_head.hpp"
#include "app/platform/stop_signals.hpp"
#include "core/base/error.hpp"
#include "core/base/file_lock.hpp"
#include "core/base/output_file.hpp"
#include "core/base/resources.hpp"
#include "core/base/text.hpp"
#include "core/gl/software_driver/software_driver.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <exception>
#include <fstream>
#include <limits>
#include <optional>
#include <thread>

namespace meltpool {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kWarmUps = 2;

void printRow(const BenchRow& row) {
    std::printf("%-10s %-40s %9zu %11.3f %9.1f %10.2f", row.suite.c_str(), row.what.c_str(), row.particles, row.stepMs,
                row.bytesPerParticle, static_cast<double>(row.bytes) / 1048576);
    for (const auto& [name, value] : row.further)
        std::printf("  %s=%.4g", name.c_str(), value);
    std::printf("\n");
    for (const BenchPass& pass : row.passes)
        std::printf("%-10s   %-38s %9s %11.3f  mean_ms=%.3f\n", "", pass.name.c_str(), "", pass.leastMs, pass.meanMs);
    std::fflush(stdout);
}

/// Runs a part as far as it comes and returns the fault that ended it early, so that the rows before it can be written
/// first.
std::exception_ptr faultOf(const BenchPart& part, Bench& bench) {
    try {
        part.run(bench);
    } catch (...) {
        return std::current_exception();
    }
    return nullptr;
}

} // namespace

BenchRow Bench::measure(std::string what, const std::function<void(gl::Profiler&)>& work, double seconds,
                        int leastRepeats, int mostRepeats) {
    gl::Profiler profiler;
    const auto once = [&] {
        const auto start = Clock::now();
        profiler.beginFrame();
        work(profiler);
        profiler.endFrame();
        glFinish();
        return millisecondsSince(start);
    };
    for (int i = 0; i < kWarmUps; ++i)
        once();
    profiler.reset();
    double least = std::numeric_limits<double>::infinity();
    const auto begin = Clock::now();
    int repeats = 0;
    for (; repeats < mostRepeats && (repeats < leastRepeats || millisecondsSince(begin) < seconds * 1e3); ++repeats)
        least = std::min(least, once());
    profiler.finish();
    BenchRow row;
    row.suite = suite_;
    row.what = std::move(what);
    row.stepMs = least;
    for (const gl::PassTime& pass : profiler.passes())
        row.passes.push_back({pass.name, pass.leastMs, pass.totalMs / repeats});
    return row;
}

void Bench::add(BenchRow row) {
    printRow(row);
    rows_.push_back(std::move(row));
    if (StopSignals::asked()) throw RuntimeFault("the measurement was stopped before its end");
}

void keepLeast(BenchRow& row, BenchRow again) {
    if (row.what.empty()) {
        row = std::move(again);
        return;
    }
    row.stepMs = std::min(row.stepMs, again.stepMs);
    for (size_t i = 0; i < row.passes.size(); ++i)
        row.passes[i] = {row.passes[i].name, std::min(row.passes[i].leastMs, again.passes[i].leastMs),
                         std::min(row.passes[i].meanMs, again.passes[i].meanMs)};
    for (size_t i = 0; i < row.further.size(); ++i)
        row.further[i].second = std::min(row.further[i].second, again.further[i].second);
}

std::string benchJson(const gl::ContextInfo& driver, const std::vector<BenchRow>& rows, bool complete) {
    nlohmann::ordered_json json = resultHead(driver);
    json["complete"] = complete;
    auto& list = json["rows"] = nlohmann::ordered_json::array();
    for (const BenchRow& row : rows) {
        nlohmann::ordered_json object;
        object["suite"] = row.suite;
        object["what"] = row.what;
        object["particles"] = row.particles;
        object["step_ms"] = row.stepMs;
        object["passes"] = nlohmann::ordered_json::object();
        object["mean_of_passes"] = nlohmann::ordered_json::object();
        for (const BenchPass& pass : row.passes) {
            object["passes"][pass.name] = pass.leastMs;
            object["mean_of_passes"][pass.name] = pass.meanMs;
        }
        object["bytes_per_particle"] = row.bytesPerParticle;
        object["bytes"] = row.bytes;
        for (const auto& [name, value] : row.further)
            object[name] = value;
        list.push_back(std::move(object));
    }
    return json.dump(2) + "\n";
}

void runBench(const std::string& suite, const ResultPlace& place) {
    const StopSignals signals("\nmeltpool: stops after this row; Ctrl-C again ends it at once\n");
    std::vector<BenchPart> chosen;
    std::string known;
    for (const BenchPart& part : benchParts()) {
        if (suite.empty() || part.suite == suite) chosen.push_back(part);
        if (known.find(part.suite) == std::string::npos) known += (known.empty() ? "" : ", ") + std::string(part.suite);
    }
    if (chosen.empty()) throw InputError("bench suite " + quote(suite) + " is unknown; expected one of " + known);
    if (suite == "weld") gl::runDriverSingleThreaded(); // as the window and runs without pictures do
    const gl::HeadlessContext context(false);
    const std::filesystem::path jsonFile = place.file(context.info(), "bench-" + (suite.empty() ? "all" : suite));
    const bool keeps = !jsonFile.empty() && isPlainFile(jsonFile);
    std::optional<FileLock> lock;
    if (keeps) tellUnlocked(lock.emplace(jsonFile.string() + ".lock", jsonFile));
    std::vector<BenchRow> rows;
    // A report that cannot be written must fail now, not after the minutes of measuring.
    if (keeps) writeTextFileAtomically(jsonFile, benchJson(context.info(), rows, false));
    gl::ShaderLibrary shaders(resourceFolder() / "shaders");
    std::printf("%s, %s; %s, %u threads%s; meltpool %s\n", context.info().renderer.c_str(),
                context.info().version.c_str(), processorName().c_str(), std::thread::hardware_concurrency(),
                gl::driverIsSingleThreaded() ? ", of which the driver has one" : "", programBuild().c_str());
    std::printf("%-10s %-40s %9s %11s %9s %10s\n", "suite", "row / pass", "particles", "ms (least)", "B/part.", "MiB");
    for (const BenchPart& part : chosen) {
        Bench bench(shaders, std::string(part.suite));
        const std::exception_ptr fault = faultOf(part, bench);
        rows.insert(rows.end(), bench.rows().begin(), bench.rows().end());
        if (keeps) writeTextFileAtomically(jsonFile, benchJson(context.info(), rows, false));
        if (fault) std::rethrow_exception(fault);
    }
    if (!jsonFile.empty()) writeTextFileAtomically(jsonFile, benchJson(context.info(), rows, true));
}

} // namespace meltpool
