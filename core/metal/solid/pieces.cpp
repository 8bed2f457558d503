#include "core/metal/solid/pieces.hpp"

#include <algorithm>

namespace meltpool {

namespace {

constexpr unsigned kLabelGroups = 16;
constexpr size_t kPart = 32768; ///< slots that a call looks at in a round: a frame costs no more with more metal

void storageBarrier() {
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

} // namespace

SolidPieces::SolidPieces(gl::ShaderLibrary& shaders, MetalState& state, const PieceSetup& setup)
    : state_(state),
      blockBuffer_("pieces block", sizeof(PiecesBlock)),
      heads_("pieces coarse cells", state.lattice().cellCount() / 8 * sizeof(uint)),
      next_("pieces chains", state.capacity() * sizeof(uint)),
      labels_("pieces labels", state.capacity() * sizeof(uint)),
      relabels_("pieces next labels", state.capacity() * sizeof(uint)),
      tally_("pieces tally", state.capacity() * sizeof(uint)),
      numbers_("pieces numbers", state.capacity() * sizeof(uint)),
      control_("pieces control", sizeof(PiecesControl)),
      motion_("pieces motion", (PIECES_MOST + 1) * sizeof(PieceMotion)),
      loose_("pieces loose list", state.capacity() * sizeof(uint)),
      contacts_("pieces contacts", state.capacity() * sizeof(PieceContact)),
      labelTexels_("pieces labels", labels_, GL_R32UI, sizeof(uint)),
      relabelTexels_("pieces next labels", relabels_, GL_R32UI, sizeof(uint)),
      latticeTexels_("pieces lattice", state.latticeSlots, GL_R32UI, sizeof(uint)),
      positionTexels_("pieces positions", state.position, GL_RGBA32F, sizeof(vec4)),
      clear_(shaders.compute("metal/solid/clear.comp")),
      beginLink_(shaders.compute("metal/solid/link.comp", {{"BEGIN", "1"}})),
      link_(shaders.compute("metal/solid/link.comp")),
      label_(shaders.compute("metal/solid/label.comp")),
      tallyUp_(shaders.compute("metal/solid/tally.comp")),
      number_(shaders.compute("metal/solid/number.comp")),
      assign_(shaders.compute("metal/solid/assign.comp")),
      list_(shaders.compute("metal/solid/list.comp")),
      contact_(shaders.compute("metal/solid/contact.comp")),
      gather_(shaders.compute("metal/solid/gather.comp")),
      advance_(shaders.compute("metal/solid/move.comp")) {
    // Metal that comes in the middle of a cycle waits for the next one.
    labels_.fill(PIECE_NONE);
    relabels_.fill(PIECE_NONE);
    block_.coarse = ivec4(state.lattice().cells() / 2, 0);
    block_.step = vec4(0, setup.floorHeight, setup.friction, 0);
    blockBuffer_.writeValue(block_);
}

void SolidPieces::bind() const {
    state_.bind();
    blockBuffer_.bindUniform(PIECES_BLOCK);
    heads_.bindStorage(PIECES_HEADS);
    next_.bindStorage(PIECES_NEXT);
    labels_.bindStorage(PIECES_LABEL);
    relabels_.bindStorage(PIECES_RELABEL);
    tally_.bindStorage(PIECES_TALLY);
    numbers_.bindStorage(PIECES_NUMBER);
    control_.bindStorage(PIECES_CONTROL);
    motion_.bindStorage(PIECES_MOTION);
    loose_.bindStorage(PIECES_LOOSE);
    contacts_.bindStorage(PIECES_CONTACT);
    labelTexels_.bind(PIECES_TEXELS_LABEL);
    latticeTexels_.bind(PIECES_TEXELS_LATTICE);
    positionTexels_.bind(PIECES_TEXELS_POSITION);
}

void SolidPieces::relabel(gl::Profiler* profiler) {
    const gl::Scope scope(profiler, "pieces");
    bind();
    if (stage_ == 0)
        begin();
    else if (stage_ <= PIECES_ROUNDS)
        partOfRound(static_cast<unsigned>(stage_));
    else
        finish();
    if (done_ < slots_) return; // the rest of the round is for the next calls
    stage_ = (stage_ + 1) % (PIECES_ROUNDS + 2);
    done_ = 0;
}

void SolidPieces::relabelNow(gl::Profiler* profiler) {
    stage_ = 0;
    done_ = 0;
    do
        relabel(profiler);
    while (stage_ != 0 || done_ != 0);
}

void SolidPieces::begin() {
    slots_ = state_.particles();
    heads_.clear();
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    beginLink_.dispatch(slots_, PIECES_GROUP);
    storageBarrier();
    done_ = slots_;
}

void SolidPieces::partOfRound(unsigned round) {
    if (done_ == 0) {
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        labels_.copyTo(relabels_, slots_ * sizeof(uint));
    }
    const size_t last = std::min(slots_, done_ + kPart);
    label_.set("round_", round);
    label_.set("first", static_cast<unsigned>(done_));
    label_.set("last", static_cast<unsigned>(last));
    label_.dispatchGroups(kLabelGroups);
    storageBarrier();
    done_ = last;
    if (done_ < slots_) return;
    std::swap(labels_, relabels_);
    std::swap(labelTexels_, relabelTexels_);
}

void SolidPieces::finish() {
    done_ = slots_;
    tallyUp_.dispatch(state_.particles(), PIECES_GROUP);
    storageBarrier();
    number_.dispatchGroups(1);
    storageBarrier();
    assign_.dispatch(state_.particles(), PIECES_GROUP);
    storageBarrier();
    state_.noteRegrouping();
    list_.dispatchGroups(1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
}

void SolidPieces::indirect(const gl::Program& program, size_t offset) const {
    program.dispatchIndirect(offset);
    storageBarrier();
}

void SolidPieces::move(float dt, int steps, gl::Profiler* profiler) {
    const gl::Scope scope(profiler, "loose pieces");
    if (block_.step.x != dt) {
        block_.step.x = dt;
        blockBuffer_.writeValue(block_);
    }
    bind();
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, control_.name());
    for (int i = 0; i < steps; ++i)
        moveOnce();
}

void SolidPieces::moveOnce() const {
    indirect(clear_, offsetof(PiecesControl, cellGroups));
    indirect(link_, offsetof(PiecesControl, slotGroups));
    indirect(contact_, offsetof(PiecesControl, looseGroups));
    indirect(gather_, offsetof(PiecesControl, pieceGroups));
    indirect(advance_, offsetof(PiecesControl, looseGroups));
}

PieceReport SolidPieces::report() const {
    const PiecesControl control = control_.read<PiecesControl>(1).front();
    return {control.loose == 0 ? 0 : control.pieces, control.loose, control.rejected};
}

size_t SolidPieces::bytes() const {
    return heads_.bytes() + next_.bytes() + labels_.bytes() + relabels_.bytes() + tally_.bytes() + numbers_.bytes() +
           control_.bytes() + motion_.bytes() + loose_.bytes() + contacts_.bytes();
}

} // namespace meltpool
