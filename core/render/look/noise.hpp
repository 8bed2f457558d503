// Smooth random values in space for clouds and frost.
#pragma once

#include "core/gl/texture.hpp"

namespace meltpool {

/// Makes a repeating volume of four independent values 0..1 a texel, identical on every machine; linear sampling makes
/// them smooth.
gl::Texture makeNoiseTexture();

} // namespace meltpool
