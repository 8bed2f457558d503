// The rows of four cells that hold metal, or may, of the tiles that take part in this step: see HeatControl. Included after common.glsl
// and the declaration of `control`.
layout(binding = HEAT_TEXELS_LISTED_ROWS) uniform usamplerBuffer rowTexels;

/// Where the rows of mixed tiles that a source may reach begin in the list, and those of the others.
uint firstReachedRow() { return control.plainRows.w; }
uint firstUnreachedRow() { return firstReachedRow() + TILE_ROWS * control.mixedRows.w; }

int listedRow(uint place) { return int(texelFetch(rowTexels, int(place)).x); }
