// Enthalpy, temperature and Kirchhoff variable of one material, exact on the CPU and sampled for the shaders.
#pragma once

#include "core/metal/material/materials.hpp"

#include <array>
#include <vector>

namespace meltpool {

/// Converts between temperature T (K), specific enthalpy H (J/kg, 0 at 0 K in the solid) and Kirchhoff variable theta,
/// the integral of the conductivity over T from 0 K (W/m). Between solidus and liquidus T rises linearly with the
/// liquid fraction f, and so does the conductivity:
///     Hs = integral of cs up to Ts;  Hl = Hs + (cs(Ts) + cl(Tl))/2 (Tl - Ts) + L;  f = (H - Hs)/(Hl - Hs).
class HeatTable {
  public:
    /// `liquidConductivityFactor` multiplies the liquid's conductivity: a substitute for stirring if no flow is
    /// computed.
    explicit HeatTable(const Material& material, double liquidConductivityFactor = 1);

    double enthalpyAt(double temperature) const; ///< at a sharp melting point: that of the solid
    double temperatureAt(double enthalpy) const;
    double kirchhoffAt(double enthalpy) const;
    double liquidFractionAt(double enthalpy) const; ///< 0 .. 1

    double solidusEnthalpy() const { return solidusEnthalpy_; }
    double liquidusEnthalpy() const { return liquidusEnthalpy_; }

    /// Largest k/(rho c) with the density of the masses (m²/s): it limits the explicit step.
    double largestDiffusivity(double density, double lowest, double highest) const;

    /// One row for the shaders: value at enthalpy start + i step is (temperature, theta), i = 0 .. HEAT_TABLE_STEPS.
    struct Piece {
        float start = 0;       ///< J/kg
        float inverseStep = 0; ///< kg/J; 0 for a piece without extent
        std::vector<std::array<float, 2>> samples;
    };
    const std::array<Piece, 3>& pieces() const { return pieces_; }

    /// The shader's look-up, in float: (temperature, theta).
    std::array<float, 2> sampled(float enthalpy) const;

  private:
    Piece makePiece(double from, double to) const;

    Property solidSpecificHeat_, liquidSpecificHeat_, solidConductivity_, liquidConductivity_;
    double solidus_, liquidus_, conductivityFactor_;
    double solidusEnthalpy_ = 0, liquidusEnthalpy_ = 0;
    double solidusKirchhoff_ = 0, liquidusKirchhoff_ = 0;
    std::array<Piece, 3> pieces_;
};

} // namespace meltpool
