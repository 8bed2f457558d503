// The program's side of a counting library that tests load before it (LD_PRELOAD): the library sees every OpenGL call
// and every allocation and reports them to this program's WorkMeters. The program itself counts neither.
#pragma once

#include <cstdint>

namespace meltpool {

/// Callbacks of the library into the program, on the thread that makes the OpenGL call.
struct CallListener {
    /// Begins an OpenGL call: the thread's time is the driver's. Returns the value that leaveDriver() needs; negative
    /// if no WorkMeter measures the thread.
    int (*enterDriver)();
    void (*leaveDriver)(int before);
    /// Reports a call that waits for the GPU.
    void (*stalled)(const char* call);
};

/// Returns the calling thread's uses of operator new so far.
using AllocationCount = std::uint64_t (*)();

/// The library's only entry, a C function of this name. Call it once OpenGL's functions are loaded; the listener has to
/// stay.
using ListenToCalls = AllocationCount (*)(const CallListener*);
constexpr const char* kListenToCalls = "meltpool_listen_to_calls";

/// Makes the library report to this program's WorkMeters from now on. Returns false if it is not loaded: OpenGL's time
/// then counts as the frame's own work, and allocations and stalls are not counted.
bool joinCallCounters();

} // namespace meltpool
