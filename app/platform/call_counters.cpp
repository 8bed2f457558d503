#include "app/platform/call_counters.hpp"

#include "core/base/work_meter.hpp"

#if defined(__linux__)

#include <dlfcn.h>

namespace meltpool {

namespace {

constexpr CallListener kListener{
    [] {
        WorkMeter* const meter = WorkMeter::current();
        return meter == nullptr ? -1 : static_cast<int>(meter->enter(WorkPlace::driver));
    },
    [](int before) {
        if (before >= 0) WorkMeter::current()->leave(static_cast<WorkPlace>(before));
    },
    [](const char* call) {
        if (WorkMeter* meter = WorkMeter::current()) meter->stalled(call);
    },
};

} // namespace

bool joinCallCounters() {
    const auto listen = reinterpret_cast<ListenToCalls>(dlsym(RTLD_DEFAULT, kListenToCalls));
    if (listen == nullptr) return false;
    WorkMeter::countAllocationsBy(listen(&kListener));
    return true;
}

} // namespace meltpool

#else

namespace meltpool {

bool joinCallCounters() {
    return false;
}

} // namespace meltpool

#endif
