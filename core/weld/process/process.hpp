// Base of every welding process: it turns the torch's pose and the distance of the metal into heat, drops and pressure,
// and provides the state of its arc.
#pragma once

#include "core/base/parameter.hpp"
#include "core/metal/flow/arc_pressure.hpp"
#include "core/metal/flow/edge_arrest.hpp"
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

/// Data that a process needs of the metal that it works on.
struct ProcessMetal {
    const HeatTable& table;
    double density;                                                ///< kg/m³, for the masses of particles
    float spacing;                                                 ///< m
    double ambient;                                                ///< K, temperature of wire and rod before they melt
    double boilingPoint = std::numeric_limits<double>::infinity(); ///< K
};

/// A half line from the torch into the metal.
struct TorchRay {
    glm::vec3 origin{0};      ///< m
    glm::vec3 axis{0, -1, 0}; ///< unit vector
    float reach = 0.05F;      ///< m, length in which metal is looked for
};

/// The metal on the torch's axis.
struct MetalAhead {
    float distance = std::numeric_limits<float>::infinity(); ///< m from the ray's origin; infinite: none in reach
    float liquid = 0;                                        ///< 0..1, share of liquid there
};

/// Balance of the wire since the start, m of wire: fed = melted + change of the extension.
struct WireAccount {
    double fed = 0;      ///< passed through the contact tip
    double melted = 0;   ///< melted into drops
    double standing = 0; ///< length beyond the contact tip now
    double area = 0;     ///< m², cross-section; 0: this process has no wire
    double density = 0;  ///< kg/m³
};

class Process {
  public:
    explicit Process(const ProcessMetal& metal) : metal_(metal), filler_(metal.spacing) {}
    virtual ~Process() = default;

    /// Takes over the live settings of this process.
    virtual void apply(const ProcessSettings& settings) = 0;

    /// Returns the ray on which metal is looked for under this torch.
    virtual TorchRay ray(const TorchSample& torch) const { return {torch.tip, torch.axis()}; }

    /// Returns the ray on which metal is looked for before the filler rod; nothing if none is held or the process melts
    /// none.
    virtual std::optional<TorchRay> rodRay(const TorchSample& /*torch*/) const { return std::nullopt; }

    /// Advances by `seconds` under this torch and renews sources(), drops(), pressure() and arc(). `ahead`: metal found
    /// along ray(), `rodAhead`: along rodRay().
    void step(const TorchSample& torch, const MetalAhead& ahead, double seconds, const MetalAhead& rodAhead = {});

    std::span<const HeatSource> sources() const { return {&source_, source_.power > 0 ? 1U : 0U}; }
    std::span<const MetalSeed> drops() const { return drops_; }
    ArcPressure pressure() const;
    const ArcState& arc() const { return arc_; }
    /// Returns the arrest of the pool's edge at the present settings.
    virtual EdgeArrest edgeArrest() const;
    virtual WireAccount wire() const { return {}; }
    /// Returns true if the process melts a filler rod in the other hand; see holdsRod().
    virtual bool takesRod() const { return false; }
    /// Returns the distance (m) by which the tip of the torch's pose is ahead of the rest of an electrode that burns
    /// off.
    virtual float burntOff() const { return 0; }
    /// Returns the particles that were fed.
    const Filler& filler() const { return filler_; }

    /// Returns the factor on the metal's own conductivity for its liquid while this process stirs it, at its present
    /// settings.
    virtual double stirring() const { return 1; }
    /// Returns true if the pull of surface tension gives that stirring a direction, see pulledStirring(). Drops that
    /// fall through the arc mix the pool instead.
    virtual bool stirredByTension() const { return false; }

    /// Returns the radius of the part that touches the metal first (wire, electrode, soldering tip), m.
    virtual float touchRadius() const { return 0; }

    /// Returns to the state at the start; the settings stay.
    virtual void reset();

    /// Saves or restores all that the next step reads but the settings, which come before it. sources() and drops() are
    /// empty after a restore.
    virtual void transfer(gl::StateArchive& archive);

  protected:
    virtual double dropTemperature() const; ///< K, of drops that leave the wire or electrode
    /// Sets arc_ and, if there is heat, source_ and drops_.
    virtual void advance(const TorchSample& torch, const MetalAhead& ahead, double seconds) = 0;

    /// Adds heat of `power` W on the surface that the axis meets at the arc's distance, as wide as the arc. Nothing
    /// behind the ray's origin or far beyond that surface is heated.
    void heatSurface(const TorchRay& ray, double power);
    /// Presses on that surface with the force of an arc of `current` (A); sigma is `radius` (m).
    void pressSurface(double current, double radius);
    /// Melts `volume` (m³) of wire in `seconds` into drops that leave `place` with `velocity`; returns the W that they
    /// bring, which are at most `available`: an arc too weak for hot drops makes colder ones.
    double meltWire(double volume, double seconds, const glm::vec3& place, const glm::vec3& velocity, double available);

    /// Lets `volume` (m³) of liquid filler at `temperature` (K) leave `place` with `velocity`; the caller accounts for
    /// its heat.
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
