#include "core/metal/material/heat_table.hpp"

#include "shaders/shared/heat_table.h"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

/// Upper end of the samples (K); the liquid's part continues beyond it in a straight line.
constexpr double kHottestSample = 5000;

/// The temperature above `from` at which `area` is reached under the curve; exact for the property's straight pieces.
double temperatureForArea(const Property& property, double from, double area) {
    double left = from;
    for (const Property::Point& point : property.points) {
        if (point.temperature <= left) continue;
        const double whole = property.integral(left, point.temperature);
        if (whole >= area) {
            // Solves a x + b x²/2 = area without cancellation, from value(T) = a + b (T - left).
            const double a = property.at(left);
            const double b = (property.at(point.temperature) - a) / (point.temperature - left);
            return left + 2 * area / (a + std::sqrt(std::max(0.0, a * a + 2 * b * area)));
        }
        area -= whole;
        left = point.temperature;
    }
    return left + area / property.at(left);
}

} // namespace

HeatTable::HeatTable(const Material& material, double liquidConductivityFactor)
    : solidSpecificHeat_(material.solidSpecificHeat),
      liquidSpecificHeat_(material.liquidSpecificHeat),
      solidConductivity_(material.solidConductivity),
      liquidConductivity_(material.liquidConductivity),
      solidus_(material.solidus),
      liquidus_(material.liquidus),
      conductivityFactor_(liquidConductivityFactor) {
    const double range = liquidus_ - solidus_;
    solidusEnthalpy_ = solidSpecificHeat_.integral(0, solidus_);
    const double mean = 0.5 * (solidSpecificHeat_.at(solidus_) + liquidSpecificHeat_.at(liquidus_));
    liquidusEnthalpy_ = solidusEnthalpy_ + mean * range + material.latentHeat;
    solidusKirchhoff_ = solidConductivity_.integral(0, solidus_);
    liquidusKirchhoff_ =
        solidusKirchhoff_ +
        0.5 * range * (solidConductivity_.at(solidus_) + conductivityFactor_ * liquidConductivity_.at(liquidus_));
    const double hottest = std::max(kHottestSample, 2 * liquidus_);
    pieces_[0] = makePiece(0, solidusEnthalpy_);
    pieces_[1] = makePiece(solidusEnthalpy_, liquidusEnthalpy_);
    pieces_[2] = makePiece(liquidusEnthalpy_, enthalpyAt(hottest));
}

double HeatTable::enthalpyAt(double temperature) const {
    if (temperature <= solidus_) return solidSpecificHeat_.integral(0, temperature);
    if (temperature >= liquidus_) return liquidusEnthalpy_ + liquidSpecificHeat_.integral(liquidus_, temperature);
    const double fraction = (temperature - solidus_) / (liquidus_ - solidus_);
    return solidusEnthalpy_ + fraction * (liquidusEnthalpy_ - solidusEnthalpy_);
}

double HeatTable::liquidFractionAt(double enthalpy) const {
    if (enthalpy <= solidusEnthalpy_) return 0;
    if (enthalpy >= liquidusEnthalpy_) return 1;
    return (enthalpy - solidusEnthalpy_) / (liquidusEnthalpy_ - solidusEnthalpy_);
}

double HeatTable::temperatureAt(double enthalpy) const {
    if (enthalpy <= solidusEnthalpy_) return temperatureForArea(solidSpecificHeat_, 0, enthalpy);
    if (enthalpy < liquidusEnthalpy_) return solidus_ + liquidFractionAt(enthalpy) * (liquidus_ - solidus_);
    return temperatureForArea(liquidSpecificHeat_, liquidus_, enthalpy - liquidusEnthalpy_);
}

double HeatTable::kirchhoffAt(double enthalpy) const {
    const double temperature = temperatureAt(enthalpy);
    if (enthalpy <= solidusEnthalpy_) return solidConductivity_.integral(0, temperature);
    if (enthalpy >= liquidusEnthalpy_)
        return liquidusKirchhoff_ + conductivityFactor_ * liquidConductivity_.integral(liquidus_, temperature);
    const double f = liquidFractionAt(enthalpy);
    const double ks = solidConductivity_.at(solidus_);
    const double kl = conductivityFactor_ * liquidConductivity_.at(liquidus_);
    return solidusKirchhoff_ + (liquidus_ - solidus_) * (ks * f + 0.5 * (kl - ks) * f * f);
}

double HeatTable::largestDiffusivity(double density, double lowest, double highest) const {
    constexpr int kSamples = 200;
    double largest = 0;
    for (int i = 0; i <= kSamples; ++i) {
        const double t = lowest + (highest - lowest) * i / kSamples;
        const bool solid = t < liquidus_;
        const double k = solid ? solidConductivity_.at(t) : conductivityFactor_ * liquidConductivity_.at(t);
        const double c = solid ? solidSpecificHeat_.at(t) : liquidSpecificHeat_.at(t);
        largest = std::max(largest, k / (density * c));
    }
    return largest;
}

HeatTable::Piece HeatTable::makePiece(double from, double to) const {
    Piece piece;
    piece.start = static_cast<float>(from);
    piece.inverseStep = to > from ? static_cast<float>(HEAT_TABLE_STEPS / (to - from)) : 0.0F;
    for (int i = 0; i < HEAT_TABLE_ROW; ++i) {
        const double enthalpy = from + (to - from) * i / HEAT_TABLE_STEPS;
        // The ends belong to the neighbours too: the first sample of the liquid is the liquid's, the last of the solid
        // its own.
        const double inside = std::clamp(enthalpy, from, to);
        piece.samples.push_back({static_cast<float>(temperatureAt(inside)), static_cast<float>(kirchhoffAt(inside))});
    }
    return piece;
}

std::array<float, 2> HeatTable::sampled(float enthalpy) const {
    const Piece& piece = enthalpy < pieces_[1].start   ? pieces_[0]
                         : enthalpy < pieces_[2].start ? pieces_[1]
                                                       : pieces_[2];
    const float place = (enthalpy - piece.start) * piece.inverseStep;
    const auto index = static_cast<std::size_t>(std::clamp(place, 0.0F, static_cast<float>(HEAT_TABLE_STEPS - 1)));
    const float share = place - static_cast<float>(index);
    const auto& a = piece.samples[index];
    const auto& b = piece.samples[index + 1];
    return {a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])};
}

} // namespace meltpool
