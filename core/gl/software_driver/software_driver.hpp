// All code for a driver that draws on the processor without a card: Mesa's llvmpipe. With a card's driver every
// function here returns false or does nothing. Shaders mark lines that serve it alone with SYNCHRONOUS_DRIVER.
#pragma once

#include <GL/glew.h>

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace meltpool::gl {

/// True for the name (GL_RENDERER) of a driver that draws on the processor.
bool drawsOnProcessor(std::string_view renderer);

/// True for the extensions of an EGL device that is the processor and no card; null: it has none.
bool isProcessorDevice(const char* extensions);

/// True if a dispatch in the current context has ended when the call that issues it returns: llvmpipe_launch_grid()
/// waits for its own threads. Such a driver also locks the common state of contexts that share objects (cs_mutex), so
/// that only contexts which share nothing compute in parallel.
bool dispatchIsSynchronous();

/// On two processors or fewer: makes the driver work on the threads that call it, unless the user chose otherwise
/// (LP_NUM_THREADS). Sharing each of a weld's many small dispatches among threads costs more than it gains; wide ones
/// and pictures without concurrent steps gain. Call it before any OpenGL function.
void runDriverSingleThreaded();

/// True if that driver, if in use, works on the threads that call it.
bool driverIsSingleThreaded();

/// Omits this thread's barriers and fences during its lifetime: its context only computes, with a driver of
/// dispatchIsSynchronous(). There they order nothing, and llvmpipe's wait until the pictures of all contexts that share
/// objects with it are drawn (lp_setup_flush() takes the rasterizer's lock).
class BarrierFreeThread {
  public:
    BarrierFreeThread();
    ~BarrierFreeThread();
    BarrierFreeThread(const BarrierFreeThread&) = delete;
    BarrierFreeThread& operator=(const BarrierFreeThread&) = delete;

    /// Frees deleted objects from time to time; call it often. Mesa holds a deleted buffer texture, and with it the
    /// buffer, until the context that read it flushes.
    void freeDeleted();

  private:
    std::chrono::steady_clock::time_point flushed_;
};

/// True on a BarrierFreeThread.
bool barrierFree();

/// Additional storage flags of a buffer that a BarrierFreeThread reaches: none unless the driver is of
/// dispatchIsSynchronous().
GLbitfield directStorage();

/// Maps a buffer with directStorage() permanently; no-op if that is none.
void mapDirectly(GLuint buffer, size_t bytes);

/// A buffer's own memory on a BarrierFreeThread, null elsewhere; its address is fixed for the buffer's lifetime, and
/// any thread may read it between two tasks of that one.
std::byte* directMemory(GLuint buffer);

// On a BarrierFreeThread these functions work in the buffers' own memory. Elsewhere they return false and do nothing,
// and the caller uses the driver. On such a thread the driver must not do it: llvmpipe would search pictures for the
// buffer (llvmpipe_flush_resource()), in lists that a drawing thread with shared objects changes concurrently.

/// Copies bytes; both buffers must have such memory.
bool copyDirectly(GLuint from, GLuint to, size_t bytes, size_t fromOffset, size_t toOffset);
/// Sets whole words.
bool fillDirectly(GLuint buffer, size_t offset, size_t bytes, GLuint word);
bool writeDirectly(GLuint buffer, const void* data, size_t bytes, size_t offset);
bool readDirectly(GLuint buffer, void* data, size_t bytes, size_t offset);
/// Dispatches the numbers of groups at `offset` of the buffer bound as GL_DISPATCH_INDIRECT_BUFFER.
bool dispatchDirectly(size_t offset);

/// The major version of Mesa in OpenGL's version text, such as 22 in "4.5 (Core Profile) Mesa 22.3.6"; 0 for another
/// driver.
int mesaMajor(std::string_view version);

/// A finding about the driver for the user, in three sentences without a full stop.
struct DriverAdvice {
    std::string about, found, remedy;
};

/// The advice to install a newer driver, if one is faster; `version` is GL_VERSION.
std::optional<DriverAdvice> newerDriver(std::string_view renderer, std::string_view version);

/// Instructions for getting a driver on Linux, with or without a card.
inline constexpr const char* kDriverRemedy =
    "on Debian and Ubuntu: apt-get install libegl1 libgl1-mesa-dri, or the card's own driver";

} // namespace meltpool::gl
