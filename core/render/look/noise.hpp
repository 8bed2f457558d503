// Smooth random values in space for clouds and frost.
#pragma once

#include "core/gl/texture.hpp"

namespace meltpool {

/// A repeating volume of four independent values 0..1 a texel, the same on every machine; linear sampling makes them
/// smooth.
gl::Texture makeNoiseTexture();

} // namespace meltpool
