// The table of a weld's figures and imperfections: key, unit, digits, standard and measure of each. Files, verdict,
// result panel, page, comparison and drawn section read it; a new figure is a row of weld_figures.cpp, a new
// imperfection one of weld_imperfections.cpp. Their words stand under their keys in data/words.
#pragma once

#include "core/weld/gauge/weld_stations.hpp"

namespace meltpool {

/// The weld that was asked for. Lengths in m.
struct NominalWeld {
    double thickness = 0; ///< t, of the thinner plate
    /// a, nominal throat, and the nominal leg of a fillet. One of them is enough: a = leg / sqrt(2). A butt's throat is
    /// its plates' thickness where none is given.
    std::optional<double> throat, leg;
    double platesOffset = 0; ///< of a butt's plates against each other, as the workpiece was set up
    double jointGap = 0;     ///< under a fillet, as the workpiece was set up

    std::optional<double> throatOf(WeldKind kind) const;
    std::optional<double> legOf() const;
};

/// An imperfection at a station.
struct ImperfectionValue {
    double value = 0; ///< in the imperfection's unit; may be negative where the weld is on the safe side
    double width = 0; ///< b, mm: of the reinforcement, the fillet's face or the root that the limit may grow with
};

/// An imperfection of the whole weld, at the place where it was measured.
struct PlacedImperfection {
    ImperfectionValue found;
    double place = 0; ///< m along the seam
};

/// An imperfection in ISO 6520-1:2007; both empty where that standard has none or its number is not certain.
struct StandardTerm {
    std::string_view number = {}; ///< "506"; several with commas
    std::string_view name = {};
};

/// How a figure of two attempts is compared; see ComparedFigure.
struct FigureScale {
    double much = 0;  ///< in the figure's unit: differences of this size weigh alike; 0: the figure is not compared
    double least = 0; ///< in the figure's unit: a smaller difference is none
    bool onlyOver = false; ///< values below 0 say how far away the fault is and count as 0
    bool isSize = false;   ///< a size by which every weld is known: its curve is always drawn
};

/// A row of the table.
struct WeldFigure {
    /// A column of weld.csv and entry of `weld` in result.json ("toe_width_mm"), or an imperfection in acceptance files
    /// and results ("undercut").
    std::string_view key;
    std::string_view unit; ///< "mm", "mm2", "deg", "%", "s"; empty of a count
    int digits = 1;        ///< behind the decimal point, in panel and comparison
    /// What the particles resolve, in spacings; of an area in mm2 per mm of spacing. 0: nothing limits it, or the
    /// workpiece or the metal itself answers. Angles: see resolvedOf().
    double resolution = 0;
    std::string_view table = "figure."; ///< of data/words, in which its words stand under its key
    FigureScale scale = {};
    WeldStation::Value WeldStation::*member = nullptr;    ///< of a station's figure
    std::optional<double> WeldMeasures::*whole = nullptr; ///< of a figure of the whole weld
    StandardTerm standard = {};                           ///< of an imperfection
    /// The imperfection at a station, lengths in mm, angles in degrees; nothing where the station does not tell it.
    /// Null for an imperfection of the whole weld or one that the metal does not contain, and for a figure that is
    /// none.
    std::optional<ImperfectionValue> (*judged)(const WeldStation&, const NominalWeld&, WeldKind) = nullptr;
    /// An imperfection that the weld has once, such as at its end; units as `judged`, which is null beside it. Nothing
    /// where the measures do not tell it.
    std::optional<PlacedImperfection> (*judgedWhole)(const WeldMeasures&, const NominalWeld&) = nullptr;
    /// Key of the imperfection whose estimate from technique answers for it: all pores share one. Empty: not estimated.
    std::string_view estimate = {};

    bool isMeasured() const { return judged || judgedWhole; } ///< of an imperfection: the metal tells it
    double inSi() const;                                      ///< the unit in SI: 1e-3 of "mm", 1 of "s"
    std::string_view name() const { return wordsOf("name"); } ///< in sentences and lists, such as "penetration"
    std::string_view panelWords() const;                      ///< in the result panel
    std::string_view pageWords() const;                       ///< in the table of the HTML page
    /// Beside its measure in a drawn section; empty of a figure that is not drawn.
    std::string_view drawnWords() const { return wordsOf("drawn"); }

  private:
    /// For a place where they are shown; empty where the words file has none for it.
    std::string_view wordsOf(std::string_view place) const;
};

/// The row of a key; null for an unknown one.
const WeldFigure* findByKey(std::span<const WeldFigure> rows, std::string_view key);

/// The figures of a station, in the order of weld.csv's columns.
std::span<const WeldFigure> stationFigures();
/// Null for an unknown key.
const WeldFigure* findStationFigure(std::string_view key);
/// The row of a member of WeldStation. Throws std::out_of_range for a member that the table lacks.
const WeldFigure& stationFigure(WeldStation::Value WeldStation::*member);

/// The entries of `weld` in result.json that are no means over stations. Only the straightness has a member: the others
/// say how the weld was cut and measured.
std::span<const WeldFigure> wholeWeldFigures();

/// The imperfections of acceptance files: lengths of what is missing or too much in mm, the toe angle in degrees
/// outside the weld metal between plate and weld surface (ISO 5817: 180 less the edge angle).
std::span<const WeldFigure> imperfections();
/// Null for an unknown key.
const WeldFigure* findImperfection(std::string_view key);
/// The name of an imperfection; of a key that the table lacks, as a newer program may have written it, the key with
/// blanks.
std::string imperfectionName(std::string_view key);

/// Half a spacing: what the gauge resolves of a length.
inline constexpr double kResolvedSpacings = 0.5;

/// Degrees of a toe angle that particles resolve: five layers of them scatter by as much about the angle of the surface
/// that they form (tests/weld/gauge/weld_shape_test.cpp, disordered particles).
inline constexpr double kResolvedAngle = 15;

/// What particles with this spacing (m) resolve of a figure, in its unit.
double resolvedOf(const WeldFigure& figure, double spacing);

} // namespace meltpool
