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

    /// Returns false if there is no measured tip.
    bool measured() const { return measured_; }
    const xr::TipCalibration& tip() const { return tip_; }
    /// Uses `tip` from now on and writes the file. A place or direction that is equal to `before` was not measured; it
    /// is the file's current one, which another program may have measured. Returns the fault of the file; empty: none.
    std::string keep(const xr::TipCalibration& tip, xr::TipCalibration before);
    /// Forgets the measured tip and removes the file. Returns the fault of the file; empty: none.
    std::string forget();

  private:
    std::filesystem::path file_;
    xr::TipCalibration tip_;
    bool measured_ = false;
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
    /// Ends a measurement: the torch's own tip is used again. `fault`: of removing the file; empty: none.
    void forgotten(const std::string& fault);

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
