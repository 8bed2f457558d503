// The program's side of a counting library that tests load before it (LD_PRELOAD): the library sees every OpenGL call
// and every allocation and reports them to this program's WorkMeters. The program itself counts neither.
#pragma once

#include <cstdint>

namespace meltpool {

/// What the library calls in the program, on the thread that makes the OpenGL call.
struct CallListener {
    /// An OpenGL call begins: the thread's time is the driver's. Answers what leaveDriver() needs; negative where no
    /// WorkMeter measures the thread.
    int (*enterDriver)();
    void (*leaveDriver)(int before);
    /// The call waits for the GPU.
    void (*stalled)(const char* call);
};

/// Answers how often the calling thread has used operator new so far.
using AllocationCount = std::uint64_t (*)();

/// The library's only entry, a C function of this name. To be called once OpenGL's functions are loaded; the listener
/// has to stay.
using ListenToCalls = AllocationCount (*)(const CallListener*);
constexpr const char* kListenToCalls = "meltpool_listen_to_calls";

/// Has the library report to this program's WorkMeters, from now on. False where it is not loaded: OpenGL's time then
/// counts as the frame's own work, and nothing counts allocations and stalls.
bool joinCallCounters();

} // namespace meltpool
