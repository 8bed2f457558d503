#include "xr/device_speed.hpp"

#include <vector>

namespace meltpool::xr {

namespace {

void requestRefreshRate(const Session& session) {
    const Instance& instance = session.instance();
    const auto list = instance.function<PFN_xrEnumerateDisplayRefreshRatesFB>("xrEnumerateDisplayRefreshRatesFB");
    const auto request = instance.function<PFN_xrRequestDisplayRefreshRateFB>("xrRequestDisplayRefreshRateFB");
    if (list == nullptr || request == nullptr) return;
    uint32_t count = 0;
    if (XR_FAILED(list(session.handle(), 0, &count, nullptr))) return;
    std::vector<float> offered(count);
    if (XR_FAILED(list(session.handle(), count, &count, offered.data()))) return;
    if (const std::optional<float> rate = chooseRefreshRate(offered)) request(session.handle(), *rate);
}

void requestProcessorSpeed(const Session& session) {
    const auto set =
        session.instance().function<PFN_xrPerfSettingsSetPerformanceLevelEXT>("xrPerfSettingsSetPerformanceLevelEXT");
    if (set == nullptr) return;
    for (const XrPerfSettingsDomainEXT domain : {XR_PERF_SETTINGS_DOMAIN_CPU_EXT, XR_PERF_SETTINGS_DOMAIN_GPU_EXT})
        set(session.handle(), domain, XR_PERF_SETTINGS_LEVEL_SUSTAINED_HIGH_EXT);
}

} // namespace

std::optional<float> chooseRefreshRate(std::span<const float> offered) {
    constexpr float kRounding = 0.5f; // 89.95 and 90.02 Hz are 90 Hz
    std::optional<float> best;
    for (const float rate : offered)
        if (rate <= kHighestRate + kRounding && (!best || rate > *best)) best = rate;
    return best;
}

void requestSpeed(const Session& session) {
    if (session.instance().has("XR_FB_display_refresh_rate")) requestRefreshRate(session);
    if (session.instance().has("XR_EXT_performance_settings")) requestProcessorSpeed(session);
}

} // namespace meltpool::xr
