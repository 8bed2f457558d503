// Definitions that the passes over solid fragments share with C++: connected solid metal is labelled, and fragments
// that no clamp holds move as rigid bodies.
//
// Two solid particles are bonded if they are closer than FRAGMENT_BOND_LENGTH spacings and either belonged to one
// fragment before or one of them froze since: metal that merely rests on metal is another fragment. A fragment without
// a clamped particle is free.
#ifndef MELTPOOL_SHARED_FRAGMENTS_H
#define MELTPOOL_SHARED_FRAGMENTS_H

#include "metal.h"

#define FRAGMENT_GROUP 256
#define FRAGMENT_MAX_COUNT 255   // free fragments that have a number; further ones do not move until a number is free
#define FRAGMENT_BOND_LENGTH 1.3 // spacings
#define FRAGMENT_NO_LABEL 0xFFFFFFFFu
#define FRAGMENT_WAY_UNIT 65536.0
#define FRAGMENT_CLAMPED 0x80000000u // set in the number of members at a root: one of them is clamped

// Storage buffers behind those of the metal itself.
// uint per coarse cell (2 x 2 x 2 lattice cells): slot + 1 of the first fixed solid off the lattice; then that of the
// first free one.
#define FRAGMENT_CELL_HEADS 6
#define FRAGMENT_CELL_NEXT 7   // uint per slot: slot + 1 of the next one in its list
#define FRAGMENT_LABELS 8      // uint per slot: slot of its fragment, no greater than its own; its own for the root
#define FRAGMENT_FIRST_LABELS 9 // these labels at the start of the cycle
#define FRAGMENT_MEMBERS 9      // member counts in their place after joining: uint per slot, see FRAGMENT_CLAMPED
#define FRAGMENT_CHANGES 10    // the metal's list of slots whose phase changed
#define FRAGMENT_CONTROL 12    // FragmentControl
#define FRAGMENT_MOTIONS 13    // FragmentMotion per fragment number
#define FRAGMENT_FREE_SLOTS 14 // uint: slots of free fragments in ascending order
#define FRAGMENT_CONTACTS 15   // FragmentContact for the first entries of the list of free slots

#define FRAGMENT_BLOCK 1 // uniform buffer

// Buffer textures
#define FRAGMENT_TEXELS_FIRST_LABEL 0
#define FRAGMENT_TEXELS_LATTICE 1
#define FRAGMENT_TEXELS_POSITION 2

#ifdef __cplusplus
namespace meltpool {
#endif

struct FragmentBlock {
    ivec3 coarseCells; // coarse cells along each axis
    float timeStep;    // s
    vec3 low;          // m, low corner of the space that metal may be in
    float floorHeight; // m along floorNormal
    vec3 high;         // m, the opposite corner
    float friction;    // Coulomb's coefficient, no unit
    vec3 floorNormal;  // unit vector out of the floor
    uint contactRoom;  // entries of the list of free slots whose contacts are stored
};

struct FragmentControl {
    uint fragments; // free ones
    uint particles; // particles in free fragments
    uint rejected;  // free fragments beyond FRAGMENT_MAX_COUNT
    uint reserved0;
    // Groups of the indirect dispatches; all zero while nothing is free. The fourth number of each is unused.
    uvec4 particleGroups; // groups over the list of free slots
    uvec4 fragmentGroups; // a group a fragment
    uvec4 slotGroups;     // groups over all slots
    uvec4 cellGroups;     // groups over the coarse cells
};

struct FragmentMotion {
    vec3 centre;        // centre of mass, m
    uint fixedContacts; // number of fixed contacts of its particles
    vec3 velocity; // m/s
    float wayShare;       // share of its way in this step that it moves, see heldBack
    vec3 angularVelocity; // rad/s, over this step
    uint heldBack; // greatest forbidden share of the way of one of its particles, in 1/FRAGMENT_WAY_UNIT: it would pass
                   // through fixed metal
    vec3 endAngularVelocity; // rad/s, at the step's end: the axis moves, the angular momentum does not
    float reserved1;
};

// Sums over a particle's contacts, in integers so that the order of the sum does not matter. Fixed metal is all that
// does not move: clamped metal, the floor and the walls of the space.
struct FragmentContact {
    ivec3 overlap; // overlap with fixed metal, times the normal, nm
    int fixedContacts;
    ivec3 normalVelocity; // relative to fixed metal, µm/s
    int reserved0;
    ivec3 slipVelocity; // tangential, likewise, µm/s
    int reserved1;
    ivec3 impact; // acceleration by other free fragments, mm/s²
    int reserved2;
};

#ifdef __cplusplus
static_assert(sizeof(FragmentBlock) == 64);
static_assert(sizeof(FragmentControl) == 80);
static_assert(sizeof(FragmentMotion) == 64);
static_assert(sizeof(FragmentContact) == 64);
} // namespace meltpool
#endif

#endif
