#include "core/gl/readback.hpp"

#include "core/base/error.hpp"
#include "core/gl/order.hpp"

#include <cstring>
#include <string>

namespace meltpool::gl {

Readback::Readback(std::string_view label, size_t bytes) : bytes_(bytes) {
    GLuint name = 0;
    glCreateBuffers(1, &name);
    handle_ = Handle<destroy>(name);
    labelObject(GL_BUFFER, name, label);
    constexpr GLbitfield kFlags = GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    glNamedBufferStorage(name, static_cast<GLsizeiptr>(bytes), nullptr, kFlags | GL_CLIENT_STORAGE_BIT);
    mapped_ = glMapNamedBufferRange(name, 0, static_cast<GLsizeiptr>(bytes), kFlags);
    if (mapped_ == nullptr)
        throw RuntimeFault("the graphics driver cannot map the buffer '" + std::string(label) + "'");
}

Readback::~Readback() {
    forget();
}

void Readback::forget() {
    if (fence_ != nullptr) glDeleteSync(fence_);
    fence_ = nullptr;
    asked_ = false;
}

void Readback::request(const Buffer& source, size_t offset) {
    if (asked_) return;
    if (offset + bytes_ > source.bytes())
        throw RuntimeFault("a read of " + std::to_string(bytes_) + " bytes from byte " + std::to_string(offset) +
                           " on reaches past the end of a GPU buffer of " + std::to_string(source.bytes()) + " bytes");
    memoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_CLIENT_MAPPED_BUFFER_BARRIER_BIT);
    copyBytes(source.name(), handle_.name(), bytes_, offset, 0);
    fence_ = fence();
    asked_ = true;
}

const void* Readback::pollInPlace() {
    if (!asked_) return nullptr;
    if (fence_ != nullptr) {
        // Flushes, because the commands might not start while nothing else is drawn.
        const GLenum state = glClientWaitSync(fence_, GL_SYNC_FLUSH_COMMANDS_BIT, 0);
        if (state != GL_ALREADY_SIGNALED && state != GL_CONDITION_SATISFIED) return nullptr;
    }
    forget();
    return mapped_;
}

void Readback::wait() const {
    constexpr GLuint64 kPatience = 1'000'000'000; // ns
    if (fence_ == nullptr || glClientWaitSync(fence_, GL_SYNC_FLUSH_COMMANDS_BIT, 0) != GL_TIMEOUT_EXPIRED) return;
    while (fence_ != nullptr && glClientWaitSync(fence_, GL_SYNC_FLUSH_COMMANDS_BIT, kPatience) == GL_TIMEOUT_EXPIRED) {
    }
}

bool Readback::take(void* target, size_t bytes) {
    const void* answer = pollInPlace();
    if (answer == nullptr) return false;
    std::memcpy(target, answer, bytes);
    return true;
}

ReadbackQueue::ReadbackQueue(std::string_view label, size_t bytes, size_t depth) : bytes_(bytes * depth) {
    for (size_t i = 0; i < depth; ++i)
        slots_.push_back(std::make_unique<Readback>(label, bytes));
}

void ReadbackQueue::request(const Buffer& source) {
    if (full())
        throw RuntimeFault("more than " + std::to_string(slots_.size()) + " reads of a GPU buffer are under way");
    slots_[(oldest_ + pending_) % slots_.size()]->request(source);
    ++pending_;
}

const void* ReadbackQueue::pollInPlace() {
    if (pending_ == 0) return nullptr;
    const void* answer = slots_[oldest_]->pollInPlace();
    if (answer == nullptr) return nullptr;
    oldest_ = (oldest_ + 1) % slots_.size();
    --pending_;
    return answer;
}

const void* ReadbackQueue::awaitInPlace() {
    if (pending_ > 0) slots_[oldest_]->wait();
    return pollInPlace();
}

void ReadbackQueue::forget() {
    for (const auto& slot : slots_)
        slot->forget();
    pending_ = 0;
}

} // namespace meltpool::gl
