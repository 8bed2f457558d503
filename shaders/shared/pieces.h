// What the passes that tell solid pieces apart and move the loose ones share with C++.
//
// Two solid particles are bonded when they are closer than PIECE_BOND spacings and either belonged to the same piece before or one of
// them froze since: metal that merely rests on metal is no part of it. A piece that holds no clamped particle is loose.
#ifndef MELTPOOL_SHARED_PIECES_H
#define MELTPOOL_SHARED_PIECES_H

#include "metal.h"

#define PIECES_GROUP 256
#define PIECES_MOST 255   // loose pieces that can be told apart; what comes beyond stands still until a number is free
#define PIECES_ROUNDS 24  // label rounds of a cycle; a cycle that is not finished then is dropped and begun anew
#define PIECE_BOND 1.3    // spacings
#define PIECE_BITS (255u << PHASE_PIECE_SHIFT)
#define PIECE_NONE 0xFFFFFFFFu

// Storage buffers behind those of the metal itself.
#define PIECES_HEADS 6     // uint per coarse cell (2 x 2 x 2 lattice cells): slot + 1 of the first solid off the lattice
#define PIECES_NEXT 7      // uint per slot: slot + 1 of the next one in its coarse cell
#define PIECES_LABEL 8     // uint per slot: smallest slot known to be bonded to it
#define PIECES_RELABEL 9   // the same after this round
#define PIECES_TALLY 10    // uint per slot, used at roots: members, top bit: holds a clamp
#define PIECES_NUMBER 11   // uint per slot, used at roots: number of the piece
#define PIECES_CONTROL 12  // PiecesControl
#define PIECES_MOTION 13   // PieceMotion per piece number
#define PIECES_LOOSE 14    // uint: slots of loose pieces in ascending order
#define PIECES_CONTACT 15  // PieceContact per entry of the loose list

#define PIECES_BLOCK 1 // uniform buffer

// Buffer textures
#define PIECES_TEXELS_LABEL 0
#define PIECES_TEXELS_LATTICE 1
#define PIECES_TEXELS_POSITION 2

#ifdef __cplusplus
namespace meltpool {
#endif

struct PiecesBlock {
    ivec4 coarse; // xyz coarse cells, w free
    vec4 step;    // x time step s, y height of the floor m, z friction coefficient, w free
};

struct PiecesControl {
    uint changed; // last label round that changed something
    uint pieces;  // loose pieces
    uint loose;   // particles in them
    uint rejected; // pieces beyond PIECES_MOST
    uvec4 looseGroups; // indirect dispatches: over the loose list,
    uvec4 pieceGroups; // a group a piece,
    uvec4 slotGroups;  // over all slots, nothing while nothing is loose,
    uvec4 cellGroups;  // over the coarse cells, likewise
};

struct PieceMotion {
    vec4 centre;   // xyz centre of mass m, w members
    vec4 velocity; // xyz m/s, w contacts
    vec4 spin;     // xyz rad/s over this step
    vec4 after;    // xyz rad/s at its end: the axis moves, the angular momentum does not
};

// Sums over a particle's contacts, in integers so that the order of the sum does not matter.
struct PieceContact {
    ivec4 push;  // xyz overlap times normal in nm, w number of contacts with what stands still
    ivec4 damp;  // xyz normal part of the relative velocity in µm/s
    ivec4 slip;  // xyz tangential part in µm/s
    ivec4 knock; // xyz acceleration from other loose pieces in mm/s²
};

#ifdef __cplusplus
static_assert(sizeof(PiecesBlock) == 32);
static_assert(sizeof(PiecesControl) == 80);
static_assert(sizeof(PieceMotion) == 64);
static_assert(sizeof(PieceContact) == 64);
} // namespace meltpool
#endif

#endif
