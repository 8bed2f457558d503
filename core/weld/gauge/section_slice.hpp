// One slice of the workpiece before welding, one lattice cell thick, and the zones in it that were hot.
#pragma once

#include <glm/vec2.hpp>

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace meltpool {

/// A grid of cells across the seam: x counts columns towards the welder (+z), y counts rows upwards. Each cell that
/// held metal at the start has the highest temperature (K) of that metal so far.
class SectionSlice {
  public:
    static constexpr double kAir = -std::numeric_limits<double>::infinity(); ///< cell that held no metal at the start
    static constexpr double kGone = std::numeric_limits<double>::infinity(); ///< cell whose metal melted and moved away

    explicit SectionSlice(glm::ivec2 cells);

    glm::ivec2 cells() const { return cells_; }
    bool inside(glm::ivec2 cell) const;
    /// Returns the highest temperature (K) of a cell; kAir outside the grid.
    double peak(glm::ivec2 cell) const;
    /// Sets the highest temperature of a cell inside the grid.
    void setPeak(glm::ivec2 cell, double kelvin);
    bool held(glm::ivec2 cell) const { return peak(cell) != kAir; }
    /// Returns true if the cell held metal and its neighbour on that side did not: a face of the workpiece.
    bool isFace(glm::ivec2 cell, glm::ivec2 side) const { return held(cell) && !held(cell + side); }

  private:
    glm::ivec2 cells_;
    std::vector<double> peaks_;
};

/// The part of a slice that was at least as hot as a given temperature; lengths in cells, places from the grid's
/// corner.
struct SliceZone {
    double width = 0;  ///< width of the workpiece's surface in the zone, along the surface
    double middle = 0; ///< middle of that width from the grid's corner, if there is one side; 0 without width
    double depth = 0;  ///< greatest distance from the workpiece's surface
    double area = 0;   ///< cells
    /// Low corner of the box around the zone; above `high` for an empty zone.
    glm::dvec2 low{std::numeric_limits<double>::infinity()};
    glm::dvec2 high{-std::numeric_limits<double>::infinity()}; ///< high corner of the box around the zone
};

/// Measures the zone above `level` (K). `sides`: the outward directions of the faces that are welded on, as unit steps.
///
/// Edges of the zone are at the places that reached the level, linear between the cells' centres; next to a hotter cell
/// that is gone they follow from the slope on the colder side. Between the centre of a face cell and its face the
/// temperature goes on with the slope under that cell, so that a zone less deep than half a cell is found too.
///
/// The width of each plane of faces is that of the hot stretch around its hottest cell; planes add up, and a gap
/// between two hot edges belongs to the stretch. With one side, which is up, the uppermost cells of all columns count
/// as one plane: a bevel is as wide as its groove. The area is summed in strips of cells inwards from the faces. With
/// one side both are taken by the cells whose centres, half a cell below the faces, are hot; with several, in a corner
/// that is often only just fused, at the faces themselves.
SliceZone measureZone(const SectionSlice& slice, std::span<const glm::ivec2> sides, double level);

/// Returns the cell of air in the corner of a tee or a lap joint: the lowest one with metal under it and behind it
/// (-x).
std::optional<glm::ivec2> jointCorner(const SectionSlice& slice);

/// Returns the length over which both plates are fused along the line where they meet, from the joint's corner inwards
/// (-x), in cells; 0 for a corner that is not fused. The colder plate decides; between the outermost cells' centres and
/// the corner the temperature goes on with its slope.
double rootFusion(const SectionSlice& slice, glm::ivec2 corner, double level);

/// Returns the fused stretches of both faces of a joint's corner: base plate and upright plate, in cells along each
/// from the corner outwards. Both ends are 0 for a face that is fused nowhere.
std::array<glm::dvec2, 2> fusedFaces(const SectionSlice& slice, glm::ivec2 corner, double level);

/// Returns true if the plates at a joint's corner meet in a line only, as in an outside corner: behind that line is
/// air.
bool isOpenCorner(const SectionSlice& slice, glm::ivec2 corner);

/// Returns the stretch of the uppermost faces around the hottest place that is fused at the faces themselves, in cells
/// from the grid's corner; nothing if no face is fused.
std::optional<glm::dvec2> fusedTop(const SectionSlice& slice, double level);

/// Returns the unfused height of the edge next to a seam from its lowest cell upwards, in cells: all of it if no cell
/// is hot, 0 if the lowest cell's centre is. The edge is in each row the cell nearest to the seam, which is between the
/// columns `seam` - 1 and `seam`; `side` is -1 for the columns below `seam` and 1 for the others. Nothing if there was
/// no metal on that side.
std::optional<double> unfusedEdge(const SectionSlice& slice, int seam, int side, double level);

} // namespace meltpool
