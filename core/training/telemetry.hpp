// The record of a run: the torch and the metal over time, as a CSV that is a torch path again.
#pragma once

#include "core/metal/state/statistics.hpp"
#include "core/weld/process/arc.hpp"
#include "core/weld/torch/torch_sample.hpp"

#include <cstddef>
#include <filesystem>
#include <fstream>

namespace meltpool {

class Telemetry {
  public:
    /// Begins the file with its header, with columns for the arc where it has one. Throws InputError when it cannot be
    /// written.
    explicit Telemetry(const std::filesystem::path& file, bool withArc = false);

    /// Adds one row; `arc` where there are columns for it, else nullptr. Throws RuntimeFault when the disk takes no
    /// more.
    void add(const TorchSample& torch, const MetalStatistics& metal, const ArcState* arc = nullptr);

    /// Brings every row to the disk. Throws RuntimeFault when it takes no more.
    void flush();

    const std::filesystem::path& file() const { return file_; }
    size_t rows() const { return rows_; }

  private:
    std::filesystem::path file_;
    std::ofstream stream_;
    std::string row_; ///< keeps its room from row to row
    size_t rows_ = 0;
};

} // namespace meltpool
