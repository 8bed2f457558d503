// Smooth random values in space for clouds and frost.
#pragma once

#include "core/gl/texture.hpp"

namespace meltpool {

/// A repeating volume of independent values 0..1, the same on every machine; linear sampling makes it smooth.
gl::Texture makeNoiseTexture();

} // namespace meltpool
