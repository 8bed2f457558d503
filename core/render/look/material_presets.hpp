// Optical properties of the preset materials of the classic model and of physical materials.
#pragma once

#include "core/metal/material/materials.hpp"
#include "core/render/look/look.hpp"
#include "core/weld/process/ripples.hpp"
#include "shaders/shared/render.h"

namespace meltpool {

/// Returns a preset material. Solder is the founding thesis's metal: grey 0.7 with mirror share 0.3 solid, 0.2 and 0.6
/// liquid.
MaterialData presetMaterial(MaterialLook look);

/// Returns the optical properties from the looks of a physical material.
MaterialData physicalMaterial(const MaterialLooks& looks, const FreezingRipples& ripples = {});

/// Program that draws a material.
enum class SurfaceKind { metal, wax, ice };
SurfaceKind presetKind(MaterialLook look);
SurfaceKind physicalKind(const MaterialLooks& looks);

} // namespace meltpool
