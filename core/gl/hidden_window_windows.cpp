#include "core/gl/hidden_window.hpp"

#include "core/base/error.hpp"

#include <windows.h>

#include <array>

namespace meltpool::gl {

namespace {

constexpr const wchar_t* kClass = L"MeltpoolHidden";

// Constants of WGL_ARB_create_context and WGL_ARB_create_context_profile.
constexpr int kMajor = 0x2091, kMinor = 0x2092, kFlags = 0x2094, kProfile = 0x9126;
constexpr int kDebug = 1, kCore = 1;

void registerClass() {
    WNDCLASSW kind{};
    kind.style = CS_OWNDC; // one device context for the window's whole life
    kind.lpfnWndProc = DefWindowProcW;
    kind.hInstance = GetModuleHandleW(nullptr);
    kind.lpszClassName = kClass;
    RegisterClassW(&kind); // fails if it was registered before
}

PIXELFORMATDESCRIPTOR wantedFormat() {
    PIXELFORMATDESCRIPTOR wanted{};
    wanted.nSize = sizeof wanted;
    wanted.nVersion = 1;
    wanted.dwFlags = PFD_DRAW_TO_WINDOW | PFD_SUPPORT_OPENGL;
    wanted.iPixelType = PFD_TYPE_RGBA;
    wanted.cColorBits = 32;
    return wanted;
}

} // namespace

HiddenWindow::HiddenWindow(int pixelFormat) {
    registerClass();
    const HWND window = CreateWindowExW(0, kClass, L"Meltpool", WS_POPUP, 0, 0, 1, 1, nullptr, nullptr,
                                        GetModuleHandleW(nullptr), nullptr);
    if (window == nullptr)
        throw InputError("the program cannot make a hidden window; expected a desktop session of Windows");
    window_ = window;
    const HDC context = GetDC(window);
    deviceContext_ = context;
    PIXELFORMATDESCRIPTOR wanted = wantedFormat();
    const int format = pixelFormat != 0 ? pixelFormat : ChoosePixelFormat(context, &wanted);
    if (format != 0 && SetPixelFormat(context, format, &wanted) != FALSE) return;
    DestroyWindow(window);
    throw InputError("the graphics driver has no OpenGL for windows; expected the graphics card's own driver");
}

HiddenWindow::~HiddenWindow() {
    const HWND window = static_cast<HWND>(window_);
    ReleaseDC(window, static_cast<HDC>(deviceContext_));
    // Only the thread that made a window may destroy it; this message asks that thread.
    if (GetWindowThreadProcessId(window, nullptr) == GetCurrentThreadId())
        DestroyWindow(window);
    else
        PostMessageW(window, WM_CLOSE, 0, 0);
}

void* HiddenWindow::makeContext(bool debug, void* sharedWith) const {
    using Create = HGLRC(WINAPI*)(HDC, HGLRC, const int*);
    const auto create =
        reinterpret_cast<Create>(reinterpret_cast<void*>(wglGetProcAddress("wglCreateContextAttribsARB")));
    if (create == nullptr) return nullptr;
    const std::array<int, 9> wanted{kMajor, 4, kMinor, 5, kProfile, kCore, kFlags, debug ? kDebug : 0, 0};
    return create(static_cast<HDC>(deviceContext_), static_cast<HGLRC>(sharedWith), wanted.data());
}

} // namespace meltpool::gl
