// What every welding process has in common: it turns the torch's pose and the distance of the metal into heat, drops
// and pressure, and tells the state of its arc.
#pragma once

#include "core/base/parameter.hpp"
#include "core/metal/flow/arc_pressure.hpp"
#include "core/metal/heat/heat_source.hpp"
#include "core/weld/process/arc.hpp"
#include "core/weld/process/filler.hpp"
#include "core/weld/torch/torch_sample.hpp"

#include <limits>
#include <optional>
#include <span>

namespace meltpool {

struct Equipment;
struct ProcessSettings;
struct ProcessTraits;

/// What a process must know of the metal that it works on.
struct ProcessMetal {
    const HeatTable& table;
    double density;                                                ///< kg/m³, that particle masses are made from
    float spacing;                                                 ///< m
    double ambient;                                                ///< K, of wire and rod before they melt
    double boilingPoint = std::numeric_limits<double>::infinity(); ///< K
};

/// A half line from the torch into the metal.
struct TorchRay {
    glm::vec3 origin{0};      ///< m
    glm::vec3 axis{0, -1, 0}; ///< unit vector
    float reach = 0.05F;      ///< m, how far metal is looked for
};

/// The metal under the torch's axis.
struct MetalAhead {
    float distance = std::numeric_limits<float>::infinity(); ///< m from the ray's origin; infinite: none in reach
    float liquid = 0;                                        ///< 0..1, share of liquid there
};

/// Where the wire has gone since the start, m of wire. fed = melted + change of the extension.
struct WireAccount {
    double fed = 0;      ///< through the contact tip
    double melted = 0;   ///< into drops
    double standing = 0; ///< beyond the contact tip now
    double area = 0;     ///< m², cross-section; 0: this process has no wire
    double density = 0;  ///< kg/m³
};

class Process {
  public:
    explicit Process(const ProcessMetal& metal) : metal_(metal), filler_(metal.spacing) {}
    virtual ~Process() = default;

    /// Takes over the live settings of this process.
    virtual void apply(const ProcessSettings& settings) = 0;

    /// Where the metal is looked for under this torch.
    virtual TorchRay ray(const TorchSample& torch) const { return {torch.tip, torch.axis()}; }

    /// Where the metal is looked for before the filler rod; nothing where none is held or the process melts none.
    virtual std::optional<TorchRay> rodRay(const TorchSample& /*torch*/) const { return std::nullopt; }

    /// Goes on by `seconds` under this torch and makes sources(), drops(), pressure() and arc() anew. What `ahead` says
    /// was found along ray(), `rodAhead` along rodRay().
    void step(const TorchSample& torch, const MetalAhead& ahead, double seconds, const MetalAhead& rodAhead = {});

    std::span<const HeatSource> sources() const { return {&source_, source_.power > 0 ? 1U : 0U}; }
    std::span<const MetalSeed> drops() const { return drops_; }
    ArcPressure pressure() const;
    const ArcState& arc() const { return arc_; }
    virtual WireAccount wire() const { return {}; }
    /// Melts a filler rod where the other hand holds one; see holdsRod().
    virtual bool takesRod() const { return false; }
    /// m that the tip of the torch's pose lies before what is left of an electrode that burns off.
    virtual float burntOff() const { return 0; }
    /// The particles that were fed.
    const Filler& filler() const { return filler_; }

    /// Times the metal's own conductivity that its liquid conducts while this process stirs it, as it is set.
    virtual double stirring() const { return 1; }
    /// The pull of the surface's tension gives that stirring a way, see pulledStirring(). Where metal falls through the
    /// arc its drops mix the pool.
    virtual bool stirredByTension() const { return false; }

    /// Radius of what touches the metal first (wire, electrode, soldering tip), m.
    virtual float touchRadius() const { return 0; }

    /// Back to how it began; the settings stay.
    virtual void reset();

    /// Saves or restores all that the next step reads but the settings, which come before it. sources() and drops() are
    /// empty after it was restored.
    virtual void transfer(gl::StateArchive& archive);

  protected:
    /// Sets arc_ and, where there is heat, source_ and drops_.
    virtual void advance(const TorchSample& torch, const MetalAhead& ahead, double seconds) = 0;

    /// Heat of `power` W on the surface that the axis meets at the arc's distance, as wide as the arc. Nothing behind
    /// the ray's origin or far beyond that surface is heated.
    void heatSurface(const TorchRay& ray, double power);
    /// Presses on that surface with the force of an arc of `current` (A); sigma is `radius` (m).
    void pressSurface(double current, double radius);
    /// Melts `volume` (m³) of wire in `seconds` into drops that leave `place` with `velocity`; gives the W that they
    /// bring, which are at most `available`: an arc too weak for hot drops makes colder ones.
    double meltWire(double volume, double seconds, const glm::vec3& place, const glm::vec3& velocity, double available);

    /// Lets `volume` (m³) of liquid filler at `temperature` (K) leave `place` with `velocity`; its heat is the caller's
    /// account.
    void dropFiller(double volume, const glm::vec3& place, const glm::vec3& velocity, float temperature) {
        drops_ = filler_.feed(volume, place, velocity, temperature);
    }

    const ProcessMetal metal_;
    MetalAhead rodAhead_;
    ArcState arc_;
    HeatSource source_;
    Filler filler_;

  private:
    float pressureRadius_ = 0; ///< m, sigma of the arc's pressure
    std::span<const MetalSeed> drops_;
};

} // namespace meltpool
