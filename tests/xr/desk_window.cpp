#include "tests/xr/desk_window.hpp"

#include "core/base/error.hpp"
#include "tests/xr/monado_run.hpp"

#include <X11/Xlib.h>

namespace meltpool::test {

namespace {

Window windowOf(Display* display, const std::string& title) {
    Window root = 0, parent = 0, *children = nullptr;
    unsigned count = 0;
    XQueryTree(display, DefaultRootWindow(display), &root, &parent, &children, &count);
    Window found = 0;
    for (unsigned i = 0; i < count; ++i) {
        char* name = nullptr;
        if (XFetchName(display, children[i], &name) != 0 && name != nullptr && title == name) found = children[i];
        if (name != nullptr) XFree(name);
    }
    if (children != nullptr) XFree(children);
    if (found == 0) throw RuntimeFault("no window is called " + title);
    return found;
}

/// Place of a window in the screen's lower right corner.
struct Corner {
    int left = 0, top = 0, width = 0, height = 0;
};

/// Returns the corner for the window of that title; moves it there if requested.
Corner cornerOf(const std::string& title, bool move) {
    Display* display = XOpenDisplay(nullptr);
    if (display == nullptr) throw RuntimeFault("no X display for the window's picture");
    const Window window = windowOf(display, title);
    XWindowAttributes shape{};
    XGetWindowAttributes(display, window, &shape);
    const int left = DisplayWidth(display, DefaultScreen(display)) - shape.width;
    const int top = DisplayHeight(display, DefaultScreen(display)) - shape.height;
    if (move) {
        XMoveWindow(display, window, left, top);
        XRaiseWindow(display, window);
        XSync(display, 0);
    }
    XCloseDisplay(display);
    return {left, top, shape.width, shape.height};
}

} // namespace

void showWindow(const std::string& title) {
    cornerOf(title, true);
}

Image windowPicture(const std::string& title) {
    const Corner corner = cornerOf(title, false);
    const Image screen = screenshot();
    Image cut{corner.width, corner.height, {}};
    for (int y = 0; y < corner.height; ++y) {
        const auto row = screen.rgb.begin() + (std::ptrdiff_t(corner.top + y) * screen.width + corner.left) * 3;
        cut.rgb.insert(cut.rgb.end(), row, row + corner.width * 3);
    }
    return cut;
}

void pressKey(const std::string& title, const std::string& symbol) {
    static Time lastTime = 0; // GLFW ignores a key's second event of one time
    Display* display = XOpenDisplay(nullptr);
    if (display == nullptr) throw RuntimeFault("no X display for the key");
    XEvent event{};
    XKeyEvent& key = event.xkey;
    key.display = display;
    key.window = windowOf(display, title);
    key.root = DefaultRootWindow(display);
    key.same_screen = 1;
    key.keycode = XKeysymToKeycode(display, XStringToKeysym(symbol.c_str()));
    for (const int type : {KeyPress, KeyRelease}) {
        event.type = type;
        key.time = ++lastTime;
        XSendEvent(display, key.window, 1, type == KeyPress ? KeyPressMask : KeyReleaseMask, &event);
    }
    XSync(display, 0);
    XCloseDisplay(display);
}

} // namespace meltpool::test
