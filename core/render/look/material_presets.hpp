// The optical numbers of the materials that the classic model can wear.
#pragma once

#include "core/metal/material/materials.hpp"
#include "core/render/look/look.hpp"
#include "shaders/shared/render.h"

namespace meltpool {

/// The preset. Solder is the founding thesis's metal: grey 0.7 with mirror share 0.3 solid, 0.2 and 0.6 liquid.
MaterialData presetMaterial(MaterialLook look);

/// The same numbers from a physical material's looks.
MaterialData physicalMaterial(const MaterialLooks& looks);

/// Which program draws a material.
enum class SurfaceKind { metal, wax, ice };
SurfaceKind presetKind(MaterialLook look);
SurfaceKind physicalKind(const MaterialLooks& looks);

} // namespace meltpool
