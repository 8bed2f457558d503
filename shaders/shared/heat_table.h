// Temperature and Kirchhoff variable over enthalpy in the shaders' form: three parts (solid, mushy, liquid), each
// sampled evenly in enthalpy.
#ifndef MELTPOOL_HEAT_TABLE_H
#define MELTPOOL_HEAT_TABLE_H

#define HEAT_TABLE_STEPS 256
#define HEAT_TABLE_ROW (HEAT_TABLE_STEPS + 1)
#define HEAT_TABLE_ENTRIES (3 * HEAT_TABLE_ROW)

#endif
