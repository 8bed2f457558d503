// The rows of four cells that hold metal, or may, of the tiles that take part in this step: see HeatControl. Included
// after common.glsl and the declaration of `control`.
layout(binding = HEAT_TEXELS_LISTED_ROWS) uniform usamplerBuffer rowTexels;

/// Index in the list of row number `entry` of the mixed tiles that a source may reach, or of the others.
uint placeOfMixed(bool reached, uint entry) {
    return reached ? control.plainRows.w + entry : uint(TILE_ROWS * heatBlock.tileCount) - 1u - entry;
}

int listedRow(uint place) { return int(texelFetch(rowTexels, int(place)).x); }
