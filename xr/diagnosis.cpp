// Opens a session for a moment and collects the runtime's properties.
#include "xr/diagnosis.hpp"

#include "xr/headset.hpp"
#include "xr/headset_connection.hpp"
#include "xr/runtime_manifest.hpp"

#include <array>
#include <chrono>
#include <cstdio>
#include <optional>
#include <thread>

namespace meltpool::xr {

namespace {

using Clock = std::chrono::steady_clock;

std::string formatName(std::int64_t format) {
    switch (format) {
    case GL_SRGB8_ALPHA8:
        return "SRGB8_ALPHA8";
    case GL_SRGB8:
        return "SRGB8";
    case GL_RGBA8:
        return "RGBA8";
    case GL_RGBA16:
        return "RGBA16";
    case GL_RGBA16F:
        return "RGBA16F";
    case GL_RGB10_A2:
        return "RGB10_A2";
    case GL_DEPTH_COMPONENT16:
        return "DEPTH16";
    case GL_DEPTH_COMPONENT24:
        return "DEPTH24";
    case GL_DEPTH_COMPONENT32F:
        return "DEPTH32F";
    case GL_DEPTH24_STENCIL8:
        return "DEPTH24_STENCIL8";
    case GL_DEPTH32F_STENCIL8:
        return "DEPTH32F_STENCIL8";
    default: {
        std::array<char, 24> text{};
        std::snprintf(text.data(), text.size(), "0x%llx", static_cast<unsigned long long>(format));
        return text.data();
    }
    }
}

const char* floorName(XrReferenceSpaceType space) {
    if (space == XR_REFERENCE_SPACE_TYPE_LOCAL) return "not known (LOCAL)";
    return space == XR_REFERENCE_SPACE_TYPE_STAGE ? "known (STAGE)" : "known (LOCAL_FLOOR)";
}

std::string decimal(double value, const char* unit) {
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "%.1f %s", value, unit);
    return text.data();
}

void addSystemFacts(const Instance& instance, Diagnosis& diagnosis) {
    diagnosis.facts.push_back({"OpenXR runtime", instance.info().runtime});
    diagnosis.facts.push_back({"headset", instance.info().system});
    std::string extensions;
    for (const std::string& name : instance.extensions())
        extensions += (extensions.empty() ? "" : ", ") + name;
    diagnosis.facts.push_back({"extensions in use", extensions});
}

/// Submits empty frames until a controller is bound, for three seconds at most. Returns the display's period in
/// seconds; 0 if the runtime asked for no frame.
double watch(Headset& headset) {
    double period = 0;
    for (const auto end = Clock::now() + std::chrono::seconds(3); Clock::now() < end;) {
        headset.poll();
        if (!headset.running()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
            continue;
        }
        const FrameTiming timing = headset.waitFrame();
        period = timing.period;
        headset.beginFrame();
        headset.endFrame();
        const bool bound = headset.input().hand(Hand::left).present || headset.input().hand(Hand::right).present;
        if (bound && headset.mode() == SessionMode::focused) break;
    }
    return period;
}

/// The display's rate in Hz: from the runtime's extension, else from the period of its frames. 0: unknown.
double refreshRate(const Headset& headset, double period) {
    float rate = 0;
    const auto ask = headset.instance().function<PFN_xrGetDisplayRefreshRateFB>("xrGetDisplayRefreshRateFB");
    if (headset.instance().has("XR_FB_display_refresh_rate") && ask != nullptr &&
        XR_SUCCEEDED(ask(headset.session().handle(), &rate)) && rate > 0)
        return static_cast<double>(rate);
    return period > 0 ? 1.0 / period : 0;
}

void addHandsFacts(Headset& headset, Diagnosis& diagnosis) {
    const Input& input = headset.input();
    for (const Hand hand : {Hand::left, Hand::right}) {
        const std::string profile = input.profile(hand);
        const HandInput& now = input.hand(hand);
        const char* state = now.tracked ? ", tracked" : now.present ? ", not tracked" : ", off";
        const std::optional<bool> byAim = input.holdsByAim(hand);
        const char* hold = !byAim ? "" : *byAim ? ", torch along its aim" : ", torch along its grip";
        diagnosis.facts.push_back({hand == Hand::left ? "left controller" : "right controller",
                                   profile.empty() ? "none" : profile + state + hold, now.present});
    }
    for (const TrackerInput& tracker : input.trackers())
        if (tracker.tracked) diagnosis.facts.push_back({"tracker", tracker.role});
    for (const std::string& refused : input.refused())
        diagnosis.facts.push_back({"unknown to the runtime", refused});
}

void addSessionFacts(std::unique_ptr<Instance> instance, Diagnosis& diagnosis) {
    Headset headset(std::move(instance), {.resolutionScale = 1.0f, .samples = 1});
    headset.waitUntilOpened();
    diagnosis.facts.push_back({"OpenGL binding", headset.bindingKind()});
    diagnosis.facts.push_back(
        {"pixels an eye", std::to_string(headset.eyes().width()) + " x " + std::to_string(headset.eyes().height())});
    std::string formats;
    for (const std::int64_t format : offeredFormats(headset.session()))
        formats += (formats.empty() ? "" : ", ") + formatName(format);
    diagnosis.facts.push_back({"picture formats", formats});
    diagnosis.facts.push_back({"depth layer", headset.hasDepthLayer() ? "yes" : "no"});
    diagnosis.facts.push_back({"panel behind nearer things", headset.hasLayerDepthTest() ? "yes" : "no"});
    diagnosis.facts.push_back({"put on and taken off", headset.hasUserPresence() ? "reported" : "not reported"});
    diagnosis.facts.push_back({"floor", floorName(headset.session().spaceType())});
    const double period = watch(headset);
    if (period > 0)
        diagnosis.facts.push_back({"refresh rate", decimal(refreshRate(headset, period), "Hz")});
    else
        diagnosis.facts.push_back({"refresh rate", "unknown: the headset sleeps", false});
    addHandsFacts(headset, diagnosis);
    const bool hands = headset.input().hand(Hand::left).present || headset.input().hand(Hand::right).present;
    if (period <= 0)
        diagnosis.advice = "Put the headset on. It sleeps until you wear it.";
    else if (!hands)
        diagnosis.advice = "Switch a controller on. The torch is in the hand that holds it.";
}

} // namespace

Diagnosis diagnose(bool session) {
    quietLoader();
    Diagnosis diagnosis;
    const RuntimeManifest manifest = findRuntimeManifest();
    const std::string named = manifest.file.empty() ? "none is set" : manifest.file;
    diagnosis.facts.push_back({"active runtime", named, !manifest.file.empty() && manifest.fault.empty()});
    if (!manifest.unheeded.empty())
        diagnosis.facts.push_back({"XR_RUNTIME_JSON",
                                   manifest.unheeded + " is ignored: the program runs with administrator rights",
                                   false});
    if (!manifest.fault.empty()) {
        diagnosis.facts.push_back({"headset", "none usable", false});
        diagnosis.advice = manifest.fault;
        return diagnosis;
    }
    try {
        auto instance = std::make_unique<Instance>();
        addSystemFacts(*instance, diagnosis);
        if (session) addSessionFacts(std::move(instance), diagnosis);
        diagnosis.usable = true;
    } catch (const XrFault& fault) {
        diagnosis.facts.push_back({"headset", "none usable (" + resultName(fault.result()) + ")", false});
        diagnosis.advice = explain(fault);
    } catch (const std::exception& other) {
        diagnosis.facts.push_back({"headset", "none usable", false});
        diagnosis.advice = other.what();
    }
    return diagnosis;
}

} // namespace meltpool::xr
