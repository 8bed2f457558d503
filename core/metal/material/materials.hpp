// A metal (or wax, or ice): its thermal, fluid and optical properties in SI, each with the source of its numbers.
#pragma once

#include <glm/vec3.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace meltpool {

/// A property over temperature, linear between its points and constant beyond them; one point is a constant.
struct Property {
    struct Point {
        double temperature; ///< K
        double value;
    };
    std::vector<Point> points; ///< points, at least one, temperatures rising
    std::string source;        ///< the source of the numbers; begins with "none" if it is unknown

    double at(double temperature) const;

    /// Integral over temperature from `from` to `to` (K); exact for the linear pieces.
    double integral(double from, double to) const;

    static Property constant(double value, std::string source = "given");
};

/// Per cent by mass up to which Material::tensionAt() was measured.
inline constexpr double kMostSulphur = 0.2;

/// Appearance of the material; the renderer interprets it. Colours are linear sRGB reflectances at normal incidence.
struct MaterialLooks {
    glm::vec3 solidColour{0.55F, 0.56F, 0.57F};
    glm::vec3 liquidColour{0.65F, 0.65F, 0.65F};
    float solidRoughness = 0.5F;   ///< 0 mirror .. 1 dull
    float liquidRoughness = 0.05F; ///< 0 mirror .. 1 dull, molten
    float metalness = 1.0F;        ///< 0 dielectric, 1 metal
    float heatTint = 0.0F; ///< strength of the oxide's interference colours on metal that was hot, 0 none .. 1 as steel
    /// Shares of a black body's light in the visible. Reflectance is 1 - emissivity.
    float liquidEmissivity = 0.3F;
    float cleanEmissivity = 0.45F;  ///< solid, bare
    float scaledEmissivity = 0.85F; ///< solid, under the scale that grows if heat_tint is above 0
    /// Ripples that freezing leaves. None: chosen; beads have ripples of 20 to 80 um.
    float rippleFrequency = 0;    ///< Hz; 0: the process sets them
    float rippleHeight = 25e-6F;  ///< m, of the first harmonic over its mean; 0: the metal freezes smooth
    float millScale = 0;          ///< share of its plates' rolled faces under mill scale
    float translucency = 0.0F;    ///< 0 opaque .. 1 clear
    float refractiveIndex = 1.0F; ///< index of translucent material
    std::string source;
};

/// One material. All values SI, temperatures in K.
struct Material {
    std::string key;  ///< file name without ".toml"
    std::string name; ///< displayed name

    double solidus = 0;    ///< melting begins
    double liquidus = 0;   ///< melting has ended; equal to solidus for pure material
    double latentHeat = 0; ///< J/kg over solidus to liquidus, on top of the specific heats
    std::string meltingSource;

    Property solidDensity, liquidDensity;           ///< kg/m³
    Property solidConductivity, liquidConductivity; ///< W/(m K)
    Property solidSpecificHeat, liquidSpecificHeat; ///< J/(kg K)
    Property viscosity;                             ///< Pa s, liquid
    Property expansion;                             ///< 1/K, of the liquid's volume: makes hot metal rise
    Property surfaceTension;                        ///< N/m, without sulphur
    double sulphur = 0;        ///< per cent by mass of steel; it lowers the surface tension, of cold liquid most
    std::string sulphurSource; ///< empty if the file has none
    Property emissivity;       ///< total hemispherical, for radiation losses

    double boilingPoint = 0;     ///< K at 1 bar; 0 if not given: no evaporation
    double vaporisationHeat = 0; ///< J/kg
    double molarMass = 0;        ///< kg/mol of the vapour
    double evaporatesFrom = 0;   ///< K, below which evaporation is left out; 0: half the boiling point
    std::string boilingSource;

    bool alternatingCurrent = false; ///< GTAW welds it with alternating current, which breaks its oxide
    std::string weldingSource;       ///< empty if the file has none

    MaterialLooks looks;

    /// Surface tension at a temperature (K), N/m: the table's, less R T G ln(1 + K a) for a per cent of sulphur, G =
    /// 1.3e-5 mol/m², K = 0.00318 exp(166 kJ/mol / (R T)). Sahoo, DebRoy and McNallan 1988, constants from a program
    /// that cites them.
    double tensionAt(double temperature) const;
    /// Slope of surface tension over temperature, N/(m K): drives the Marangoni flow.
    double tensionSlopeAt(double temperature) const;
};

/// Reads and checks a material file; throws InputError naming file and line.
Material readMaterial(const std::filesystem::path& file);

/// Files of all materials in a folder, by name.
std::vector<std::filesystem::path> materialFiles(const std::filesystem::path& folder);

/// The folder with the materials that ship. Throws InputError if the program's data is missing.
std::filesystem::path materialFolder();

/// The shipped material called `key`, ignoring case, blanks and dashes; throws InputError that lists the known ones.
Material shippedMaterial(const std::string& key);

} // namespace meltpool
