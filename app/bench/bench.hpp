// Measuring: suites of named measurements whose rows become a table and a JSON file.
#pragma once

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
    double meanMs = 0; ///< over all repeats: also of a pass that has much to do only now and then
};

/// One measured case. Times are the least of several repeats, ms.
struct BenchRow {
    std::string suite;
    std::string what;              ///< which measurement of the suite: "step", "frame", ...
    size_t particles = 0;          ///< 0 where there are none
    double stepMs = 0;             ///< one step, frame or whatever `what` says
    std::vector<BenchPass> passes; ///< inside
    double bytesPerParticle = 0;   ///< GPU memory; 0 where it says nothing
    size_t bytes = 0;              ///< GPU memory in all
    /// Further numbers under names of their own: ratios, rates, grid sizes.
    std::vector<std::pair<std::string, double>> further;
};

/// Wall time, ms.
inline double millisecondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Makes `row` the lesser of two rows of the same measurement, number by number; takes `again` where it is empty.
void keepLeast(BenchRow& row, BenchRow again);

/// What a suite works with.
class Bench {
  public:
    Bench(gl::ShaderLibrary& shaders, std::string suite) : shaders_(shaders), suite_(std::move(suite)) {}

    gl::ShaderLibrary& shaders() { return shaders_; }

    /// Fills stepMs and passes of a row that carries the suite's name: runs `work` a few times to warm up, then until
    /// `seconds` of wall time or `mostRepeats` have passed (at least `leastRepeats`), each time waiting for the GPU,
    /// and keeps the least. `work` gets a profiler whose frame is open.
    BenchRow measure(std::string what, const std::function<void(gl::Profiler&)>& work, double seconds = 1.0,
                     int leastRepeats = 3, int mostRepeats = 200);

    /// Adds the row and prints its line. Throws RuntimeFault where a signal has asked to stop, see StopSignals.
    void add(BenchRow row);

    const std::vector<BenchRow>& rows() const { return rows_; }

  private:
    gl::ShaderLibrary& shaders_;
    std::string suite_;
    std::vector<BenchRow> rows_;
};

/// A part of a suite; parts of the same suite run in the order of the list.
struct BenchPart {
    std::string_view suite;
    std::string_view note; ///< one line for `meltpool bench --help`
    void (*run)(Bench&);
};

/// Every part there is (app/bench/parts.cpp).
std::span<const BenchPart> benchParts();

/// The report of some rows: renderer, driver, processor, version, commit and date once at the top, then one object a
/// row. `complete`: no row is to come.
std::string benchJson(const gl::ContextInfo& driver, const std::vector<BenchRow>& rows, bool complete);

/// `meltpool bench`: runs one suite, or all for "". Prints the table and writes the JSON where a file is named, anew
/// after each part. A signal ends it after the row that it measures: RuntimeFault, and the rows are kept. Throws
/// InputError, listing the suites, for an unknown one.
void runBench(const std::string& suite, const std::filesystem::path& jsonFile);

} // namespace meltpool
