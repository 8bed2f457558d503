// Sends vibrations to controllers: as amplitude and frequency, or as PCM samples if the runtime takes them.
#include "xr/input.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

// Older OpenXR headers do not know the extension XR_FB_haptic_pcm; these are its declarations from the OpenXR
// specification.
#ifndef XR_FB_haptic_pcm
#define XR_FB_haptic_pcm 1
#define XR_TYPE_HAPTIC_PCM_VIBRATION_FB (static_cast<XrStructureType>(1000209001))
#define XR_TYPE_DEVICE_PCM_SAMPLE_RATE_GET_INFO_FB (static_cast<XrStructureType>(1000209002))
struct XrHapticPcmVibrationFB {
    XrStructureType type;
    const void* next;
    uint32_t bufferSize;
    const float* buffer;
    float sampleRate;
    XrBool32 append;
    uint32_t* samplesConsumed;
};
struct XrDevicePcmSampleRateGetInfoFB {
    XrStructureType type;
    const void* next;
    float sampleRate;
};
using PFN_xrGetDeviceSampleRateFB = XrResult(XRAPI_PTR*)(XrSession, const XrHapticActionInfo*,
                                                         XrDevicePcmSampleRateGetInfoFB*);
#endif

namespace meltpool::xr {

void Input::play(Hand which, const HapticPulse& pulse) {
    XrHapticActionInfo target{XR_TYPE_HAPTIC_ACTION_INFO};
    target.action = actions_.haptic;
    target.subactionPath = handPaths_[size_t(which)];
    playOn(handOutputs_[size_t(which)], target, pulse);
}

void Input::playTracker(size_t which, const HapticPulse& pulse) {
    if (which >= trackerOutputs_.size()) return;
    XrHapticActionInfo target{XR_TYPE_HAPTIC_ACTION_INFO};
    target.action = actions_.trackerHaptic;
    target.subactionPath = rolePaths_[which];
    playOn(trackerOutputs_[which], target, pulse);
}

void Input::playOn(HapticOutput& output, const XrHapticActionInfo& target, const HapticPulse& pulse) {
    if (pulse.silent()) {
        if (!output.vibrating) return;
        output.vibrating = false;
        ++hapticCalls_.stopped;
        MELTPOOL_XR(xrStopHapticFeedback(session_.handle(), &target));
        return;
    }
    output.vibrating = true;
    ++hapticCalls_.applied;
    if (instance_.has("XR_FB_haptic_pcm") && playPcm(output.wave, target, pulse)) return;
    XrHapticVibration vibration{XR_TYPE_HAPTIC_VIBRATION};
    vibration.amplitude = std::clamp(pulse.amplitude, 0.0f, 1.0f);
    vibration.frequency = pulse.frequency > 0 ? pulse.frequency : float(XR_FREQUENCY_UNSPECIFIED);
    vibration.duration = static_cast<XrDuration>(static_cast<double>(pulse.duration) * 1e9);
    MELTPOOL_XR(
        xrApplyHapticFeedback(session_.handle(), &target, reinterpret_cast<const XrHapticBaseHeader*>(&vibration)));
}

bool Input::playPcm(Wave& wave, const XrHapticActionInfo& target, const HapticPulse& pulse) {
    static constexpr size_t kMostSamples = 4000; // XR_MAX_HAPTIC_PCM_BUFFER_SIZE_FB
    const auto sampleRateOf = instance_.function<PFN_xrGetDeviceSampleRateFB>("xrGetDeviceSampleRateFB");
    if (sampleRateOf == nullptr) return false;
    XrDevicePcmSampleRateGetInfoFB rate{XR_TYPE_DEVICE_PCM_SAMPLE_RATE_GET_INFO_FB, nullptr, 0};
    if (XR_FAILED(sampleRateOf(session_.handle(), &target, &rate)) || rate.sampleRate <= 0) return false;
    std::array<float, kMostSamples> samples;
    const size_t count = std::min(kMostSamples, static_cast<size_t>(pulse.duration * rate.sampleRate));
    // The next pulse replaces this one before its end, so the phase follows the clock, not the samples.
    const auto now = std::chrono::steady_clock::now();
    const double elapsed = std::min(std::chrono::duration<double>(now - wave.start).count(), 1.0);
    wave.phase = std::fmod(wave.phase + 2.0 * std::numbers::pi * wave.frequency * elapsed, 2.0 * std::numbers::pi);
    wave.start = now;
    wave.frequency = static_cast<double>(pulse.frequency);
    synthesize(pulse, rate.sampleRate, wave.phase, {samples.data(), count});
    uint32_t consumed = 0;
    XrHapticPcmVibrationFB vibration{XR_TYPE_HAPTIC_PCM_VIBRATION_FB,
                                     nullptr,
                                     static_cast<uint32_t>(count),
                                     samples.data(),
                                     rate.sampleRate,
                                     XR_FALSE,
                                     &consumed};
    return XR_SUCCEEDED(
        xrApplyHapticFeedback(session_.handle(), &target, reinterpret_cast<const XrHapticBaseHeader*>(&vibration)));
}

} // namespace meltpool::xr
