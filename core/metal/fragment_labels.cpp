#include "core/metal/fragment_labels.hpp"

#include "core/gl/order.hpp"

#include <algorithm>

namespace meltpool {

namespace {

constexpr int kCycle = 26;      ///< calls of advance(). None: chosen, so that labels cost little of a step
constexpr size_t kPart = 32768; ///< slots that a call joins: the cost of a frame does not grow with the metal

void storageBarrier() {
    gl::memoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

} // namespace

FragmentLabels::FragmentLabels(gl::ShaderLibrary& shaders, MetalState& state, const gl::Buffer& block)
    : state_(state),
      block_(block),
      cellHeads_(gl::Buffer::gpuOnly("fragment cell heads", state.lattice().cellCount() / 8 * 2 * sizeof(uint))),
      cellNext_(gl::Buffer::gpuOnly("fragment cell lists", state.capacity() * sizeof(uint))),
      labels_(gl::Buffer::gpuOnly("fragment labels", state.capacity() * sizeof(uint))),
      firstLabels_(gl::Buffer::gpuOnly("fragment first labels", state.capacity() * sizeof(uint))),
      control_(gl::Buffer::gpuOnly("fragment control", sizeof(FragmentControl))),
      freeSlots_(gl::Buffer::gpuOnly("fragment free slots", state.capacity() * sizeof(uint))),
      latticeTexels_("fragment lattice", state.latticeSlots, GL_R32UI, sizeof(uint)),
      beginLabels_(shaders.compute("metal/solid/begin_labels.comp")),
      join_(shaders.compute("metal/solid/join.comp")),
      countMembers_(shaders.compute("metal/solid/count_members.comp")),
      numberFragments_(shaders.compute("metal/solid/number_fragments.comp")),
      assignFragments_(shaders.compute("metal/solid/assign_fragments.comp")),
      listFree_(shaders.compute("metal/solid/list_free.comp")) {
    // Slots without a label take no part: metal that arrives during a cycle waits for the next one.
    labels_.fill(FRAGMENT_NO_LABEL);
    firstLabels_.fill(FRAGMENT_NO_LABEL);
    makeTexels();
}

void FragmentLabels::reset() {
    for (const gl::Buffer* buffer : {&cellHeads_, &cellNext_, &control_, &freeSlots_})
        buffer->clear();
    labels_.fill(FRAGMENT_NO_LABEL);
    firstLabels_.fill(FRAGMENT_NO_LABEL);
    slots_ = joined_ = 0;
    call_ = 0;
}

void FragmentLabels::makeTexels() {
    firstLabelTexels_ = gl::BufferView("fragment first labels", firstLabels_, GL_R32UI, sizeof(uint));
    positionTexels_ = gl::BufferView("fragment positions", state_.position, GL_RGBA32F, sizeof(vec4));
}

void FragmentLabels::onCapacityChanged() {
    const size_t before = labels_.bytes(), bytes = state_.capacity() * sizeof(uint);
    for (gl::Buffer* buffer : {&cellNext_, &labels_, &firstLabels_, &freeSlots_})
        buffer->resize(bytes);
    for (const gl::Buffer* buffer : {&labels_, &firstLabels_})
        if (bytes > before) gl::fillWords(buffer->name(), before, bytes - before, FRAGMENT_NO_LABEL);
    makeTexels();
}

void FragmentLabels::bind() const {
    state_.bind();
    block_.bindUniform(FRAGMENT_BLOCK);
    cellHeads_.bindStorage(FRAGMENT_CELL_HEADS);
    cellNext_.bindStorage(FRAGMENT_CELL_NEXT);
    labels_.bindStorage(FRAGMENT_LABELS);
    firstLabels_.bindStorage(FRAGMENT_FIRST_LABELS);
    control_.bindStorage(FRAGMENT_CONTROL);
    freeSlots_.bindStorage(FRAGMENT_FREE_SLOTS);
    state_.changes.bindStorage(FRAGMENT_CHANGES);
    firstLabelTexels_.bind(FRAGMENT_TEXELS_FIRST_LABEL);
    latticeTexels_.bind(FRAGMENT_TEXELS_LATTICE);
    positionTexels_.bind(FRAGMENT_TEXELS_POSITION);
}

bool FragmentLabels::advance() {
    const int call = call_++;
    if (call == 0) {
        begin();
    } else if (joined_ < slots_) {
        joinPart();
    } else if (call >= kCycle - 1) {
        finish();
        return true;
    }
    return false;
}

void FragmentLabels::cycleNow() {
    begin();
    while (joined_ < slots_)
        joinPart();
    finish();
}

void FragmentLabels::begin() {
    bind();
    slots_ = state_.particles();
    joined_ = 0;
    cellHeads_.clear();
    gl::memoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    beginLabels_.dispatch(slots_, FRAGMENT_GROUP); // phases -> first labels, lists of the coarse cells
    storageBarrier();
}

void FragmentLabels::joinPart() {
    bind();
    const size_t last = std::min(slots_, joined_ + kPart);
    join_.set("first", static_cast<unsigned>(joined_));
    join_.set("last", static_cast<unsigned>(last));
    join_.dispatch(last - joined_, FRAGMENT_GROUP); // first labels, positions, lists -> labels
    storageBarrier();
    joined_ = last;
}

void FragmentLabels::finish() {
    bind();
    call_ = 0;
    const size_t particles = state_.particles();
    // After joining, the first labels' memory counts members. The next cycle labels all these slots again.
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
}

void FragmentLabels::transfer(gl::StateArchive& archive) {
    archive.values(call_);
    archive.count(slots_, state_.capacity());
    archive.count(joined_, state_.capacity());
    for (const gl::Buffer* buffer : {&cellHeads_, &cellNext_, &labels_, &firstLabels_, &control_, &freeSlots_})
        archive.list(*buffer, buffer->bytes());
}

size_t FragmentLabels::bytes() const {
    size_t sum = 0;
    for (const gl::Buffer* buffer : {&cellHeads_, &cellNext_, &labels_, &firstLabels_, &control_, &freeSlots_})
        sum += buffer->bytes();
    return sum;
}

} // namespace meltpool
