// Solid metal cut free of every clamp: labels the connected fragments, lets the free ones fall, rest and tip over as
// rigid bodies, and joins them again where they freeze together.
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
    float floorHeight = 0;          ///< m along the normal, the level that nothing falls through
    float friction = 0.35F;         ///< metal on metal, Coulomb, no unit
    /// Free particles whose contacts are kept at most, 64 B each. Those of more are found twice: slower, with the same
    /// result.
    unsigned contactRoom = 8192;
    glm::vec3 low{-1e3F}; ///< m, the space whose sides no fragment leaves
    glm::vec3 high{1e3F}; ///< m
};

/// How many fragments are free at the moment.
struct FragmentReport {
    unsigned fragments = 0; ///< free ones
    unsigned particles = 0; ///< in free ones
    unsigned rejected = 0;  ///< free ones beyond FRAGMENT_MAX_COUNT: they stand still
};

/// Moves the fragments that FragmentLabels finds free.
class RigidFragments {
  public:
    /// `state` must outlive this object.
    RigidFragments(gl::ShaderLibrary& shaders, MetalState& state, const FragmentSetup& setup);
    RigidFragments(const RigidFragments&) = delete; // its labels read its block
    RigidFragments& operator=(const RigidFragments&) = delete;

    /// As new, in the same memory, for a state that was reset and has its particles again.
    void reset();
    /// After the state's capacity became another one. Throws RuntimeFault when the driver has no room.
    void takeCapacity() { labels_.takeCapacity(); }

    /// One small part of labelling the fragments, at most about the same for any amount of metal; a whole cycle takes
    /// 26 calls, more where there is very much metal. Call it once a frame. Reads positions and phases; at the end of a
    /// cycle writes the fragment bits, takes free metal off the lattice and clears PHASE_FRESH.
    void relabel(gl::Profiler* profiler);

    /// A whole cycle at once, from its beginning.
    void relabelNow(gl::Profiler* profiler);

    /// Moves every free fragment on by `steps` times `dt` seconds: forces that others added to the velocities of its
    /// particles, gravity, contact with the floor, with fixed metal and with other fragments. Dispatches nothing once
    /// the number of free particles has come back from the GPU as zero. Until then, four passes a step of as many
    /// groups as are needed, which are none while nothing is free: when the number arrives changes no result.
    void move(float dt, int steps, gl::Profiler* profiler);

    /// Saves or restores all that the next step reads; the state comes before it.
    void transfer(gl::StateArchive& archive);

    /// Waits for the GPU.
    FragmentReport report() const;

    size_t bytes() const;

  private:
    void labelled();
    bool mayBeFree();
    void keepContacts(size_t free);
    void moveOnce() const;

    FragmentBlock block_{};
    const size_t mostContacts_; ///< that are kept however much metal is free
    bool mayBeFree_ = true;     ///< false: the GPU said that the last cycle found nothing free
    gl::Readback freeParticles_;
    gl::Buffer blockBuffer_, motions_, contacts_;
    FragmentLabels labels_;
    const gl::Program &clearCells_, &linkCells_, &linkFree_, &contactsPass_, &rigidMotion_, &movePass_;
};

} // namespace meltpool
