// Interface to the metal of any lesson: it steps under a torch, returns its figures and lends its particles to
// pictures.
#pragma once

#include "core/gl/profiler.hpp"
#include "core/gl/state_archive.hpp"
#include "core/metal/state/particle_view.hpp"
#include "core/metal/state/statistics.hpp"
#include "core/scene/metal_scene.hpp"
#include "core/surface/surface.hpp"
#include "core/weld/gauge/weld_section.hpp"
#include "core/weld/gauge/weld_stations.hpp"
#include "core/weld/process/arc.hpp"
#include "core/weld/process/process.hpp"
#include "core/weld/process/tip_touch.hpp"
#include "core/weld/torch/torch_sample.hpp"

#include <cstdint>
#include <memory>
#include <optional>

namespace meltpool {

struct Lesson;

class MetalModel {
  public:
    virtual ~MetalModel() = default;

    /// Resets the metal to its start.
    virtual void reset() = 0;
    /// Applies the values of the lesson that may change while running.
    virtual void apply(const Lesson& lesson) = 0;
    /// One fixed step under the torch. `profiler` may be null.
    virtual void step(const TorchSample& torch, gl::Profiler* profiler) = 0;
    /// Length of a step, s.
    virtual double timeStep() const = 0;

    virtual ParticleView particles() const = 0;
    /// Metres of a unit of particles() and of the surface.
    virtual float unit() const = 0;
    /// Distance of the particles in whole metal, in units of particles(); empty for metal without a lattice.
    virtual std::optional<float> spacing() const { return std::nullopt; }
    /// Share of liquid, 0 solid .. 1 liquid, at a temperature of this metal.
    virtual float liquidShare(float temperature) const = 0;
    /// The arc of the last step. `surface`: the shown metal under the torch, for metals whose process has no arc of its
    /// own.
    virtual ArcState arc(const SurfaceDistance& surface) const = 0;
    /// Radius (m) of the part that touches the metal first: wire, electrode, soldering tip.
    virtual float touchRadius() const { return 0; }
    /// See Process::burntOff() and Process::takesRod().
    virtual float burntOff() const { return 0; }
    virtual bool takesRod() const { return false; }
    /// Account of the wire; zero for processes without wire.
    virtual WireAccount wire() const { return {}; }
    /// Makes the surroundings of this metal for pictures. They show the process and its arc at the time of each view;
    /// the metal must outlive them.
    virtual std::unique_ptr<MetalScene> makeScene() const = 0;

    /// Section of the weld at `place` (m along the seam), by default in the middle of the welded part; empty without a
    /// weld, and for a pipe, whose seam is not a straight line. Waits for the GPU.
    virtual std::optional<WeldSection> section(std::optional<double> /*place*/) const { return std::nullopt; }

    /// Measures of the whole weld at these stations; empty without a weld. Waits for the GPU.
    virtual std::optional<WeldMeasures> measureWeld(const StationSettings& /*stations*/) const { return std::nullopt; }

    /// Gives the surface its data about this metal; called before each of its updates, when it holds the lesson's
    /// values.
    virtual void prepare(Surface&) const {}

    /// Waits for the GPU.
    virtual MetalStatistics statistics() = 0;
    /// Never waits: requests the figures of the present metal; poll in later frames. Throws RuntimeFault if
    /// kStatisticsInFlight answers are pending.
    virtual void requestStatistics() = 0;
    /// The oldest answer not yet returned, if it has arrived.
    virtual std::optional<MetalStatistics> pollStatistics() = 0;
    /// The oldest answer not yet returned, waiting for the GPU; empty only if none is pending.
    virtual std::optional<MetalStatistics> awaitStatistics() = 0;

    /// Saves or restores everything that the next step reads, except the lesson's values, which are applied before it.
    /// Restoring drops the requested answers.
    virtual void transfer(gl::StateArchive& archive) = 0;
    /// Removes derivable values before the state is copied; a second call, and one after restoring, brings them back,
    /// see PhysicalMetal::xorOutDerivedState(). A no-op for models without derivable values.
    virtual void xorOutDerivedState() {}

    /// Hash of the whole state; equal states have equal hashes. Waits for the GPU.
    virtual std::uint64_t stateHash() const = 0;
    /// GPU memory, bytes.
    virtual size_t bytes() const = 0;
};

/// Makes the lesson's metal. Throws InputError if it cannot be made with the lesson's values.
std::unique_ptr<MetalModel> makeMetalModel(gl::ShaderLibrary& shaders, const Lesson& lesson);

} // namespace meltpool
