// The benchmark: suites of named measurements whose rows become a table and a JSON file.
#pragma once

#include "app/platform/result_head.hpp"
#include "core/gl/context.hpp"
#include "core/gl/profiler.hpp"
#include "core/gl/program.hpp"

#include <chrono>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meltpool {

/// GPU time of a pass, ms.
struct BenchPass {
    std::string name;
    double leastMs = 0;
    double meanMs = 0; ///< over all repeats: also meaningful for a pass that rarely has much to do
};

/// One measured case. Times are the least of several repeats, ms.
struct BenchRow {
    std::string suite;
    std::string what;              ///< name of the suite's measurement: "step", "frame", ...
    size_t particles = 0;          ///< 0 if there are none
    double stepMs = 0;             ///< ms per step, frame or other unit that `what` names
    std::vector<BenchPass> passes; ///< passes in it
    double bytesPerParticle = 0;   ///< GPU memory; 0 if it does not apply
    size_t bytes = 0;              ///< GPU memory in total
    /// Further numbers with names of their own: ratios, rates, grid sizes.
    std::vector<std::pair<std::string, double>> further;
};

/// Wall time since `start`, ms.
inline double millisecondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Makes `row` the lesser of two rows of one measurement, number by number; takes `again` if it is empty.
void keepLeast(BenchRow& row, BenchRow again);

/// Measuring for a suite.
class Bench {
  public:
    Bench(gl::ShaderLibrary& shaders, std::string suite) : shaders_(shaders), suite_(std::move(suite)) {}

    gl::ShaderLibrary& shaders() { return shaders_; }

    /// Fills stepMs and passes of a row that carries the suite's name: runs `work` a few times to warm up, then until
    /// `seconds` of wall time or `mostRepeats` have passed (at least `leastRepeats`), each time waiting for the GPU,
    /// and takes the least. `work` gets a profiler whose frame is open.
    BenchRow measure(std::string what, const std::function<void(gl::Profiler&)>& work, double seconds = 1.0,
                     int leastRepeats = 3, int mostRepeats = 200);

    /// Adds the row and prints its line. Throws RuntimeFault if a signal has asked to stop, see StopSignals.
    void add(BenchRow row);

    const std::vector<BenchRow>& rows() const { return rows_; }

  private:
    gl::ShaderLibrary& shaders_;
    std::string suite_;
    std::vector<BenchRow> rows_;
};

/// Part of a suite; parts of one suite run in the order of the list.
struct BenchPart {
    std::string_view suite;
    std::string_view note; ///< line for `meltpool bench --help`
    void (*run)(Bench&);
};

/// All parts (app/bench/parts.cpp).
std::span<const BenchPart> benchParts();

/// Report of some rows: resultHead() at the top, then one object per row. `complete`: no row is to come.
std::string benchJson(const gl::ContextInfo& driver, const std::vector<BenchRow>& rows, bool complete);

/// Runs `meltpool bench`: one suite, or all for "". Prints the table and writes the JSON to its place, again after each
/// part. A signal ends it after the current row: RuntimeFault, with the rows written. Throws InputError,
/// listing the suites, for an unknown one.
void runBench(const std::string& suite, const ResultPlace& place);

} // namespace meltpool
