// All that serves a driver which draws on the processor and has no card: Mesa's llvmpipe. With a card's driver every
// function here answers no or does nothing. Shaders mark lines that serve it alone with SYNCHRONOUS_DRIVER.
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

/// True where a dispatch of the current context has ended when the call that issues it returns: llvmpipe_launch_grid()
/// waits for its own threads. Such a driver also locks whatever contexts that share objects have
/// in common (cs_mutex), so that only contexts which share nothing compute side by side.
bool dispatchIsSynchronous();

/// On two processors or fewer: has the driver work on the threads that call it, unless the person has said otherwise
/// (LP_NUM_THREADS). To share each of a weld's many small dispatches among further threads costs more than it gains;
/// wide ones and pictures without steps beside them gain. To be called before anything of OpenGL.
void runDriverSingleThreaded();

/// True where that driver, if it is the one in use, works on the threads that call it.
bool driverIsSingleThreaded();

/// While it exists, this thread's barriers and fences are left out: its context only computes, with a driver of
/// dispatchIsSynchronous(). There they order nothing, and llvmpipe's wait until the pictures of all contexts that share
/// objects with it are drawn (lp_setup_flush() takes the rasterizer's lock).
class BarrierFreeThread {
  public:
    BarrierFreeThread();
    ~BarrierFreeThread();
    BarrierFreeThread(const BarrierFreeThread&) = delete;
    BarrierFreeThread& operator=(const BarrierFreeThread&) = delete;

    /// Frees deleted objects now and then, if it is called often. Mesa keeps a deleted buffer texture, and with it the
    /// buffer, until the context that read it flushes.
    void freeDeleted();

  private:
    std::chrono::steady_clock::time_point flushed_;
};

/// The calling thread is a BarrierFreeThread.
bool barrierFree();

/// Storage flags beside its own for a buffer that a BarrierFreeThread reaches: none but with a driver of
/// dispatchIsSynchronous().
GLbitfield directStorage();

/// Maps a buffer with directStorage() for good; nothing where that is none.
void mapDirectly(GLuint buffer, size_t bytes);

/// A buffer's own memory on a BarrierFreeThread, null elsewhere; it stays where it is as long as the buffer, and any
/// thread may read it between two works of that one.
std::byte* directMemory(GLuint buffer);

// On a BarrierFreeThread these do the work in the buffers' own memory. Elsewhere they return false and do nothing: the
// driver has to. There the driver must not: llvmpipe would look whether a picture still needs the buffer
// (llvmpipe_flush_resource()), in lists that a thread which draws with a context that shares objects changes meanwhile.

/// Both buffers have such memory.
bool copyDirectly(GLuint from, GLuint to, size_t bytes, size_t fromOffset, size_t toOffset);
/// Sets whole words.
bool fillDirectly(GLuint buffer, size_t offset, size_t bytes, GLuint word);
bool writeDirectly(GLuint buffer, const void* data, size_t bytes, size_t offset);
bool readDirectly(GLuint buffer, void* data, size_t bytes, size_t offset);
/// Dispatches as many groups as the three numbers say at `offset` of the buffer bound as GL_DISPATCH_INDIRECT_BUFFER.
bool dispatchDirectly(size_t offset);

/// The major version of Mesa in OpenGL's version text, such as 22 in "4.5 (Core Profile) Mesa 22.3.6"; 0 of another
/// driver.
int mesaMajor(std::string_view version);

/// A finding about the driver for a person, in three sentences without a full stop.
struct DriverAdvice {
    std::string about, found, remedy;
};

/// The advice to install a newer driver, where one is faster; `version` is GL_VERSION.
std::optional<DriverAdvice> newerDriver(std::string_view renderer, std::string_view version);

/// How a person gets a driver on Linux, with or without a card.
inline constexpr const char* kDriverRemedy =
    "on Debian and Ubuntu: apt-get install libegl1 libgl1-mesa-dri, or the card's own driver";

} // namespace meltpool::gl
