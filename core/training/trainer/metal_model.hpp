// The metal of any lesson: it steps under a torch, answers for its figures and lends its particles to pictures.
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

    /// Puts the metal back to how it began.
    virtual void reset() = 0;
    /// Takes over the values of the lesson that may change while running.
    virtual void apply(const Lesson& lesson) = 0;
    /// One fixed step under the torch. `profiler` may be null.
    virtual void step(const TorchSample& torch, gl::Profiler* profiler) = 0;
    /// Length of a step, s.
    virtual double timeStep() const = 0;

    virtual ParticleView particles() const = 0;
    /// Metres of a unit of particles() and of the surface.
    virtual float unit() const = 0;
    /// How far apart the particles of whole metal lie, in units of particles(); nothing for metal without a lattice.
    virtual std::optional<float> spacing() const { return std::nullopt; }
    /// 0 solid .. 1 liquid, of a temperature of this metal.
    virtual float liquidShare(float temperature) const = 0;
    /// The arc of the last step. `surface`: the shown metal under the torch, for metals whose process has no arc of its
    /// own.
    virtual ArcState arc(const SurfaceDistance& surface) const = 0;
    /// Radius (m) of what touches the metal first: wire, electrode, soldering tip.
    virtual float touchRadius() const { return 0; }
    /// See Process::burntOff() and Process::takesRod().
    virtual float burntOff() const { return 0; }
    virtual bool takesRod() const { return false; }
    /// Where the wire has gone; nothing for processes without.
    virtual WireAccount wire() const { return {}; }
    /// Makes the surroundings of this metal for pictures. They show the process and its arc as they are at each view;
    /// the metal must outlive them.
    virtual std::unique_ptr<MetalScene> makeScene() const = 0;

    /// The weld cut across at `place` (m along the seam), by default in the middle of what was welded; nothing where
    /// there is no weld to cut, and of a pipe, whose seam is no straight line. Waits for the GPU.
    virtual std::optional<WeldSection> section(std::optional<double> /*place*/) const { return std::nullopt; }

    /// The whole weld at these stations; nothing where there is no weld to measure. Waits for the GPU.
    virtual std::optional<WeldMeasures> measureWeld(const StationSettings& /*stations*/) const { return std::nullopt; }

    /// Sets what the surface must know of this metal; called before each of its updates, when it holds the lesson's
    /// values.
    virtual void prepare(Surface&) const {}

    /// Waits for the GPU.
    virtual MetalStatistics statistics() = 0;
    /// Never waits: ask for the figures of the metal as it is now, then look in later frames. Throws RuntimeFault when
    /// kStatisticsInFlight answers are pending.
    virtual void requestStatistics() = 0;
    /// The oldest answer that was not given yet, where it has arrived.
    virtual std::optional<MetalStatistics> pollStatistics() = 0;
    /// The same, waiting for the GPU; nothing only where none is pending.
    virtual std::optional<MetalStatistics> awaitStatistics() = 0;

    /// Saves or restores all that the next step reads but the lesson's values, which are applied before it. Answers
    /// that were requested are dropped where it restores.
    virtual void transfer(gl::StateArchive& archive) = 0;
    /// Folds the state away before it is copied, unfolds it afterwards and once it is restored; see
    /// PhysicalMetal::fold(). Models whose state holds nothing that follows from the rest do nothing.
    virtual void fold() {}

    /// Number that the whole state gives; equal states give equal numbers. Waits for the GPU.
    virtual std::uint64_t stateHash() const = 0;
    /// GPU memory, bytes.
    virtual size_t bytes() const = 0;
};

/// The metal that the lesson asks for. Throws InputError when it cannot be made with the lesson's values.
std::unique_ptr<MetalModel> makeMetalModel(gl::ShaderLibrary& shaders, const Lesson& lesson);

} // namespace meltpool
