// Solid metal cut free of every clamp: finds the connected pieces, lets the loose ones fall, rest and tip over as rigid
// bodies, and joins them again where they freeze together.
#pragma once

#include "core/gl/buffer_view.hpp"
#include "core/gl/profiler.hpp"
#include "core/gl/program.hpp"
#include "core/metal/state/metal_state.hpp"
#include "shaders/shared/pieces.h"

namespace meltpool {

struct PieceSetup {
    float floorHeight = 0;  ///< m, the level that nothing falls through
    float friction = 0.35F; ///< metal on metal, Coulomb, no unit
};

/// What the pieces are at the moment.
struct PieceReport {
    unsigned pieces = 0;    ///< loose ones
    unsigned particles = 0; ///< in loose ones
    unsigned rejected = 0;  ///< loose ones beyond PIECES_MOST: they stand still
};

class SolidPieces {
  public:
    /// `state` must outlive this object.
    SolidPieces(gl::ShaderLibrary& shaders, MetalState& state, const PieceSetup& setup);

    /// One small part of telling the pieces apart, about the same for any amount of metal; a whole cycle takes
    /// PIECES_ROUNDS + 2 calls, more where there is much metal. Call it once a frame. Reads positions and phases; at
    /// the end of a cycle writes the piece bits, takes loose metal off the lattice and clears PHASE_FRESH.
    void relabel(gl::Profiler* profiler);

    /// A whole cycle at once, from its beginning.
    void relabelNow(gl::Profiler* profiler);

    /// Moves every loose piece on by `steps` times `dt` seconds: forces that others added to the velocities of its
    /// particles, gravity, contact with the floor, with fixed metal and with other pieces. Costs five empty dispatches
    /// a step while nothing is loose.
    void move(float dt, int steps, gl::Profiler* profiler);

    /// Waits for the GPU.
    PieceReport report() const;

    size_t bytes() const;

  private:
    void bind() const;
    void begin();
    void partOfRound(unsigned round);
    void finish();
    void moveOnce() const;
    void indirect(const gl::Program& program, size_t offset) const;

    MetalState& state_;
    PiecesBlock block_{};
    int stage_ = 0;    ///< begin, rounds, end
    size_t slots_ = 0; ///< that were there when the cycle began
    size_t done_ = 0;  ///< of them in this stage
    gl::Buffer blockBuffer_, heads_, next_, labels_, relabels_, tally_, numbers_, control_, motion_, loose_, contacts_;
    gl::BufferView labelTexels_, relabelTexels_, latticeTexels_, positionTexels_;
    const gl::Program &clear_, &beginLink_, &link_, &label_, &tallyUp_, &number_, &assign_, &list_, &contact_, &gather_,
        &advance_;
};

} // namespace meltpool
