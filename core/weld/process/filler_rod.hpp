// A filler rod that the other hand dips into the pool: the place of its end, and the metal that melts from it.
#pragma once

#include "core/weld/process/process.hpp"

namespace meltpool {

/// Melt of a rod in one step.
struct RodMelt {
    double volume = 0;     ///< m³ that leave the rod as liquid
    glm::vec3 place{0};    ///< start of their fall
    float temperature = 0; ///< K
    double heat = 0;       ///< W that the arc spends on the rod in this step and not on the workpiece
};

/// The arc, flame or hot tip near the rod.
struct RodArc {
    TorchRay electrode; ///< tip and direction of the electrode
    double length = 0;  ///< m, length of the arc from there
    double radius = 0;  ///< m, ArcState::radius
    double power = 0;   ///< W, ArcState::power
};

/// One rod in one hand. Its end melts back to the pool's surface when it dips into liquid, as fast as the arc's heat
/// allows; in the arc above the pool it melts into a ball, which falls when it has grown too heavy or meets the metal.
/// The shares of power and the size of the ball have no source: they are chosen by descriptions of welders.
class FillerRod {
  public:
    /// `diameter`: m.
    void setDiameter(double diameter) { diameter_ = diameter; }
    void reset();

    /// Returns the ray along the rod, from some way before its end, on which its metal is looked for.
    TorchRay ray(const RodSample& rod) const;

    /// Advances by `seconds`; `ahead`: the metal along ray(). `arc`: null while none burns, and then nothing melts.
    RodMelt step(const RodSample& rod, const MetalAhead& ahead, const RodArc* arc, const ProcessMetal& metal,
                 double seconds);

    /// Returns true if the rod meets the electrode of this torch.
    bool touches(const RodSample& rod, const TorchRay& electrode, double electrodeDiameter) const;

    /// Saves or restores all but the diameter.
    void transfer(gl::StateArchive& archive);

    double eaten() const { return eaten_; }   ///< m by which the end is behind RodSample::tip
    double ballDiameter() const;              ///< m; 0 without a ball
    double melted() const { return melted_; } ///< m of rod melted since the start
    double area() const;                      ///< m², cross-section
    bool inPool() const { return inPool_; }   ///< true if its end was in liquid metal in the last step

  private:
    double meltBack(const MetalAhead& ahead, double most);
    double meltBall(const RodArc& arc, const glm::vec3& end, double most);
    double pour(double spacing);

    double diameter_ = 2.4e-3;
    double eaten_ = 0;
    double melted_ = 0;
    double ball_ = 0;    ///< m³ of the ball on the end
    double falling_ = 0; ///< m³ of balls that have come off and fall particle by particle
    bool inPool_ = false;
};

} // namespace meltpool
