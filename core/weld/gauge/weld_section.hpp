// The macro-section of a weld: a cut across the seam, ground and etched. Results, validation and pictures all take it
// from here.
#pragma once

#include "core/metal/material/materials.hpp"
#include "core/metal/state/metal_state.hpp"
#include "core/weld/gauge/section_map.hpp"
#include "core/weld/gauge/weld_particles.hpp"
#include "core/weld/gauge/weld_shape.hpp"

#include <array>
#include <optional>
#include <span>

namespace meltpool {

/// Temperature above which steel changes its grain, K (A1, 723 °C).
inline constexpr double kSteelTransformation = 996.15;

/// Default length along the seam that a section is the mean of, m: several particles, so that no single one decides.
inline constexpr double kSectionLength = 5e-3;

/// Place of a cut, and the temperatures that count as hot.
struct SectionCut {
    double from = 0, to = 0;            ///< m along the seam; the cut takes the whole lattice layers nearest to these
    double fusion = 0;                  ///< K: hotter metal has been molten
    std::optional<double> heatAffected; ///< K: hotter metal has changed; only of steel that melts above that

    double at() const { return 0.5 * (from + to); }
};

/// Returns the cut from `from` to `to` (m) through a weld of this material: fusion midway between solidus and liquidus.
SectionCut sectionCut(const Material& material, double from, double to);

/// The box around a zone in the section and its area, with the deposited metal. Heights are from the workpiece's
/// origin (see WorkpieceParameters).
struct SectionBox {
    double width = 0;  ///< m across the seam, of the workpiece's own metal
    double height = 0; ///< m, highest place of the zone or the deposit above the origin, at least 0
    double depth = 0;  ///< m, lowest place of the zone below the origin, at least 0
    double area = 0;   ///< m², of the zone in the workpiece's own metal and of the deposit
};

/// A part of the workpiece that was hot.
struct WeldZone {
    /// m, width of the workpiece's surface in the zone. In a plate or a butt joint its breadth from toe to toe, half a
    /// lattice cell below the surface; in the corner of a tee or a lap joint the stretches on both plates together,
    /// measured along them.
    double width = 0;
    /// The stretch of that surface, m from the seam (z). Only for one surface of one level.
    std::optional<FaceStretch> stretch;
    double depth = 0; ///< m, greatest distance from the workpiece's own surface: of the fused zone the penetration
    double area = 0;  ///< m², of the workpiece's own metal
    SectionBox box;
};

/// Figures of a section, each a mean over its layers.
struct Section {
    int layers = 0; ///< lattice layers that held metal at the start; 0: the cut meets no workpiece and nothing applies
    WeldZone fusion;
    std::optional<WeldZone> heatAffected; ///< only if the cut asks for it
    /// Only if the workpiece's surface is one level all across the cut, as of a plate, a butt joint, a cube or a
    /// bridge; the edges of a butt joint may be bevelled. Places are m from the seam (z).
    std::optional<BeadShape> bead;
    std::optional<FilletShape> fillet; ///< only of a tee, a lap joint and an outside corner with weld metal in them
    /// m, height of the upright plate over the corner where the weld covers all of it, as it covers the edge of a lap
    /// joint's upper plate: beyond is no face to measure a toe against.
    std::optional<double> coveredEdge;
    /// m along the line where the plates of a tee or a lap joint meet, from their corner inwards, over which both are
    /// fused.
    std::optional<double> rootFusion;
    double deposited = 0; ///< m², metal in the section beyond the workpiece's own; negative if metal ran away

    /// Share of the layers in which the root is fused, 0 to 1: in a corner both plates where they meet, of a workpiece
    /// of one level both edges at the seam down to the centres of their lowest cells.
    double rootFused = 0;
    /// Share of the layers in which both faces of such a joint, or both edges at the seam, are fused somewhere.
    double facesFused = 0;
    /// Fused stretches of the base plate's and the upright plate's face in a corner, m from the corner; of no length
    /// for a face that is not fused. Of an outside corner these are the plates' edge faces: the first one is that of
    /// the upright plate.
    std::optional<std::array<FaceStretch, 2>> fusedFaces;
    /// m from the seam (z): the stretch of a level workpiece's face that is fused at the face itself, a little wider
    /// than fusion.stretch half a cell below; metal over the face beyond it is weld metal on cold plate.
    std::optional<FaceStretch> fusedTop;
    /// m: unfused height of both edges at the seam (-z, +z) of a workpiece of one level, from the lower face upwards,
    /// bevels included. A plate's edges are the two columns of cells next to the seam.
    std::optional<std::array<double, 2>> unfusedEdges;
    /// m, depth of the grooves in the workpiece's faces beside the weld: on a level workpiece at its low and high end
    /// (z), in a corner on the base plate and on the upright plate. See undercutBeside().
    std::array<std::optional<double>, 2> undercut{0.0, 0.0};
    double underfill = 0; ///< m, of a level workpiece: greatest depth of the weld's surface under the upper face
    BeadShape root;       ///< the metal under the workpiece's lower face: its height is the excess penetration
    /// The workpiece is an outside corner: its plates meet in a line only, behind which there is air, so that `root`
    /// and `rootFusion` do not apply.
    bool openCorner = false;
    double rootConcavity = 0; ///< m, of a level workpiece: height of the weld's lower surface over the lower face
    /// m across the seam: widest place that has no metal at any height, between the workpiece's outermost parts, in any
    /// one layer; 0 below two spacings. A gap that stayed open is one too.
    double hole = 0;
    /// s, mean time of the metal that was molten from 800 to 500 °C. None while more than a twentieth of it is hotter,
    /// or if the cut asks for no heat-affected zone.
    std::optional<double> coolingTime;
};

/// The figures and the picture of one cut.
struct WeldSection {
    SectionCut cut;
    Section figures;
    SectionMap map;
};

/// Measures a section. `original`: the workpiece before welding; its seeds are on the state's lattice and were the
/// first that the state received, so that seed i is slot i. The faces that are welded on look up, or up and towards the
/// welder (+z) if the workpiece's upper surface is no single level; distances and widths count from these. Metal that
/// left its cell counts as molten there if it was, otherwise with the highest temperature it had. Throws RuntimeFault
/// when the state holds fewer particles than `original`.
///
/// Waits for the GPU and reads every particle: for the end of a lesson, for validation and when a person asks, never in
/// a frame that must not stall.
Section measureSection(const MetalState& state, std::span<const MetalSeed> original, const SectionCut& cut);

/// Measures a section and draws its picture; else as measureSection().
WeldSection cutWeld(const MetalState& state, std::span<const MetalSeed> original, const SectionCut& cut);

/// Measures several sections and reads the particles once; else as measureSection().
std::vector<Section> measureSections(const MetalState& state, std::span<const MetalSeed> original,
                                     std::span<const SectionCut> cuts);

/// Measures one of several cuts through metal that is read already.
Section measureSection(const WeldParticles& particles, const SectionCut& cut);

/// Returns the stretch of the seam (m along it) on which the workpiece was heated above `fusion` (K), between the
/// centres of the outermost cells; nothing if it was not.
std::optional<FaceStretch> weldedStretch(const WeldParticles& particles, double fusion);

/// Returns the default place of a cut: the middle (m along the seam) of the workpiece's metal that was heated above
/// `fusion` (K), or of the workpiece itself if none was. Waits for the GPU.
double middleOfWeld(const MetalState& state, std::span<const MetalSeed> original, double fusion);

} // namespace meltpool
