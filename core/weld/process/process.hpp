// What the torch does to the metal: the heat it puts in and the filler it feeds, for each welding process.
#pragma once

#include "core/base/parameter.hpp"
#include "core/metal/flow/flow.hpp"
#include "core/metal/heat/heat.hpp"
#include "core/weld/process/filler.hpp"
#include "core/weld/torch/torch_sample.hpp"

#include <span>

namespace meltpool {

enum class ProcessKind { Flame, Tig, Gmaw, Iron };

/// Settings of the machine, as a welder names them.
struct ProcessParameters {
    int kind = 1;                  ///< ProcessKind
    float voltage = 11;            ///< V, arcs
    float current = 130;           ///< A, arcs
    float efficiency = 0.6F;       ///< share of V I that reaches the metal: TIG 0.6, GMAW 0.8
    float flamePower = 1500;       ///< W into the metal, flame
    float sigmaMm = 2;             ///< spread of the heat on the surface
    float wireDiameterMm = 0.9F;   ///< GMAW
    float wireFeedMPerMin = 5.8F;  ///< GMAW
    float dropTemperatureC = 2200; ///< at which wire arrives in the pool
    float dropSpeed = 0.3F;        ///< m/s
    float tipTemperatureC = 380;   ///< soldering iron
    float tipRadiusMm = 2;         ///< soldering iron
    float arcLengthMm = 3;         ///< that the machine's settings want, arcs
};

ParameterList describe(ProcessParameters& parameters);

/// Heat input of an arc: efficiency V I, W; of a flame its power.
double processPower(const ProcessParameters& parameters);

/// Volume of wire per second, m³/s; 0 for processes without.
double wireRate(const ProcessParameters& parameters);

class WeldProcess {
  public:
    WeldProcess(const HeatTable& table, double density, float spacing, float ambient);

    /// Live settings.
    ProcessParameters parameters;

    /// The heat sources under this torch; none with the trigger released. An arc's power less what melts the wire goes
    /// into the surface, so that source and filler together bring efficiency V I. Stays until the next call.
    std::span<const HeatSource> sources(const TorchSample& torch);

    /// How an arc presses on the metal under this torch, by its current (see arcPressurePeak()) and as wide as its
    /// heat; peak 0 without an arc. The current follows the trigger.
    ArcPressure pressure(const TorchSample& torch) const;

    /// The filler that `seconds` of this torch bring, as particles to add. Exact over time.
    std::span<const MetalSeed> feed(const TorchSample& torch, double seconds);

    const Filler& filler() const { return filler_; }
    void reset() { filler_.reset(); }

  private:
    double wirePower() const;

    const HeatTable& table_;
    double density_;
    float ambient_;
    HeatSource source_;
    Filler filler_;
};

} // namespace meltpool
