#include "core/metal/rigid_fragments.hpp"

#include "core/gl/order.hpp"

#include <algorithm>

namespace meltpool {

namespace {

constexpr int kCycle = 26;             ///< calls of relabel(). None: chosen, so that labels cost little of a step
constexpr size_t kLeastContacts = 256; ///< that there is room for before the number of free particles is known
constexpr size_t kPart = 32768;        ///< slots that a call joins: a frame costs no more with more metal

void storageBarrier() {
    gl::memoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

} // namespace

RigidFragments::RigidFragments(gl::ShaderLibrary& shaders, MetalState& state, const FragmentSetup& setup)
    : state_(state),
      mostContacts_(setup.contactRoom),
      freeParticles_("number of free particles", sizeof(uint)),
      blockBuffer_("fragment block", sizeof(FragmentBlock)),
      cellHeads_(gl::Buffer::gpuOnly("fragment cell heads", state.lattice().cellCount() / 8 * 2 * sizeof(uint))),
      cellNext_(gl::Buffer::gpuOnly("fragment cell lists", state.capacity() * sizeof(uint))),
      labels_(gl::Buffer::gpuOnly("fragment labels", state.capacity() * sizeof(uint))),
      firstLabels_(gl::Buffer::gpuOnly("fragment first labels", state.capacity() * sizeof(uint))),
      control_(gl::Buffer::gpuOnly("fragment control", sizeof(FragmentControl))),
      motions_(gl::Buffer::gpuOnly("fragment motions", (FRAGMENT_MAX_COUNT + 1) * sizeof(FragmentMotion))),
      freeSlots_(gl::Buffer::gpuOnly("fragment free slots", state.capacity() * sizeof(uint))),
      latticeTexels_("fragment lattice", state.latticeSlots, GL_R32UI, sizeof(uint)),
      clearCells_(shaders.compute("metal/solid/clear_cells.comp")),
      beginLabels_(shaders.compute("metal/solid/begin_labels.comp")),
      linkCells_(shaders.compute("metal/solid/link_cells.comp")),
      linkFree_(shaders.compute("metal/solid/link_free.comp")),
      join_(shaders.compute("metal/solid/join.comp")),
      countMembers_(shaders.compute("metal/solid/count_members.comp")),
      numberFragments_(shaders.compute("metal/solid/number_fragments.comp")),
      assignFragments_(shaders.compute("metal/solid/assign_fragments.comp")),
      listFree_(shaders.compute("metal/solid/list_free.comp")),
      contactsPass_(shaders.compute("metal/solid/contacts.comp")),
      rigidMotion_(shaders.compute("metal/solid/rigid_motion.comp")),
      movePass_(shaders.compute("metal/solid/move.comp")) {
    // Slots without a label take no part: metal that comes in the middle of a cycle waits for the next one.
    labels_.fill(FRAGMENT_NO_LABEL);
    firstLabels_.fill(FRAGMENT_NO_LABEL);
    makeTexels();
    block_.coarseCells = state.lattice().cells() / 2;
    block_.low = setup.low;
    block_.high = setup.high;
    block_.floorNormal = setup.floorNormal;
    block_.floorHeight = setup.floorHeight;
    block_.friction = setup.friction;
    keepContacts(kLeastContacts);
}

void RigidFragments::reset() {
    for (const gl::Buffer* buffer : {&cellHeads_, &cellNext_, &control_, &motions_, &freeSlots_})
        buffer->clear();
    labels_.fill(FRAGMENT_NO_LABEL);
    firstLabels_.fill(FRAGMENT_NO_LABEL);
    freeParticles_.forget();
    mayBeFree_ = true;
    slots_ = joined_ = 0;
    call_ = 0;
}

void RigidFragments::makeTexels() {
    firstLabelTexels_ = gl::BufferView("fragment first labels", firstLabels_, GL_R32UI, sizeof(uint));
    positionTexels_ = gl::BufferView("fragment positions", state_.position, GL_RGBA32F, sizeof(vec4));
}

void RigidFragments::takeCapacity() {
    const size_t before = labels_.bytes(), bytes = state_.capacity() * sizeof(uint);
    for (gl::Buffer* buffer : {&cellNext_, &labels_, &firstLabels_, &freeSlots_})
        buffer->resize(bytes);
    for (const gl::Buffer* buffer : {&labels_, &firstLabels_})
        if (bytes > before) gl::fillWords(buffer->name(), before, bytes - before, FRAGMENT_NO_LABEL);
    makeTexels();
}

void RigidFragments::bind() const {
    state_.bind();
    blockBuffer_.bindUniform(FRAGMENT_BLOCK);
    cellHeads_.bindStorage(FRAGMENT_CELL_HEADS);
    cellNext_.bindStorage(FRAGMENT_CELL_NEXT);
    labels_.bindStorage(FRAGMENT_LABELS);
    firstLabels_.bindStorage(FRAGMENT_FIRST_LABELS);
    control_.bindStorage(FRAGMENT_CONTROL);
    motions_.bindStorage(FRAGMENT_MOTIONS);
    freeSlots_.bindStorage(FRAGMENT_FREE_SLOTS);
    contacts_.bindStorage(FRAGMENT_CONTACTS);
    state_.changes.bindStorage(FRAGMENT_CHANGES);
    firstLabelTexels_.bind(FRAGMENT_TEXELS_FIRST_LABEL);
    latticeTexels_.bind(FRAGMENT_TEXELS_LATTICE);
    positionTexels_.bind(FRAGMENT_TEXELS_POSITION);
}

void RigidFragments::relabel(gl::Profiler* profiler) {
    const gl::Scope scope(profiler, "fragments labelled");
    const int call = call_++;
    if (call == 0)
        begin();
    else if (joined_ < slots_)
        joinPart();
    else if (call >= kCycle - 1)
        finish();
}

void RigidFragments::relabelNow(gl::Profiler* profiler) {
    const gl::Scope scope(profiler, "fragments labelled");
    begin();
    while (joined_ < slots_)
        joinPart();
    finish();
}

void RigidFragments::begin() {
    bind();
    slots_ = state_.particles();
    joined_ = 0;
    cellHeads_.clear();
    gl::memoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    beginLabels_.dispatch(slots_, FRAGMENT_GROUP); // phases -> first labels, lists of the coarse cells
    storageBarrier();
}

void RigidFragments::joinPart() {
    bind();
    const size_t last = std::min(slots_, joined_ + kPart);
    join_.set("first", static_cast<unsigned>(joined_));
    join_.set("last", static_cast<unsigned>(last));
    join_.dispatch(last - joined_, FRAGMENT_GROUP); // first labels, positions, lists -> labels
    storageBarrier();
    joined_ = last;
}

void RigidFragments::finish() {
    bind();
    call_ = 0;
    const size_t particles = state_.particles();
    // Nothing is joined any more: the first labels' memory counts members. The next cycle labels all these slots again.
    gl::memoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    gl::fillWords(firstLabels_.name(), 0, particles * sizeof(uint), 0);
    countMembers_.dispatch(particles, FRAGMENT_GROUP);
    storageBarrier();
    numberFragments_.dispatchGroups(1);
    storageBarrier();
    assignFragments_.dispatch(particles, FRAGMENT_GROUP); // numbers, labels -> phases, list of phase changes
    storageBarrier();
    state_.noteLabelling();
    listFree_.dispatchGroups(1);
    gl::memoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
    freeParticles_.forget();
    freeParticles_.request(control_, offsetof(FragmentControl, particles));
    mayBeFree_ = true;
}

void RigidFragments::indirect(const gl::Program& program, size_t offset) const {
    program.dispatchIndirect(offset);
    storageBarrier();
}

/// Whether the last cycle may have found free particles: true until the GPU said that there are none.
bool RigidFragments::mayBeFree() {
    if (const auto particles = freeParticles_.poll<uint>()) {
        mayBeFree_ = *particles > 0;
        keepContacts(*particles);
    }
    return mayBeFree_;
}

/// Room for the contacts of so many free particles. Contacts hold within a step, so that none is kept.
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
    bind();
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, control_.name());
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

/// Whether anything is free is found again by the end of the next cycle: until then passes run that have nothing to do.
void RigidFragments::transfer(gl::StateArchive& archive) {
    archive.values(call_);
    archive.count(slots_, state_.capacity());
    archive.count(joined_, state_.capacity());
    for (const gl::Buffer* buffer : {&cellHeads_, &cellNext_, &labels_, &firstLabels_, &control_, &freeSlots_})
        archive.list(*buffer, buffer->bytes());
    archive.buffer(motions_, motions_.bytes());
    if (!archive.restores()) return;
    freeParticles_.forget();
    mayBeFree_ = true;
}

FragmentReport RigidFragments::report() const {
    const FragmentControl control = control_.read<FragmentControl>(1).front();
    return {control.particles == 0 ? 0 : control.fragments, control.particles, control.rejected};
}

size_t RigidFragments::bytes() const {
    size_t sum = 0;
    for (const gl::Buffer* buffer : {&blockBuffer_, &cellHeads_, &cellNext_, &labels_, &firstLabels_, &control_,
                                     &motions_, &freeSlots_, &contacts_})
        sum += buffer->bytes();
    return sum;
}

} // namespace meltpool
