#include "app/headset/tip_measuring.hpp"

#include "core/base/file_lock.hpp"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace meltpool {

namespace {

constexpr double kPivotSeconds = 12;
constexpr double kAxisSeconds = 3;
constexpr double kGettingReady = 5;  ///< s before the first pose counts, to bring the torch into place
constexpr size_t kWishedPoses = 120; ///< measuring goes on until there are so many ...
constexpr double kLongest = 35;      ///< ... for this long at most, s

std::string decimals(float value, int digits) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.*f", digits, static_cast<double>(value));
    return text.data();
}

} // namespace

CalibrationFile::CalibrationFile(std::filesystem::path file) : file_(std::move(file)) {
    if (std::filesystem::exists(file_)) tip_ = xr::readCalibration(file_);
}

std::string CalibrationFile::keep(const xr::TipCalibration& tip) {
    const xr::TipCalibration before = std::exchange(tip_, tip);
    try {
        const FileTurn turn(file_);
        xr::TipCalibration written = tip;
        if (std::filesystem::exists(file_)) {
            const xr::TipCalibration others = xr::readCalibration(file_);
            if (tip.offset == before.offset && tip.residualMm == before.residualMm) {
                written.offset = others.offset;
                written.residualMm = others.residualMm;
            }
            if (tip.orientation == before.orientation) written.orientation = others.orientation;
        }
        xr::writeCalibration(file_, written);
        tip_ = written;
    } catch (const std::exception& fault) {
        return fault.what();
    }
    return {};
}

void TipMeasuring::begin(Task task) {
    task_ = task;
    left_ = kGettingReady + (task == Task::pivot ? kPivotSeconds : kAxisSeconds);
    spent_ = 0;
    poses_.clear();
    poses_.reserve(4096);
}

std::optional<xr::TipCalibration> TipMeasuring::gather(const xr::HandInput& torch, const xr::TipCalibration& now,
                                                       double elapsed) {
    if (!underWay()) return std::nullopt;
    spent_ += elapsed;
    left_ -= elapsed;
    if (torch.tracked && spent_ > kGettingReady) poses_.push_back(torch.grip);
    const bool more = task_ == Task::pivot && poses_.size() < kWishedPoses && spent_ < kLongest;
    if (more && left_ <= 0) left_ = 1;
    if (left_ > 0) return std::nullopt;
    left_ = 0;
    return finish(now);
}

std::optional<xr::TipCalibration> TipMeasuring::finish(xr::TipCalibration tip) {
    if (task_ == Task::axis) {
        const xr::AxisResult axis = xr::solveAxis(poses_);
        found_ = axis.accepted ? "The torch's direction was found, to " + decimals(axis.spreadDegrees, 1) + " degrees."
                               : "The torch's direction was not found: " + axis.reason + ".";
        if (!axis.accepted) return std::nullopt;
        tip.pointAlong(axis.direction);
        return tip;
    }
    const xr::PivotResult pivot = xr::solvePivot(poses_);
    if (!pivot.accepted) {
        found_ = "The tip was not found: " + pivot.reason + ".";
        return std::nullopt;
    }
    found_ = "The tip was found, " + decimals(1000 * glm::length(pivot.offset), 0) + " mm from the grip, certain to " +
             decimals(pivot.errorMm, 2) + " mm (it wandered " + decimals(pivot.residualMm, 1) + " mm on average).";
    tip.offset = pivot.offset;
    tip.residualMm = pivot.residualMm;
    return tip;
}

void TipMeasuring::kept(const std::string& fault) {
    if (!fault.empty()) found_ += " It could not be kept: " + fault;
}

std::string TipMeasuring::report() const {
    if (!underWay()) return found_;
    const bool ready = spent_ > kGettingReady;
    const std::string seconds =
        std::to_string(static_cast<int>(std::ceil(ready ? left_ : kGettingReady - spent_))) + " s";
    if (task_ == Task::axis)
        return "Stand the torch upright, its tip straight down, " +
               (ready ? "and hold it still: " + seconds : "measuring begins in " + seconds);
    return "Rest the tip in a small dent, " +
           (ready ? "swing the torch about it to all sides: " + seconds : "measuring begins in " + seconds);
}

} // namespace meltpool
