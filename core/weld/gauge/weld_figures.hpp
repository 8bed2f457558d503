// The table of a weld's figures and imperfections: key, unit, digits, standard and measure of each. Files, verdict,
// result panel, page, comparison and drawn section read it; a new figure is a row of weld_figures.cpp, a new
// imperfection one of weld_imperfections.cpp. Their words are in data/words under their keys.
#pragma once

#include "core/weld/gauge/weld_stations.hpp"

namespace meltpool {

/// Nominal sizes of the weld. Lengths in m.
struct NominalWeld {
    double thickness = 0; ///< t, thickness of the thinner plate
    /// a, nominal throat, and the nominal leg of a fillet. One of them is enough: a = leg / sqrt(2). A butt's throat
    /// defaults to its plates' thickness.
    std::optional<double> throat, leg;
    double linearMisalignment = 0; ///< offset of a butt's plates against each other, as the workpiece was set up
    double jointGap = 0;           ///< gap under a fillet, as the workpiece was set up
    bool betweenEdges = false;     ///< the weld fills the groove of an outside corner, whose legs end with the edges

    std::optional<double> throatOf(WeldKind kind) const;
    std::optional<double> legOf() const;
};

/// An imperfection at a station.
struct ImperfectionValue {
    double value = 0; ///< size in the imperfection's unit; may be negative if the weld is on the safe side
    double width = 0; ///< b, mm: width of the reinforcement, the fillet's face or the root that the limit may grow with
    /// Another figure of the station rules the imperfection out, whatever `value` is.
    bool ruledOut = false;
};

/// An imperfection of the whole weld, at the place where it was measured.
struct PlacedImperfection {
    ImperfectionValue found;
    double place = 0; ///< m along the seam
};

/// The term of an imperfection in ISO 6520-1:2007; both members are empty if that standard has none or its number is
/// not certain.
struct StandardTerm {
    std::string_view number = {}; ///< number such as "506"; several with commas
    std::string_view name = {};
};

/// Scale on which a figure of two attempts is compared; see ComparedFigure.
struct FigureScale {
    /// difference in the figure's unit: differences of this size have equal weight; 0: the figure is not compared
    double much = 0;
    double least = 0;      ///< difference in the figure's unit: a smaller one counts as none
    bool onlyOver = false; ///< negative values mean "no fault" (their size is the distance from it) and compare as 0
    bool isSize = false;   ///< a main size of a weld: its curve is always drawn
};

/// A row of the table.
struct WeldFigure {
    /// A column of weld.csv and entry of `weld` in result.json ("toe_width_mm"), or an imperfection in acceptance files
    /// and results ("undercut").
    std::string_view key;
    std::string_view formerKey = {}; ///< key of an imperfection in files of earlier versions; empty: it had no other
    std::string_view unit; ///< "mm", "mm2", "deg", "%", "s"; empty for a count
    int digits = 1;        ///< digits behind the decimal point, in panel and comparison
    /// Resolution of the particles, in spacings; of an area in mm2 per mm of spacing. Of an imperfection: of one
    /// station alone. 0: nothing limits it, or the workpiece or the metal itself decides. Angles: see resolvedOf().
    double resolution = 0;
    /// Of an imperfection: the gauge's own error, in spacings, which a mean over many stations keeps.
    double gaugeError = 0;
    std::string_view table = "figure."; ///< table of data/words that has its words under its key
    FigureScale scale = {};
    WeldStation::Value WeldStation::*member = nullptr;    ///< member of a station's figure
    std::optional<double> WeldMeasures::*whole = nullptr; ///< member of a figure of the whole weld
    StandardTerm standard = {};                           ///< term of an imperfection
    /// Returns the imperfection at a station, lengths in mm, angles in degrees; nothing if the station does not have
    /// it. Null for an imperfection of the whole weld or one that the metal does not contain, and for a figure that is
    /// none.
    std::optional<ImperfectionValue> (*judged)(const WeldStation&, const NominalWeld&, WeldKind) = nullptr;
    /// As `judged`, of the weld's other side, if `judged` is of one side; null if it is of the whole station.
    std::optional<ImperfectionValue> (*judgedOther)(const WeldStation&, const NominalWeld&, WeldKind) = nullptr;
    /// True for a size, which drawings ask for along the seam: its mean over the weld decides.
    bool meanDecides = false;
    /// Returns an imperfection that the weld has once, such as at its end; units as `judged`, which is then null.
    /// Nothing if the measures do not have it.
    std::optional<PlacedImperfection> (*judgedWhole)(const WeldMeasures&, const NominalWeld&) = nullptr;
    /// Key of the imperfection whose estimate from technique is used for this one: all pores share one. Empty: not
    /// estimated.
    std::string_view estimate = {};

    /// True for an imperfection that is measured on the metal.
    bool isMeasured() const { return judged || judgedWhole; }
    double inSi() const;                                      ///< factor from the unit to SI: 1e-3 of "mm", 1 of "s"
    std::string_view name() const { return wordsOf("name"); } ///< name in sentences and lists, such as "penetration"
    std::string_view panelWords() const;                      ///< words in the result panel
    std::string_view pageWords() const;                       ///< words in the table of the HTML page
    /// Words next to its measure in a drawn section; empty for a figure that is not drawn.
    std::string_view drawnWords() const { return wordsOf("drawn"); }
    /// Sentence on how an imperfection is measured, where its name alone misleads; empty for most.
    std::string_view note() const { return wordsOf("note"); }

  private:
    /// Words for a place that shows them; empty if the words file has none for it.
    std::string_view wordsOf(std::string_view place) const;
};

/// Returns the row of a key; null for an unknown one.
const WeldFigure* findByKey(std::span<const WeldFigure> rows, std::string_view key);

/// Returns the figures of a station, in the order of weld.csv's columns.
std::span<const WeldFigure> stationFigures();
/// Returns null for an unknown key.
const WeldFigure* findStationFigure(std::string_view key);
/// Returns the row of a member of WeldStation. Throws std::out_of_range for a member that the table lacks.
const WeldFigure& stationFigure(WeldStation::Value WeldStation::*member);

/// Returns the entries of `weld` in result.json that are no means over stations. Only the straightness has a member:
/// the others say how the weld was cut and measured.
std::span<const WeldFigure> wholeWeldFigures();

/// Returns the imperfections of acceptance files: lengths of missing or excess metal in mm, the toe angle in degrees
/// outside the weld metal between plate and weld surface (ISO 5817: 180 less the edge angle).
std::span<const WeldFigure> imperfections();
/// Takes former keys, too. Returns null for an unknown key.
const WeldFigure* findImperfection(std::string_view key);
/// Returns the name of an imperfection; for a key that the table lacks, such as one of a newer program's file, the key
/// with blanks.
std::string imperfectionName(std::string_view key);

/// Half a spacing: the gauge's resolution of a length.
inline constexpr double kResolvedSpacings = 0.5;

/// Resolution of a toe angle, degrees: five layers of particles scatter by as much about the angle of the surface that
/// they form (tests/weld/gauge/weld_shape_test.cpp, disordered particles).
inline constexpr double kResolvedAngle = 15;

/// Error of a mean toe angle, degrees (same test: particles in order, three and more high).
inline constexpr double kGaugeAngle = 6;

/// Returns the resolution of a figure with particles of this spacing (m), in the figure's unit.
double resolvedOf(const WeldFigure& figure, double spacing);
/// Returns WeldFigure::gaugeError, or kGaugeAngle, with particles of this spacing (m), in the imperfection's unit.
double gaugeErrorOf(const WeldFigure& imperfection, double spacing);

} // namespace meltpool
