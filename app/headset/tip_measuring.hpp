// Measures the position of the tip and the direction of the torch in the hand, and keeps them in a file.
#pragma once

#include "xr/input.hpp"
#include "xr/pivot.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace meltpool {

/// A calibration and the file it lives in.
class CalibrationFile {
  public:
    /// Read where the file exists. Throws InputError for a broken one.
    explicit CalibrationFile(std::filesystem::path file);

    const xr::TipCalibration& tip() const { return tip_; }
    /// Uses `tip` from now on and writes the file; the place or the direction that was not measured anew stays as the
    /// file has it by now, which another program may have measured. Answers what failed with the file; empty: nothing.
    std::string keep(const xr::TipCalibration& tip);

  private:
    std::filesystem::path file_;
    xr::TipCalibration tip_;
};

class TipMeasuring {
  public:
    enum class Task {
        pivot, ///< the tip rests in a dent while the torch is swung about it: its place
        axis,  ///< the torch stands upright, its tip down: its direction
    };

    void begin(Task task);
    bool underWay() const { return left_ > 0; }

    /// Takes the pose of a frame. When the time is over, answers the calibration `now` with the measured part replaced;
    /// nothing before that, and where the measurement was refused. `elapsed`: real seconds since the last frame.
    std::optional<xr::TipCalibration> gather(const xr::HandInput& torch, const xr::TipCalibration& now, double elapsed);
    /// Adds to the report that the file could not be written; an empty `fault` adds nothing.
    void kept(const std::string& fault);

    /// What to do and for how long, then what was found, as a sentence for the person.
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
