// A process beside which the other hand dips a filler rod or wire into the pool: GTAW, flame, soldering iron.
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
    /// The rod that melts; null while none is held.
    const RodSample* heldRod(const TorchSample& torch) const;
    /// The rod meets the electrode of this torch, whose diameter is in m.
    bool rodTouches(const TorchSample& torch, double electrodeDiameter) const;
    /// Goes on by `seconds`: what melts falls as drops, and arc() tells of the rod. `heat`: what melts it, null while
    /// nothing does. The W that it spends on the rod.
    double meltRod(const TorchSample& torch, const RodArc* heat, double seconds);

  private:
    FillerRod rod_;
    bool held_ = false;
};

} // namespace meltpool
