// Sources of heat on the metal: volumes, a Gaussian flux, a hot tool.
#pragma once

#include "shaders/shared/heat_source.h"

#include <glm/vec3.hpp>

namespace meltpool {

/// A heat source on metal. The factories state the arguments of each kind; the metal receives exactly its power in W,
/// whatever metal is there, and none if there is none.
struct HeatSource {
    int kind = SOURCE_SPHERE;
    glm::vec3 position{0};                    ///< m
    glm::vec3 axis{0, -1, 0};                 ///< unit vector into the metal
    glm::vec3 travel{1, 0, 0};                ///< unit vector of travel
    float power = 0;                          ///< W
    float size = 0;                           ///< radius, sigma or front half-axis, m
    float halfWidth = 0, depth = 0, rear = 0; ///< other half-axes of the ellipsoid, m
    float frontFraction = 0;                  ///< twice the share of the ellipsoid's power in front
    float tipTemperature = 0;                 ///< K
    float tipConductance = 0;                 ///< W/(m² K)
    float before = kUnlimited;                ///< m, of the Gaussian: from the torch to the position
    float beyond = kUnlimited;                ///< m, from the position to where surfaces are in shadow
    float fullWeight = 0;                     ///< m², see catching()

    static constexpr float kUnlimited = 1e6F; ///< m

    /// Volume source 1 - d²/R² of the classic model.
    static HeatSource sphere(glm::vec3 centre, float radius, float power);
    /// Gaussian flux exp(-r²/(2 sigma²)) around `axis`, on surface that faces it.
    static HeatSource gaussian(glm::vec3 position, glm::vec3 axis, float sigma, float power);
    /// This Gaussian, limited to the surface that the axis meets in front of a torch: metal farther than `before` (m)
    /// in front of the position is behind the torch, and gets nothing; nor does metal more than `beyond` (m) plus
    /// twice its distance from the axis behind the position.
    HeatSource inFront(float before, float beyond) const;
    /// This Gaussian with its power limited to the part that metal catches: in proportion to the part of its
    /// cross-section 2 pi sigma² that surface fills, and in full from `share` of it on.
    HeatSource catching(float share) const;
    /// Double ellipsoid of Goldak, Chakravarti and Bibby (1984). Half-axes in m; the front takes `frontFraction`/2 of
    /// the power.
    static HeatSource ellipsoid(glm::vec3 position, glm::vec3 axis, glm::vec3 travel, float halfWidth, float depth,
                                float front, float rear, float frontFraction, float power);
    /// A tool at `temperature` (K) that touches all surface within `radius`; gives `conductance` (W/(m² K)) times area
    /// times difference, and never more than `power`.
    static HeatSource hotTip(glm::vec3 position, float radius, float temperature, float conductance, float power);

    /// Distance from `position` beyond which the source's power is negligible, m.
    float reach() const;
};

} // namespace meltpool
