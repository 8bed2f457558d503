// The cost of recording an attempt: a weld with and without a recording, second by second in turns.
#include "app/activities/redo.hpp"
#include "app/bench/bench.hpp"
#include "app/bench/parts.hpp"
#include "core/base/resources.hpp"
#include "core/training/trainer/trainer.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <limits>
#include <random>

namespace meltpool {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr double kWarmUp = 2; ///< s of the demonstration
constexpr int kSeconds = 4;   ///< measured seconds, each of them a repeat

/// File of this process alone, until the end of the benchmark.
class ScratchFile {
  public:
    ScratchFile()
        : path_(fs::temp_directory_path() / ("meltpool-bench-" + std::to_string(std::random_device()()) + ".meltrec")) {
    }
    ~ScratchFile() {
        std::error_code ignored;
        fs::remove(path_, ignored);
    }
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;

    const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

/// Demonstration of gmaw-bead, recorded with checkpoints of the whole metal if there is a writer.
class TimedWeld {
  public:
    TimedWeld(Bench& bench, const Lesson& lesson) : trainer_(bench.shaders(), lesson) {}

    Trainer& trainer() { return trainer_; }

    void record(std::shared_ptr<RecordingWriter> writer) {
        trainer_.recordInto(writer);
        redo_.begin(std::move(writer));
        recorded_ = true;
    }

    /// Welds on to this time, s, and adds up the time that it took.
    void weldUntil(double time) {
        const auto start = Clock::now();
        const std::clock_t spent = std::clock();
        while (trainer_.time() < time) {
            const auto step = Clock::now();
            trainer_.advanceDemonstration(nullptr);
            if (recorded_) redo_.update(trainer_, 1);
            longestMs = std::max(longestMs, millisecondsSince(step));
        }
        glFinish();
        leastMs = std::min(leastMs, millisecondsSince(start));
        processorMs += static_cast<double>(std::clock() - spent) * 1e3 / CLOCKS_PER_SEC;
    }

    void forget() {
        leastMs = std::numeric_limits<double>::infinity();
        longestMs = processorMs = 0;
    }

    double leastMs = std::numeric_limits<double>::infinity(); ///< least of the calls of weldUntil()
    double longestMs = 0;                                     ///< longest step
    double processorMs = 0;                                   ///< ms of all this program's threads

  private:
    Trainer trainer_;
    Redo redo_;
    bool recorded_ = false;
};

} // namespace

void benchRecording(Bench& bench) {
    const Lesson lesson = findLesson("gmaw-bead", resourceFolder() / "data" / "lessons");
    const ScratchFile file;
    TimedWeld plain(bench, lesson), recorded(bench, lesson);
    const auto writer = std::make_shared<RecordingWriter>(file.path(), recorded.trainer().attemptHead());
    recorded.record(writer);
    for (TimedWeld* weld : {&plain, &recorded}) {
        weld->weldUntil(kWarmUp);
        weld->forget();
    }
    for (int second = 1; second <= kSeconds; ++second)
        for (TimedWeld* weld : {&plain, &recorded})
            weld->weldUntil(kWarmUp + second);
    recorded.trainer().stopRecord("the benchmark ended");
    writer->wait();
    BenchRow row;
    row.suite = "lesson";
    row.what = lesson.key + ", a second recorded";
    row.particles = recorded.trainer().result().metal.particles;
    row.stepMs = recorded.leastMs;
    row.further = {{"over_unrecorded", recorded.leastMs / plain.leastMs},
                   {"over_unrecorded_cpu", recorded.processorMs / plain.processorMs},
                   {"longest_step_ms", recorded.longestMs},
                   {"longest_step_unrecorded_ms", plain.longestMs},
                   {"bytes_a_second", static_cast<double>(fs::file_size(file.path())) / recorded.trainer().time()}};
    bench.add(std::move(row));
}

} // namespace meltpool
