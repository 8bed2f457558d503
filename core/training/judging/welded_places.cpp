#include "core/training/judging/welded_places.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr double kCell = 0.5e-3;       ///< m
constexpr double kBeyond = 20e-3;      ///< m of way beyond a straight seam's ends
constexpr double kPoolLength = 1.5e-3; ///< m before and behind the arc that melt at once
constexpr double kPoolWidth = 4e-3;    ///< m from the arc to each side, within which its weld covers a line

} // namespace

WeldedPlaces::WeldedPlaces(const Seam& seam, double line)
    : closed_(seam.closed()), begin_(seam.closed() ? seam.begin() : seam.begin() - kBeyond), line_(line) {
    const double length = seam.length() + (closed_ ? 0 : 2 * kBeyond);
    cells_.assign(static_cast<size_t>(std::max(std::ceil(length / kCell), 1.0)), 0);
}

/// Returns the cell of a place; of a straight seam the first or last one beyond its ends.
size_t WeldedPlaces::cellAt(double place) const {
    const auto count = static_cast<double>(cells_.size());
    double cell = std::floor((place - begin_) / kCell);
    if (closed_) cell -= std::floor(cell / count) * count;
    return static_cast<size_t>(std::clamp(cell, 0.0, count - 1));
}

void WeldedPlaces::weld(const TechniqueStep& step) {
    if (!step.welds || !(std::abs(step.aim - line_) < kPoolWidth)) return;
    for (double place = step.place - kPoolLength; place <= step.place + kPoolLength; place += kCell) {
        char& cell = cells_[cellAt(place)];
        changes_ += cell == 0;
        cell = 1;
    }
}

void WeldedPlaces::update(const Technique& technique) {
    const std::vector<TechniqueStep>& steps = technique.steps();
    const auto isLast = [this](const TechniqueStep& step) {
        return step.time == last_.time && step.place == last_.place && step.aim == last_.aim;
    };
    if (steps.size() < taken_ || (taken_ > 0 && !isLast(steps[taken_ - 1]))) {
        std::fill(cells_.begin(), cells_.end(), char(0));
        taken_ = 0;
        ++changes_;
    }
    for (; taken_ < steps.size(); ++taken_)
        weld(steps[taken_]);
    if (taken_ > 0) last_ = steps[taken_ - 1];
}

bool WeldedPlaces::any(double from, double to) const {
    for (double place = std::min(from, to); place <= std::max(from, to); place += kCell / 2)
        if (cells_[cellAt(place)] != 0) return true;
    return false;
}

} // namespace meltpool
