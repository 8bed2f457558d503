// Parameters of the classic model: those that can change during a run, and those of its start.
#pragma once

#include "core/base/parameter.hpp"

#include <glm/vec3.hpp>

namespace meltpool {

/// Parameters that can change during a run; box units (one is 40 mm), seconds, temperature 0 .. 1.
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
    float heatRadius = 0.1F; ///< squared length: compared with the squared distance
    float heatTemperature = 0.02F;
};

/// Descriptions for menus, files and `--set`; they point into `parameters`.
ParameterList describe(ClassicParameters& parameters);

/// Parameters of the start.
struct ClassicSetup {
    enum Arrangement { kOrdered, kRandom };

    int particles = 20032;
    int arrangement = kOrdered;
    int seed = 1; ///< seed of the random positions
};

/// Descriptions of the start's parameters; changes take effect at the next start.
ParameterList describe(ClassicSetup& setup);

} // namespace meltpool
