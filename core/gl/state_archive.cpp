#include "core/gl/state_archive.hpp"

#include "core/base/error.hpp"
#include "core/gl/order.hpp"
#include "core/gl/software_driver/software_driver.hpp"

#include <algorithm>
#include <cstring>

namespace meltpool::gl {

namespace {

[[noreturn]] void refuse(const std::string& found) {
    throw InputError("the saved state " + found + "; expected one of this lesson, saved by this program");
}

} // namespace

StateArchive::StateArchive(StateParts& into) : numbers_(&into.numbers), parts_(&into) {}

StateArchive::StateArchive(std::span<const std::byte> from) : from_(from) {
    memoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT); // the copy overwrites bytes that shaders wrote
}

std::span<const std::byte> StateArchive::take(size_t bytes) {
    if (bytes > from_.size() - at_)
        refuse("ends after " + std::to_string(from_.size()) + " bytes, in the middle of a value");
    const auto taken = from_.subspan(at_, bytes);
    at_ += bytes;
    return taken;
}

void StateArchive::plain(void* data, size_t bytes) {
    if (restores()) {
        std::memcpy(data, take(bytes).data(), bytes);
        return;
    }
    const auto* first = static_cast<const std::byte*>(data);
    numbers_->insert(numbers_->end(), first, first + bytes);
    if (parts_ == nullptr) return;
    if (parts_->parts.empty() || parts_->parts.back().onGpu) parts_->parts.push_back({});
    parts_->parts.back().bytes += bytes;
}

void StateArchive::value(bool& each) {
    auto byte = static_cast<std::uint8_t>(each);
    plain(&byte, 1);
    if (byte > 1) refuse("has " + std::to_string(byte) + " in place of yes or no");
    each = byte != 0;
}

void StateArchive::count(size_t& number, size_t most) {
    std::uint64_t wide = number;
    plain(&wide, sizeof wide);
    if (restores() && wide > most)
        refuse("counts " + std::to_string(wide) + ", above the limit of " + std::to_string(most));
    number = static_cast<size_t>(wide);
}

void StateArchive::text(std::string& words) {
    size_t length = words.size();
    count(length, restores() ? from_.size() : length);
    if (restores()) {
        const auto letters = take(length);
        words.assign(reinterpret_cast<const char*>(letters.data()), letters.size());
    } else {
        plain(words.data(), length);
    }
}

/// Makes no OpenGL objects on a BarrierFreeThread: the archive, which ends on another thread, would have to delete
/// them.
void StateArchive::copyTo(const Buffer& buffer, size_t bytes, size_t begin) {
    if (writeDirectly(buffer.name(), from_.data() + begin, bytes, 0)) return;
    if (!upload_) upload_.emplace("restored state", from_);
    upload_->copyTo(buffer, bytes, begin);
}

void StateArchive::region(GLuint buffer, const StatePart& as) {
    if (parts_ == nullptr) throw RuntimeFault("a saved state of numbers cannot hold a GPU buffer");
    parts_->parts.push_back(as);
    parts_->parts.back().onGpu = true;
    parts_->regions.push_back({buffer, as.bytes, directMemory(buffer)});
}

void StateArchive::part(const Buffer& buffer, const StatePart& as) {
    const size_t bytes = as.bytes;
    size_t size = bytes;
    count(size, bytes);
    if (!restores()) {
        if (bytes > buffer.bytes()) throw RuntimeFault("a saved state cannot hold more bytes than its GPU buffer has");
        return region(buffer.name(), as);
    }
    if (size != bytes || bytes > buffer.bytes())
        refuse("has " + std::to_string(size) + " bytes for a buffer of " + std::to_string(bytes));
    const size_t begin = at_;
    take(bytes);
    copyTo(buffer, bytes, begin);
    if (bytes < buffer.bytes()) fillWords(buffer.name(), bytes, buffer.bytes() - bytes, 0);
}

void StateArchive::answer(Readback& readback, Buffer& source) {
    bool asked = readback.pending();
    value(asked);
    const size_t bytes = readback.bytes();
    if (!restores()) {
        if (asked) region(readback.name(), {bytes});
        return;
    }
    readback.forget();
    if (!asked) return;
    const size_t begin = at_;
    take(bytes);
    copyTo(source, bytes, begin);
    readback.request(source);
}

StateCapture::~StateCapture() {
    forget();
}

void StateCapture::forget() {
    if (fence_ != nullptr) glDeleteSync(fence_);
    fence_ = nullptr;
    arrived_ = false;
}

StateParts& StateCapture::begin() {
    forget();
    state_.numbers.clear();
    state_.parts.clear();
    state_.regions.clear();
    return state_;
}

/// Reserves spare memory, because a metal grows while it is fed.
void StateCapture::reserve(size_t bytes) {
    if (bytes <= capacity_) return;
    const size_t reserved = bytes + bytes / 4;
    GLuint name = 0;
    glCreateBuffers(1, &name);
    copy_ = Handle<destroy>(name);
    labelObject(GL_BUFFER, name, "copy of a state");
    constexpr GLbitfield kFlags = GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    glNamedBufferStorage(name, static_cast<GLsizeiptr>(reserved), nullptr, kFlags | GL_CLIENT_STORAGE_BIT);
    mapped_ = glMapNamedBufferRange(name, 0, static_cast<GLsizeiptr>(reserved), kFlags);
    capacity_ = mapped_ == nullptr ? 0 : reserved;
    if (mapped_ == nullptr)
        throw RuntimeFault("the graphics driver has no room for " + std::to_string(reserved >> 20) +
                           " MiB of a saved state; use fewer particles");
}

void StateCapture::request() {
    const std::vector<StateParts::Region>& regions = state_.regions;
    const bool inMemory = std::all_of(regions.begin(), regions.end(),
                                      [](const StateParts::Region& region) { return region.memory != nullptr; });
    if (inMemory)
        copyMemory();
    else
        copyBuffers();
}

void StateCapture::copyMemory() {
    size_t bytes = 0;
    for (const StateParts::Region& region : state_.regions)
        bytes += region.bytes;
    if (memory_.capacity() < bytes) memory_.reserve(bytes + bytes / 4);
    memory_.clear();
    for (const StateParts::Region& region : state_.regions)
        memory_.insert(memory_.end(), region.memory, region.memory + region.bytes);
    copied_ = memory_.data();
    arrived_ = true;
}

void StateCapture::copyBuffers() {
    size_t bytes = 0;
    for (const StateParts::Region& region : state_.regions)
        bytes += region.bytes;
    reserve(bytes);
    memoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_CLIENT_MAPPED_BUFFER_BARRIER_BIT);
    size_t to = 0;
    for (const StateParts::Region& region : state_.regions) {
        copyBytes(region.buffer, copy_.name(), region.bytes, 0, to);
        to += region.bytes;
    }
    copied_ = static_cast<const std::byte*>(mapped_);
    fence_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

bool StateCapture::arrived() {
    if (fence_ == nullptr) return arrived_;
    const GLenum state = glClientWaitSync(fence_, GL_SYNC_FLUSH_COMMANDS_BIT, 0);
    if (state != GL_ALREADY_SIGNALED && state != GL_CONDITION_SATISFIED) return false;
    forget();
    return arrived_ = true;
}

void StateCapture::wait() {
    constexpr GLuint64 kPatience = 1'000'000'000; // ns
    while (fence_ != nullptr && glClientWaitSync(fence_, GL_SYNC_FLUSH_COMMANDS_BIT, kPatience) == GL_TIMEOUT_EXPIRED) {
    }
    if (fence_ == nullptr) return;
    forget();
    arrived_ = true;
}

void StateCapture::assemble(std::vector<std::byte>& bytes, std::vector<StatePart>& parts) const {
    if (!arrived_) throw RuntimeFault("a saved state was to be read before it came from the GPU");
    parts = state_.parts;
    size_t all = 0;
    for (const StatePart& part : parts)
        all += part.bytes;
    bytes.resize(all);
    std::byte* to = bytes.data();
    const std::byte* number = state_.numbers.data();
    const std::byte* copied = copied_;
    for (StatePart& part : parts) {
        const std::byte*& from = part.onGpu ? copied : number;
        if (part.bytes > 0) std::memcpy(to, from, part.bytes);
        from += part.bytes;
        to += part.bytes;
        part.onGpu = false;
    }
}

} // namespace meltpool::gl
