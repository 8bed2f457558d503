// Solid metal cut free of every clamp: labels the connected fragments, lets the free ones fall, rest and tip over as
// rigid bodies, and joins those that freeze together.
#pragma once

#include "core/gl/profiler.hpp"
#include "core/gl/program.hpp"
#include "core/gl/readback.hpp"
#include "core/metal/fragment_labels.hpp"
#include "core/metal/state/metal_state.hpp"
#include "shaders/shared/fragments.h"

namespace meltpool {

struct FragmentSetup {
    glm::vec3 floorNormal{0, 1, 0}; ///< unit vector out of the floor, against gravity
    float floorHeight = 0;          ///< m along the normal, the level that stops all metal
    float friction = 0.35F;         ///< metal on metal, Coulomb, no unit
    /// Greatest number of free particles whose contacts are stored, 64 B each. Those of further ones are found twice:
    /// slower, with the same result.
    unsigned contactRoom = 8192;
    glm::vec3 low{-1e3F}; ///< m, the space whose sides no fragment leaves
    glm::vec3 high{1e3F}; ///< m
};

/// The number of free fragments at present.
struct FragmentReport {
    unsigned fragments = 0; ///< free ones
    unsigned particles = 0; ///< particles of free ones
    unsigned rejected = 0;  ///< free ones beyond FRAGMENT_MAX_COUNT: they do not move
};

/// Moves the fragments that FragmentLabels finds free.
class RigidFragments {
  public:
    /// `state` must outlive this object.
    RigidFragments(gl::ShaderLibrary& shaders, MetalState& state, const FragmentSetup& setup);
    RigidFragments(const RigidFragments&) = delete; // its labels refer to its block
    RigidFragments& operator=(const RigidFragments&) = delete;

    /// Returns to the initial state without allocating; call it after the state was reset and refilled.
    void reset();
    /// Adapts to the state's new capacity. Throws RuntimeFault if the driver has no memory.
    void onCapacityChanged() { labels_.onCapacityChanged(); }

    /// Does one small part of labelling the fragments, with about the same upper cost for any amount of metal; a whole
    /// cycle takes 26 calls, more for very much metal. Call it once a frame. Reads positions and phases; at the end of
    /// a cycle writes the fragment bits, takes free metal off the lattice and clears PHASE_FRESH.
    void relabel(gl::Profiler* profiler);

    /// Does a whole cycle at once, from its beginning.
    void relabelNow(gl::Profiler* profiler);

    /// Moves every free fragment on by `steps` times `dt` seconds: forces that others added to the velocities of its
    /// particles, gravity, contact with the floor, with fixed metal and with other fragments. Dispatches nothing once
    /// the GPU has reported zero free particles. Until then it dispatches four passes a step indirectly, of no groups
    /// while nothing is free: the time of the report changes no result.
    void move(float dt, int steps, gl::Profiler* profiler);

    /// Saves or restores all that the next step reads; transfer the state first.
    void transfer(gl::StateArchive& archive);

    /// The number of free fragments. Waits for the GPU.
    FragmentReport report() const;

    size_t bytes() const;

  private:
    void labelled();
    bool mayBeFree();
    void keepContacts(size_t free);
    void moveOnce() const;

    FragmentBlock block_{};
    const size_t mostContacts_; ///< upper limit for any amount of free metal
    bool mayBeFree_ = true;     ///< false: the GPU reported that the last cycle found nothing free
    gl::Readback freeParticles_;
    gl::Buffer blockBuffer_, motions_, contacts_;
    FragmentLabels labels_;
    const gl::Program &clearCells_, &linkCells_, &linkFree_, &contactsPass_, &rigidMotion_, &movePass_;
};

} // namespace meltpool
