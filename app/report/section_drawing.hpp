// A section of the weld drawn to scale from its measured sizes, for pages without a picture of it.
#pragma once

#include <optional>
#include <string>

namespace meltpool {

/// Sizes in mm; one that is unknown or does not apply is left out of the drawing.
struct SectionSizes {
    std::optional<double> thickness;        ///< of the plate
    std::optional<double> toeWidth, height; ///< of a bead
    std::optional<double> legBase, legUpright, throat;
    std::optional<double> fusedWidth, penetration;

    bool fillet() const { return legBase && legUpright; }
};

/// Size of the drawing.
inline constexpr double kSectionWidth = 320, kSectionHeight = 130;

/// Units per millimetre, so that everything has room; 0 if there is nothing to draw.
double sectionScale(const SectionSizes& sizes);

/// <svg> element with the sizes next to it; empty if neither a bead's width and height nor a fillet's legs are known.
/// The outline of a bead is a parabola over its toes, that of a fillet one through its throat; the fused zone is an
/// ellipse of its width and depth.
std::string sectionDrawing(const SectionSizes& sizes);

} // namespace meltpool
