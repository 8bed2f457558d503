// The finished weld in figures: sections at stations along the seam, all measured by one gauge.
#pragma once

#include "core/weld/gauge/weld_section.hpp"
#include "core/weld/workpiece/workpiece.hpp"

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>

namespace meltpool {

/// Kinds of weld that acceptance limits distinguish: a weld in a corner, one between two edges, a bead on a plate.
enum class WeldKind { fillet, butt, bead };

/// Returns the kind of a workpiece's weld; of a pipe a butt if a gap or a bevel parts it, else a bead.
WeldKind weldKindOf(const WorkpieceParameters& workpiece);
/// Returns "fillet", "butt" or "bead".
std::string_view nameOf(WeldKind kind);

/// Places of the stations.
struct StationSettings {
    double pitch = 2e-3; ///< m from station to station
    /// Number of particle layers that a station is the mean of at least, so that no single one decides.
    int layers = 5;
    double ends = 5e-3; ///< m left out at the start and at the end crater, at most a quarter of the seam each
    /// m along the seam: the stretch to be welded, so that a place without weld counts. None: the stretch that was
    /// welded.
    std::optional<FaceStretch> seam;
    /// m along the seam: the stretch that the torch passed. Only this part of the seam is measured: beyond it nothing
    /// was to be expected. None: all of the seam.
    std::optional<FaceStretch> passed;
    std::optional<double> stop; ///< m along the seam: the last place of the torch, whose crater is measured

    /// m of seam that a station is measured over with particles of this spacing (m): neighbours may share metal.
    double cutLength(double spacing) const { return std::max(pitch, layers * spacing); }
};

/// Figures of one station in SI units, or a figure of many stations under these names. Each member has its value and
/// its row in weld_figures.cpp. Side 1 is that of -z on a level workpiece and the base plate in a corner; side 2 is
/// that of +z, or the upright plate. None: does not apply to this weld, or is unknown here. The sizes of a section
/// without weld are 0.
struct WeldStation {
    using Value = std::optional<double>;

    double place = 0;  ///< m along the seam, middle of the cut
    /// m from toe to toe: of a fillet the width of its face. None for a bead too low for toes; 0 without weld.
    Value toeWidth;
    Value fusedWidth;  ///< m, WeldZone::width
    Value height;      ///< m, height of a bead over the face
    Value leg1, leg2;  ///< leg lengths, m
    Value throat;      ///< m
    Value convexity;   ///< m, FilletShape::convexity
    Value penetration; ///< m, WeldZone::depth
    /// Share of the cut's layers in which the root is fused, 0 to 1; only for fillets and butts.
    Value rootFused;
    Value rootFusion; ///< m, Section::rootFusion
    /// Share of the cut's layers in which both plates are fused under the weld, 0 to 1; for a bead 1 if its plate is.
    Value facesFused;
    /// m of face under the weld that is not fused: of a fillet from the corner outwards on the worse plate; of a butt
    /// the height on the worse edge; of a bead all of its width or nothing. Negative: the length by which the root
    /// fusion goes beyond (fillet: into the joint, butt: metal under the lower face, bead: into the plate).
    Value lackOfFusion;
    /// m of a butt's height that neither edge is fused on; negative: the height of the metal under the lower face.
    Value rootMissing;
    Value edgeAngle1, edgeAngle2; ///< rad, WeldToe::angle, inside the weld metal
    /// m of weld on cold plate at a toe; negative: the fused length beyond the toe, so that means show the margin.
    Value overlap1, overlap2;
    Value undercut1, undercut2; ///< m, Section::undercut
    Value underfill;            ///< m, Section::underfill; of butts and beads
    Value excessPenetration;    ///< m, height of the metal under the lower face
    Value rootWidth;            ///< m, its breadth from toe to toe
    Value rootConcavity;        ///< m, Section::rootConcavity; of butts
    Value hole;                 ///< m, Section::hole: burn-through, or a gap that stayed open
    Value deposited;            ///< m², Section::deposited
    /// m across the seam: of a bead its middle between the toes; of a fillet its face's middle, along the line that
    /// halves the outer angle, positive on the base plate.
    Value middle;
    /// m on one side: half the difference between the widths of the heat-affected and the fused zone.
    Value hazWidth;
    Value coolingTime; ///< s, Section::coolingTime (t8/5)
};

/// A whole weld.
struct WeldMeasures {
    WeldKind kind = WeldKind::bead;
    double pitch = 0;   ///< m, length of seam of one station
    double spacing = 0; ///< m, spacing of the particles
    double cut = 0;     ///< m, StationSettings::cutLength()
    std::vector<WeldStation> stations;
    WeldStation mean, least, greatest; ///< figures over the stations that have them
    /// m, root mean square distance of the stations' `middle` from the straight line that fits them best. None for
    /// fewer than three of them.
    std::optional<double> straightness;
    /// m, depth of the pit in which the weld ends: its lowest place near the stop under the lower one of the places
    /// before and behind it, as throat or height over the plate. None where the place of the stop is not known.
    std::optional<double> craterDepth;
    /// m, throat or height over the plate (negative under it) where the torch stopped, or at the end of the seam if it
    /// ran on beyond. None as above.
    std::optional<double> craterSurface;
    double stop = 0;  ///< m along the seam, place of the crater
    double asked = 0; ///< m of seam that were to be welded; 0: not said

    double length() const { return pitch * static_cast<double>(stations.size()); } ///< m, length of the judged seam
    /// False if the judged seam is shorter than asked for by more than a station's cut: the pool reaches about as far
    /// beyond the torch.
    bool isComplete() const { return asked - length() <= cut + pitch; }
};

/// Returns one station's figures from its section; none for a section outside the workpiece. `place`: m along the seam.
WeldStation stationOf(const Section& section, WeldKind kind, double place);

/// Returns the places of the stations' cuts on a seam, each a pitch long or `layers` times the spacing (m) of the
/// particles; none on a seam shorter than one pitch.
std::vector<SectionCut> stationCuts(const Material& material, const FaceStretch& seam, double spacing,
                                    const StationSettings& settings);

/// Returns means, extremes and straightness of these stations. They are taken to be cut as StationSettings does by
/// itself.
WeldMeasures summarise(std::vector<WeldStation> stations, WeldKind kind, double pitch, double spacing);

/// Measures the weld on a workpiece of this kind of seam along x; without stations if nothing was welded. Reads every
/// particle once and waits for the GPU: at the end of an attempt, not in a frame.
WeldMeasures measureWeld(const MetalState& state, std::span<const MetalSeed> original, const Material& material,
                         WeldKind kind, const StationSettings& settings = {});

/// Measures the weld in metal that is read already, such as a rolled-out pipe, whose places along the seam begin at its
/// top.
WeldMeasures measureWeld(const WeldParticles& particles, const Material& material, WeldKind kind,
                         const StationSettings& settings = {});

/// Returns weld.csv: a head, then one row a station: `place_mm` and stationFigures(). A cell is empty if the station
/// has no such figure.
std::string weldTable(const WeldMeasures& measures);
/// Writes weldTable(). Throws as writeTextFileAtomically().
void writeWeldTable(const std::filesystem::path& file, const WeldMeasures& measures);

} // namespace meltpool
