// What the passes over solid fragments share with C++: connected solid metal is labelled, and fragments that no clamp
// holds move as rigid bodies.
//
// Two solid particles are bonded when they are closer than FRAGMENT_BOND_LENGTH spacings and either belonged to the same fragment before
// or one of them froze since: metal that merely rests on metal is another fragment. A fragment without a clamped particle is free.
#ifndef MELTPOOL_SHARED_FRAGMENTS_H
#define MELTPOOL_SHARED_FRAGMENTS_H

#include "metal.h"

#define FRAGMENT_GROUP 256
#define FRAGMENT_MAX_COUNT 255   // free fragments that have a number; what comes beyond stands still until a number is free
#define FRAGMENT_BOND_LENGTH 1.3 // spacings
#define FRAGMENT_NO_LABEL 0xFFFFFFFFu
#define FRAGMENT_WAY_UNIT 65536.0
#define FRAGMENT_CLAMPED 0x80000000u // set in the number of members at a root: one of them is clamped

// Storage buffers behind those of the metal itself.
#define FRAGMENT_CELL_HEADS 6  // uint per coarse cell (2 x 2 x 2 lattice cells): slot + 1 of the first fixed solid off the lattice; then the same of free ones
#define FRAGMENT_CELL_NEXT 7   // uint per slot: slot + 1 of the next one in its list
#define FRAGMENT_LABELS 8      // uint per slot: slot of the same fragment, no greater than its own, where it is the root
#define FRAGMENT_FIRST_LABELS 9 // the same as the cycle began with them
#define FRAGMENT_MEMBERS 9     // in their place when all are joined: uint per slot, used at roots, see FRAGMENT_CLAMPED
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
    ivec3 coarseCells; // along each axis
    float timeStep;    // s
    vec3 low;          // m, corner of the space that metal may be in
    float floorHeight; // m along floorNormal
    vec3 high;         // m, the opposite corner
    float friction;    // Coulomb's coefficient, no unit
    vec3 floorNormal;  // unit vector out of the floor
    uint contactRoom;  // entries of the list of free slots whose contacts are kept
};

struct FragmentControl {
    uint fragments; // free ones
    uint particles; // in them
    uint rejected;  // free fragments beyond FRAGMENT_MAX_COUNT
    uint reserved0;
    // Groups of the indirect dispatches; all zero while nothing is free. The fourth number of each is unused.
    uvec4 particleGroups; // over the list of free slots
    uvec4 fragmentGroups; // a group a fragment
    uvec4 slotGroups;     // over all slots
    uvec4 cellGroups;     // over the coarse cells
};

struct FragmentMotion {
    vec3 centre; // of mass, m
    uint fixedContacts; // of its particles, in all
    vec3 velocity; // m/s
    float wayShare; // of its way in this step that it goes, see heldBack
    vec3 angularVelocity; // rad/s, over this step
    uint heldBack; // greatest share of its way that one of its particles must not go, in 1/FRAGMENT_WAY_UNIT: it would pass
                   // through metal that stands still
    vec3 endAngularVelocity; // rad/s, at the step's end: the axis moves, the angular momentum does not
    float reserved1;
};

// Sums over a particle's contacts, in integers so that the order of the sum does not matter. "Fixed" is what stands still:
// clamped metal, the floor and the walls of the space.
struct FragmentContact {
    ivec3 overlap; // with what is fixed, times the normal, nm
    int fixedContacts;
    ivec3 normalVelocity; // relative to what is fixed, µm/s
    int reserved0;
    ivec3 slipVelocity; // likewise, tangential, µm/s
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
