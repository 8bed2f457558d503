// The classic model's adjustable values: what can be changed while it runs, and what is chosen at its start.
#pragma once

#include "core/base/parameter.hpp"

#include <glm/vec3.hpp>

namespace meltpool {

/// Live values, in box units (one box unit stands for 40 mm), seconds and the classic temperature 0 .. 1.
struct ClassicParameters {
    float restDensity = 70.0F;
    float particleMass = 0.02F;
    float viscosity = 3.5F;
    float gasStiffness = 5.0F;
    float supportRadius = 0.05F;
    glm::vec3 gravity{0.0F, -9.81F, 0.0F};
    float timeStep = 1.0F / 60.0F;
    float wallRestitution = 0.3F;
    bool wallSlip = false;
    float accelerationLimit = 100.0F;
    float solidifyRate = 0.002F;
    float heatRadius = 0.1F; ///< compared with the squared distance, so a squared length
    float heatTemperature = 0.02F;
};

/// The one description that menus, files and `--set` are made from; it points into `parameters`.
ParameterList describe(ClassicParameters& parameters);

/// What a fresh classic metal is made of.
struct ClassicSetup {
    enum Arrangement { kOrdered, kRandom };

    int particles = 20032;
    int arrangement = kOrdered;
    int seed = 1; ///< of the random places
};

/// As above; every entry takes effect at the next start.
ParameterList describe(ClassicSetup& setup);

} // namespace meltpool
