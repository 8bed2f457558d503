// Spatter: drops that the arc throws out of pool and wire, from its state in each step. They follow closed forms from
// their birth; nothing of them is stepped.
#pragma once

#include "core/render/effects/cooling.hpp"
#include "core/render/effects/flight.hpp"
#include "core/render/effects/spark.hpp"
#include "core/weld/process/processes.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace meltpool {

/// The end of a short circuit, with the step of electric power that throws the spatter.
struct Reignition {
    float at = 0;    ///< s after the step's beginning
    float power = 0; ///< W
};

/// One step of the arc, for the effects.
struct ArcEffectsStep {
    std::uint64_t number = 0; ///< number of the step: all chance is counted from it
    double time = 0;          ///< s, at the step's end
    double seconds = 0;
    const ProcessSettings* process = nullptr;
    ArcState arc;
    glm::vec3 place{0};       ///< m, middle of the arc
    glm::vec3 wireEnd{0};     ///< m
    glm::vec3 axis{0, -1, 0}; ///< unit, from the torch to the metal
    std::span<const Reignition> reignitions;
    double shortPhase = 0; ///< counter that grows by 1 from each short circuit to the next
    double dropRate = 0;   ///< 1/s, drops that leave the wire of an open arc
};

class Spatter {
  public:
    /// Drops that fly, at most; the oldest go first. More than a dip transfer throws in their lifetime.
    static constexpr size_t kMostFlying = 384;
    /// Beads on plate and table, at most; the oldest go first.
    static constexpr size_t kMostBeads = 256;
    /// m: smaller drops are cold before they stick, and roll away. No source: chosen.
    static constexpr float kSticks = 0.25e-3F;
    /// s that the eye gathers light for a picture: about that of a headset's frame, and of the eye in bright light.
    static constexpr float kGathered = 1.0F / 90;

    Spatter() { reset(); }
    void reset();
    void setGround(const SpatterGround& ground) { ground_ = ground; }

    void step(const ArcEffectsStep& step);

    /// Appends the drops in flight `time` s after the lesson's beginning, then the beads on the workpiece, then those
    /// on the table; returns the number of the last kind.
    size_t show(double time, std::vector<Spark>& sparks) const;

    /// Returns the bursts since the start: one for each short circuit that ends by itself, and one for each arc that
    /// strikes.
    std::uint64_t bursts() const { return bursts_; }
    /// Returns the number of drops since the start.
    std::uint64_t born() const { return born_; }

  private:
    struct Drop {
        Flight flight;
        double birth = 0; ///< s
        float diameter = 0;
        float landing = 0; ///< s after its birth
    };
    struct Bead {
        glm::vec3 place{0};
        float diameter = 0;
        double birth = 0;  ///< birth of the drop, s
        double landed = 0; ///< s
        bool onTable = false;
    };

    void burst(const ArcEffectsStep& step, double at, int drops);
    void throwDrop(const ArcEffectsStep& step, double at);
    void keepBead(const Drop& drop, const Landing& landing);
    void meltBeads(const ArcEffectsStep& step);

    SpatterCooling cooling_;
    SpatterGround ground_;
    std::array<Drop, kMostFlying> flying_;
    std::array<Bead, kMostBeads> beads_;
    size_t nextDrop_ = 0, nextBead_ = 0;
    std::uint64_t bursts_ = 0, born_ = 0;
    std::uint64_t draws_ = 0; ///< number of random draws in this step
};

} // namespace meltpool
