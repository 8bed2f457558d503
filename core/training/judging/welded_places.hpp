// Places of a seam that have been welded, for marks and cues that a weld covers.
#pragma once

#include "core/training/judging/technique.hpp"

#include <vector>

namespace meltpool {

class WeldedPlaces {
  public:
    /// `line`: place across the seam (m) of the line whose welded places count.
    explicit WeldedPlaces(const Seam& seam, double line = 0);

    /// Takes the technique's new steps; begins again if its earlier steps are others. Allocates nothing.
    void update(const Technique& technique);
    /// True if the line has been welded somewhere from place `from` to `to` (m, in either order).
    bool any(double from, double to) const;
    /// Number of changes.
    size_t changes() const { return changes_; }

  private:
    size_t cellAt(double place) const;
    void weld(const TechniqueStep& step);

    bool closed_ = false;
    double begin_ = 0;
    double line_ = 0;
    std::vector<char> cells_; ///< 1: welded, for each kCell of the seam
    size_t taken_ = 0;        ///< steps of the technique that are in cells_
    TechniqueStep last_;      ///< the last of them
    size_t changes_ = 0;
};

} // namespace meltpool
