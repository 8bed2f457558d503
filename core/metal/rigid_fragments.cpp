#include "core/metal/rigid_fragments.hpp"

#include "core/gl/order.hpp"

#include <algorithm>

namespace meltpool {

namespace {

constexpr size_t kLeastContacts = 256; ///< capacity before the number of free particles is known

void indirect(const gl::Program& program, size_t offset) {
    program.dispatchIndirect(offset);
    gl::memoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

} // namespace

RigidFragments::RigidFragments(gl::ShaderLibrary& shaders, MetalState& state, const FragmentSetup& setup)
    : mostContacts_(setup.contactRoom),
      freeParticles_("number of free particles", sizeof(uint)),
      blockBuffer_("fragment block", sizeof(FragmentBlock)),
      motions_(gl::Buffer::gpuOnly("fragment motions", (FRAGMENT_MAX_COUNT + 1) * sizeof(FragmentMotion))),
      labels_(shaders, state, blockBuffer_),
      clearCells_(shaders.compute("metal/solid/clear_cells.comp")),
      linkCells_(shaders.compute("metal/solid/link_cells.comp")),
      linkFree_(shaders.compute("metal/solid/link_free.comp")),
      contactsPass_(shaders.compute("metal/solid/contacts.comp")),
      rigidMotion_(shaders.compute("metal/solid/rigid_motion.comp")),
      movePass_(shaders.compute("metal/solid/move.comp")) {
    block_.coarseCells = state.lattice().cells() / 2;
    block_.low = setup.low;
    block_.high = setup.high;
    block_.floorNormal = setup.floorNormal;
    block_.floorHeight = setup.floorHeight;
    block_.friction = setup.friction;
    keepContacts(kLeastContacts);
}

void RigidFragments::reset() {
    labels_.reset();
    motions_.clear();
    freeParticles_.forget();
    mayBeFree_ = true;
}

void RigidFragments::relabel(gl::Profiler* profiler) {
    const gl::Scope scope(profiler, "fragments labelled");
    if (labels_.advance()) labelled();
}

void RigidFragments::relabelNow(gl::Profiler* profiler) {
    const gl::Scope scope(profiler, "fragments labelled");
    labels_.cycleNow();
    labelled();
}

/// Requests the number of free particles that the cycle found.
void RigidFragments::labelled() {
    freeParticles_.forget();
    freeParticles_.request(labels_.control(), offsetof(FragmentControl, particles));
    mayBeFree_ = true;
}

/// True until the GPU reports that the last cycle found no free particles.
bool RigidFragments::mayBeFree() {
    if (const auto particles = freeParticles_.poll<uint>()) {
        mayBeFree_ = *particles > 0;
        keepContacts(*particles);
    }
    return mayBeFree_;
}

/// Provides capacity for the contacts of `free` particles. Contacts hold within a step, so none is copied.
void RigidFragments::keepContacts(size_t free) {
    const size_t wanted = std::min(std::max(free, kLeastContacts), mostContacts_);
    if (contacts_ && wanted <= block_.contactRoom) return;
    contacts_ = gl::Buffer::gpuOnly("fragment contacts", wanted * sizeof(FragmentContact));
    block_.contactRoom = static_cast<uint>(wanted);
    blockBuffer_.writeValue(block_);
}

void RigidFragments::move(float dt, int steps, gl::Profiler* profiler) {
    if (!mayBeFree()) return;
    const gl::Scope scope(profiler, "free fragments");
    if (block_.timeStep != dt) {
        block_.timeStep = dt;
        blockBuffer_.writeValue(block_);
    }
    labels_.bind();
    motions_.bindStorage(FRAGMENT_MOTIONS);
    contacts_.bindStorage(FRAGMENT_CONTACTS);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, labels_.control().name());
    indirect(clearCells_, offsetof(FragmentControl, cellGroups)); // -> empty lists and counts of contacts
    indirect(linkCells_, offsetof(FragmentControl, slotGroups));  // positions -> lists of the coarse cells
    for (int i = 0; i < steps; ++i)
        moveOnce();
}

void RigidFragments::moveOnce() const {
    indirect(contactsPass_, offsetof(FragmentControl, particleGroups)); // positions, velocities -> contacts
    indirect(rigidMotion_, offsetof(FragmentControl, fragmentGroups));  // contacts -> motions
    indirect(movePass_, offsetof(FragmentControl, particleGroups));     // motions -> positions, velocities, empty lists
    indirect(linkFree_, offsetof(FragmentControl, particleGroups));     // positions -> lists of the free
}

/// Restores as possibly free: passes run without work until the end of the next cycle counts the free particles.
void RigidFragments::transfer(gl::StateArchive& archive) {
    labels_.transfer(archive);
    archive.buffer(motions_, motions_.bytes());
    if (!archive.restores()) return;
    freeParticles_.forget();
    mayBeFree_ = true;
}

FragmentReport RigidFragments::report() const {
    const FragmentControl control = labels_.control().read<FragmentControl>(1).front();
    return {control.particles == 0 ? 0 : control.fragments, control.particles, control.rejected};
}

size_t RigidFragments::bytes() const {
    return blockBuffer_.bytes() + motions_.bytes() + contacts_.bytes() + labels_.bytes();
}

} // namespace meltpool
