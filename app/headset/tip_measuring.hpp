// Measures the position of the tip and the direction of the torch in the hand, and stores them in a file.
#pragma once

#include "xr/input.hpp"
#include "xr/pivot.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace meltpool {

/// Holds a calibration and its file.
class CalibrationFile {
  public:
    /// Reads the file if it exists. Throws InputError for a broken one.
    explicit CalibrationFile(std::filesystem::path file);

    const xr::TipCalibration& tip() const { return tip_; }
    /// Uses `tip` from now on and writes the file. The unmeasured place or direction is the file's current one, which
    /// another program may have measured. Returns the fault of the file; empty: none.
    std::string keep(const xr::TipCalibration& tip);

  private:
    std::filesystem::path file_;
    xr::TipCalibration tip_;
};

class TipMeasuring {
  public:
    enum class Task {
        pivot, ///< place of the tip: it rests in a dent while the torch swings about it
        axis,  ///< direction of the torch: it is upright, its tip down
    };

    void begin(Task task);
    bool underWay() const { return left_ > 0; }

    /// Takes the pose of a frame. When the time is over, returns the calibration `now` with the measured part replaced;
    /// empty before that, and if the measurement was refused. `elapsed`: real seconds since the last frame.
    std::optional<xr::TipCalibration> gather(const xr::HandInput& torch, const xr::TipCalibration& now, double elapsed);
    /// Adds the fault of writing the file to the report; an empty `fault` adds nothing.
    void kept(const std::string& fault);

    /// Sentence for the person: task and remaining time, then the result.
    std::string report() const;

  private:
    std::optional<xr::TipCalibration> finish(xr::TipCalibration tip);

    Task task_ = Task::pivot;
    double left_ = 0;  ///< s
    double spent_ = 0; ///< s
    std::vector<xr::Pose> poses_;
    std::string found_;
};

} // namespace meltpool
