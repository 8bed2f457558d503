// Base of the processes with a filler rod or wire in the other hand: GTAW, flame, soldering iron.
#pragma once

#include "core/weld/process/filler_rod.hpp"

namespace meltpool {

class RodProcess : public Process {
  public:
    using Process::Process;
    bool takesRod() const override { return true; }
    std::optional<TorchRay> rodRay(const TorchSample& torch) const override;
    WireAccount wire() const override;
    void reset() override;
    void transfer(gl::StateArchive& archive) override;

  protected:
    /// `diameter`: m; 0: none is held.
    void setRod(double diameter);
    /// Returns the rod that melts; null while none is held.
    const RodSample* heldRod(const TorchSample& torch) const;
    /// Returns true if the rod meets the electrode of this torch, whose diameter is in m.
    bool rodTouches(const TorchSample& torch, double electrodeDiameter) const;
    /// Advances by `seconds`: melted filler falls as drops, and arc() includes the rod. `heat`: the arc that melts it,
    /// null while nothing does. Returns the W that it spends on the rod.
    double meltRod(const TorchSample& torch, const RodArc* heat, double seconds);

  private:
    FillerRod rod_;
    bool held_ = false;
};

} // namespace meltpool
