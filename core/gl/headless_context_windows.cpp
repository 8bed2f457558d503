#include "core/base/error.hpp"
#include "core/gl/context.hpp"
#include "core/gl/hidden_window.hpp"

#include <windows.h>

namespace meltpool::gl {

namespace {

constexpr const char* kRemedy = "install the driver of the graphics card from its maker (NVIDIA, AMD, Intel)";

/// The true version: GetVersion() reports the version that the program was made for.
std::string windowsVersion() {
    using Ask = LONG(WINAPI*)(OSVERSIONINFOW*);
    const HMODULE library = GetModuleHandleW(L"ntdll.dll");
    const auto ask = reinterpret_cast<Ask>(reinterpret_cast<void*>(GetProcAddress(library, "RtlGetVersion")));
    OSVERSIONINFOW version{};
    version.dwOSVersionInfoSize = sizeof version;
    if (ask == nullptr || ask(&version) != 0) return "Windows";
    std::string text = "Windows " + std::to_string(version.dwMajorVersion) + "." +
                       std::to_string(version.dwMinorVersion) + "." + std::to_string(version.dwBuildNumber);
    // Wine identifies itself by a function of its own.
    if (GetProcAddress(library, "wine_get_version") != nullptr) text += ", as Wine plays it";
    return text;
}

} // namespace

ContextSystem contextSystem() {
    return {"WGL", windowsVersion(), kRemedy};
}

struct HeadlessContext::Handles {
    HiddenWindow window;
    HGLRC context = nullptr;

    HDC deviceContext() const { return static_cast<HDC>(window.deviceContext()); }

    ~Handles() {
        if (context == nullptr) return;
        if (wglGetCurrentContext() == context) wglMakeCurrent(nullptr, nullptr);
        wglDeleteContext(context);
    }
};

HeadlessContext::HeadlessContext(bool debug) : handles_(std::make_unique<Handles>()) {
    const HDC deviceContext = handles_->deviceContext();
    // The function that makes core contexts is the driver's own, and is found through an old-style context.
    const HGLRC old = wglCreateContext(deviceContext);
    if (old != nullptr && wglMakeCurrent(deviceContext, old) != FALSE)
        handles_->context = static_cast<HGLRC>(handles_->window.makeContext(debug, nullptr));
    const std::string offered = [] {
        const auto* version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
        return version == nullptr ? std::string("no OpenGL") : "OpenGL " + std::string(version);
    }();
    wglMakeCurrent(nullptr, nullptr);
    if (old != nullptr) wglDeleteContext(old);
    if (handles_->context == nullptr || wglMakeCurrent(deviceContext, handles_->context) == FALSE)
        throw InputError("no OpenGL 4.5 core context could be made: this computer offers " + offered + "; " + kRemedy);
    info_ = useCurrentContext(debug);
}

HeadlessContext::~HeadlessContext() = default;

void HeadlessContext::makeCurrent() const {
    wglMakeCurrent(handles_->deviceContext(), handles_->context);
}

} // namespace meltpool::gl
