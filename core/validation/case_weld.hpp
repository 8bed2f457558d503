// A weld of a case in progress: the common part of beads, fillets, spots and cooling.
#pragma once

#include "core/base/function_ref.hpp"
#include "core/validation/arc_landing.hpp"
#include "core/validation/torch_run.hpp"
#include "core/validation/validation.hpp"
#include "core/weld/gauge/weld_stations.hpp"

#include <algorithm>

namespace meltpool {

/// Throws InputError if this machine cannot hold a workpiece of `volume` (m³) and the wire of `seconds`.
void requireWeldRoom(const ValidationCase& from, const ProcessSettings& settings, double volume, double seconds);

class CaseWeld {
  public:
    /// Makes the case's metal as this workpiece at its own temperature, in air of `ambient` (K), with room for the wire
    /// of `seconds` of arc.
    CaseWeld(const ValidationCase& from, gl::ShaderLibrary& shaders, const ProcessSettings& settings, Workpiece piece,
             double ambient, double seconds);

    /// Welds along the path until `watch`, which is called after each step with its end (s), returns false. Counts
    /// steps and particles in the result.
    void run(const TorchPath& path, FunctionRef<bool(double)> watch, ValidationResult& result);
    /// Welds along the path until a time (s), and counts likewise.
    void run(const TorchPath& path, double until, ValidationResult& result);

    const Weld& weld() const { return weld_; }
    bool fed() const { return fed_; }

    /// Returns the section from `low` to `high` (m along the seam).
    Section section(double low, double high) const;

    /// Reads every particle; waits for the GPU.
    ParticleValues particles() const;
    /// Returns the measures of the whole weld at these stations.
    WeldMeasures measure(WeldKind kind, const StationSettings& stations) const;

    /// Means (A, V) over the time in which the arc burned; 0 if it never did.
    double meanCurrent() const { return arc_.current / std::max(arc_.burning, kNoTime); }
    double meanVoltage() const { return arc_.voltage / std::max(arc_.burning, kNoTime); }

    /// Adds the arc's means and refused filler to the result.
    void tellArc(const ValidationCase& from, ValidationResult& result) const;

    /// Throws InputError when the arc burned for less than half of the time: called last, so that the numbers stay in
    /// the result.
    void requireArc(const ValidationCase& from) const;

    /// Compares, for a process with wire, the deposit in the whole workpiece with the melted wire, both over `length`
    /// (m), within 3 %, as `deposited_mm2`. A bead is thin at its beginning and humps after it, so no short stretch has
    /// the mean.
    void compareDeposit(const ValidationCase& from, double length, ValidationResult& result) const;

  private:
    static constexpr double kNoTime = 1e-9; ///< s, instead of none

    void addMeans();

    Workpiece piece_;
    Material material_;
    Weld weld_;
    double seconds_;     ///< s of arc, on the whole path
    double elapsed_ = 0; ///< s
    bool fed_;
    struct {
        double current = 0, voltage = 0, length = 0, burning = 0; ///< integrals over the time in which the arc burned
    } arc_;
};

} // namespace meltpool
