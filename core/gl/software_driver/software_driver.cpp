#include "core/gl/software_driver/software_driver.hpp"

#include <array>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <thread>

namespace meltpool::gl {

namespace {

constexpr const char* kThreadsKey = "LP_NUM_THREADS";

/// The first version that takes a fifth to a third less time for welds and pictures.
constexpr int kFastMesa = 25;

/// Short enough that only the objects of a few lessons wait for deletion.
constexpr std::chrono::seconds kBetweenFlushes{10};

thread_local bool withoutBarriers = false;

} // namespace

bool drawsOnProcessor(std::string_view renderer) {
    for (const char* name : {"llvmpipe", "softpipe", "swrast", "SwiftShader"})
        if (renderer.find(name) != std::string_view::npos) return true;
    return false;
}

bool isProcessorDevice(const char* extensions) {
    return extensions != nullptr && std::strstr(extensions, "EGL_MESA_device_software") != nullptr;
}

bool dispatchIsSynchronous() {
    const GLubyte* renderer = glGetString(GL_RENDERER);
    return renderer != nullptr &&
           std::string_view(reinterpret_cast<const char*>(renderer)).find("llvmpipe") != std::string_view::npos;
}

void runDriverSingleThreaded() {
#ifdef __linux__
    if (std::thread::hardware_concurrency() <= 2) setenv(kThreadsKey, "0", 0);
#endif
}

bool driverIsSingleThreaded() {
    const char* threads = std::getenv(kThreadsKey);
    return threads != nullptr && std::string_view(threads) == "0";
}

BarrierFreeThread::BarrierFreeThread() {
    withoutBarriers = true;
}

BarrierFreeThread::~BarrierFreeThread() {
    withoutBarriers = false;
}

void BarrierFreeThread::freeDeleted() {
    const auto now = std::chrono::steady_clock::now();
    if (now - flushed_ < kBetweenFlushes) return;
    flushed_ = now;
    glFlush();
}

bool barrierFree() {
    return withoutBarriers;
}

GLbitfield directStorage() {
    return dispatchIsSynchronous() ? GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT : 0;
}

// Such a driver maps the buffer's own memory, which may be read too. A mapping for reading could not be unsynchronized,
// and the driver searches pictures for buffers that are synchronized.
void mapDirectly(GLuint buffer, size_t bytes) {
    if (const GLbitfield flags = directStorage(); flags != 0)
        glMapNamedBufferRange(buffer, 0, static_cast<GLsizeiptr>(bytes), flags | GL_MAP_UNSYNCHRONIZED_BIT);
}

std::byte* directMemory(GLuint buffer) {
    if (!withoutBarriers) return nullptr;
    void* memory = nullptr;
    glGetNamedBufferPointerv(buffer, GL_BUFFER_MAP_POINTER, &memory);
    return static_cast<std::byte*>(memory);
}

bool copyDirectly(GLuint from, GLuint to, size_t bytes, size_t fromOffset, size_t toOffset) {
    const std::byte* source = directMemory(from);
    std::byte* target = directMemory(to);
    if (source == nullptr || target == nullptr) return false;
    std::memmove(target + toOffset, source + fromOffset, bytes);
    return true;
}

bool fillDirectly(GLuint buffer, size_t offset, size_t bytes, GLuint word) {
    std::byte* memory = directMemory(buffer);
    if (memory == nullptr) return false;
    for (size_t at = offset; at < offset + bytes; at += sizeof word)
        std::memcpy(memory + at, &word, sizeof word);
    return true;
}

bool writeDirectly(GLuint buffer, const void* data, size_t bytes, size_t offset) {
    std::byte* memory = directMemory(buffer);
    if (memory == nullptr) return false;
    if (bytes > 0) std::memcpy(memory + offset, data, bytes);
    return true;
}

bool readDirectly(GLuint buffer, void* data, size_t bytes, size_t offset) {
    const std::byte* memory = directMemory(buffer);
    if (memory == nullptr) return false;
    if (bytes > 0) std::memcpy(data, memory + offset, bytes);
    return true;
}

bool dispatchDirectly(size_t offset) {
    GLint counts = 0;
    if (withoutBarriers) glGetIntegerv(GL_DISPATCH_INDIRECT_BUFFER_BINDING, &counts);
    std::array<GLuint, 3> groups{};
    if (counts == 0 || !readDirectly(static_cast<GLuint>(counts), groups.data(), sizeof groups, offset)) return false;
    glDispatchCompute(groups[0], groups[1], groups[2]);
    return true;
}

int mesaMajor(std::string_view version) {
    constexpr std::string_view kName = "Mesa ";
    const size_t at = version.find(kName);
    int major = 0;
    if (at != std::string_view::npos)
        std::from_chars(version.data() + at + kName.size(), version.data() + version.size(), major);
    return major;
}

std::optional<DriverAdvice> newerDriver(std::string_view renderer, std::string_view version) {
    const int major = mesaMajor(version);
    if (!drawsOnProcessor(renderer) || major == 0 || major >= kFastMesa) return std::nullopt;
    return DriverAdvice{"age of the software driver", "Mesa " + std::to_string(major) + ": a newer one is faster",
                        "Mesa " + std::to_string(kFastMesa) + ", as Debian 13 has it"};
}

} // namespace meltpool::gl
