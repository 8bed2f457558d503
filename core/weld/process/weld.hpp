// A weld in progress: one process over one workpiece. Lessons and validation weld with this and nothing else.
#pragma once

#include "core/metal/axis_probe.hpp"
#include "core/metal/physical_metal.hpp"
#include "core/weld/process/processes.hpp"
#include "core/weld/workpiece/workpiece.hpp"

namespace meltpool {

/// Surroundings of the weld.
struct WeldSurroundings {
    double ambient = 293.15;                        ///< K, temperature of air, table and wire
    bool lossless = false;                          ///< no heat leaves the metal: for balances
    double convection = 15;                         ///< W/(m² K), still air over hot plate
    bool ledger = false;                            ///< books every joule, see HeatSettings
    size_t fillerRoom = PhysicalSetup().fillerRoom; ///< particles that may be fed before the metal needs more memory
};

class Weld {
  public:
    /// Throws InputError if the material lacks a property for flow or heat, RuntimeFault without GPU memory.
    Weld(gl::ShaderLibrary& shaders, const Material& material, const Workpiece& workpiece,
         const ProcessSettings& settings, const WeldSurroundings& surroundings = {});

    /// Restores metal and process to the start; the settings stay.
    void reset();
    /// Takes over live settings, and lets the pool be stirred by them; the kind of process stays that of the start.
    void apply(const ProcessSettings& settings);

    /// Saves or restores all that the next step reads but the settings, which come before it.
    void transfer(gl::StateArchive& archive);
    void xorOutDerivedState() { metal_.xorOutDerivedState(); } ///< see PhysicalMetal::xorOutDerivedState()

    /// Runs one time step of the metal under this torch: the distance of the metal on the torch's axis, as AxisProbe
    /// found it four steps ago and corrected by the torch's own way since -> process -> metal -> the next look. Waits
    /// for the GPU only if it is more than four steps behind.
    void step(const TorchSample& torch, gl::Profiler* profiler);

    /// Returns the arc of the last step.
    const ArcState& arc() const { return process_->arc(); }
    const Process& process() const { return *process_; }
    const PhysicalMetal& metal() const { return metal_; }
    PhysicalMetal& metal() { return metal_; }
    double timeStep() const { return static_cast<double>(metal_.timeStep()); }
    size_t bytes() const { return metal_.bytes() + probe_->bytes() + (rodProbe_ ? rodProbe_->bytes() : 0); }

  private:
    static MetalAhead metalAhead(AxisProbe& probe, const TorchRay& ray);
    void leadStirring(glm::vec3 axis);
    void lookAhead(const TorchSample& torch, gl::Profiler* profiler);

    const Property conductivity_; ///< conductivity of the liquid at rest
    const StirringShares pulled_;
    PhysicalMetal metal_;
    std::unique_ptr<Process> process_;
    double stirring_; ///< stirring that the metal conducts with
    std::unique_ptr<AxisProbe> probe_;
    std::unique_ptr<AxisProbe> rodProbe_; ///< probe along the filler rod; null if the process melts none
};

} // namespace meltpool
