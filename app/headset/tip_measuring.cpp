#include "app/headset/tip_measuring.hpp"

#include "core/base/file_lock.hpp"
#include "core/base/words.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <utility>

namespace meltpool {

namespace {

constexpr double kPivotSeconds = 12;
constexpr double kAxisSeconds = 3;
constexpr double kGettingReady = 5;  ///< s before the first pose counts: time to bring the torch into place
constexpr size_t kWishedPoses = 120; ///< measuring ends at this number of poses ...
constexpr double kLongest = 35;      ///< ... or after this time, s

PhraseNumber decimals(float value, int digits) {
    return PhraseNumber(static_cast<double>(value), digits);
}

} // namespace

CalibrationFile::CalibrationFile(std::filesystem::path file) : file_(std::move(file)) {
    if (!std::filesystem::exists(file_)) return;
    tip_ = xr::readCalibration(file_);
    measured_ = true;
}

std::string CalibrationFile::keep(const xr::TipCalibration& tip, xr::TipCalibration before) {
    tip_ = tip;
    measured_ = true;
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

std::string CalibrationFile::forget() {
    measured_ = false;
    try {
        const FileTurn turn(file_);
        std::filesystem::remove(file_);
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
        found_ = axis.accepted ? phrase("headset.tip.axis.found", {{"degrees", decimals(axis.spreadDegrees, 1)}})
                               : phrase("headset.tip.axis.not_found", {{"reason", axis.reason}});
        if (!axis.accepted) return std::nullopt;
        tip.pointAlong(axis.direction);
        return tip;
    }
    const xr::PivotResult pivot = xr::solvePivot(poses_);
    if (!pivot.accepted) {
        found_ = phrase("headset.tip.pivot.not_found", {{"reason", pivot.reason}});
        return std::nullopt;
    }
    found_ = phrase("headset.tip.pivot.found", {{"distance", decimals(1000 * glm::length(pivot.offset), 0)},
                                                {"error", decimals(pivot.errorMm, 2)},
                                                {"wandered", decimals(pivot.residualMm, 1)}});
    tip.offset = pivot.offset;
    tip.residualMm = pivot.residualMm;
    return tip;
}

void TipMeasuring::kept(const std::string& fault) {
    if (!fault.empty()) found_ += " " + phrase("headset.tip.not_kept", {{"reason", fault}});
}

void TipMeasuring::forgotten(const std::string& fault) {
    left_ = 0;
    found_ = phrase("headset.tip.own");
    kept(fault);
}

std::string TipMeasuring::report() const {
    if (!underWay()) return found_;
    const bool ready = spent_ > kGettingReady;
    const PhraseNumber seconds(std::ceil(ready ? left_ : kGettingReady - spent_));
    if (task_ == Task::axis)
        return phrase(ready ? "headset.tip.axis.measures" : "headset.tip.axis.begins", {{"seconds", seconds}});
    return phrase(ready ? "headset.tip.pivot.measures" : "headset.tip.pivot.begins", {{"seconds", seconds}});
}

} // namespace meltpool
