// Runs the real program in a process of its own and reads the telemetry that its window writes.
#pragma once

#include "tests/support/telemetry_rows.hpp"
#include "tests/xr/monado_run.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace meltpool::test {

class TrainerProcess {
  public:
    /// Starts `meltpool ARGUMENTS --telemetry ...` with settings of its own (small pictures, so that a software driver
    /// keeps pace). `headset`: further lines of its [headset] settings, or all of them if they begin with
    /// resolution_scale; `window`: further lines of the [window]'s.
    /// `preload`: library that is loaded before it.
    TrainerProcess(std::filesystem::path folder, std::vector<std::string> arguments, const std::string& headset = {},
                   const std::string& preload = {}, const std::string& window = {});
    ~TrainerProcess();
    TrainerProcess(const TrainerProcess&) = delete;
    TrainerProcess& operator=(const TrainerProcess&) = delete;

    /// Newest row of the telemetry; empty until there is one.
    nlohmann::json now();
    /// Returns every row so far.
    std::vector<nlohmann::json> rows();
    /// Reads rows 20 times a second until `done(row)` for the newest row or any after it; `meanwhile` runs before each
    /// look. Returns false if the program has ended, or after kPatience.
    bool waitFor(const std::function<bool(const nlohmann::json&)>& done, const std::function<void()>& meanwhile = {});
    /// Asks the program to end as Ctrl+C does; returns its exit status.
    int stop();
    /// Sends it a signal.
    void signal(int number) const;
    /// Waits until the program has ended by itself; returns its exit status. After kPatience it is killed: 137.
    int finish();
    bool alive();
    /// Returns the validation layer's messages about the program.
    std::string misuses() const;

  private:
    std::filesystem::path folder_;
    TelemetryRows rows_;
    int pid_ = -1;
    int status_ = -1;
};

/// Runs `meltpool ARGUMENTS` to its end; returns the exit status.
int runTrainer(const std::vector<std::string>& arguments);

} // namespace meltpool::test
