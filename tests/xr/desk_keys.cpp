#include "tests/xr/desk_keys.hpp"

#include "core/base/error.hpp"

#include <X11/Xlib.h>

namespace meltpool::test {

namespace {

Window titled(Display* display, const std::string& title) {
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
    return found;
}

} // namespace

void pressKey(const std::string& title, const std::string& symbol) {
    static Time lastTime = 0; // GLFW ignores a key's second event of one time
    Display* display = XOpenDisplay(nullptr);
    if (display == nullptr) throw RuntimeFault("no X display for the key");
    XEvent event{};
    XKeyEvent& key = event.xkey;
    key.display = display;
    key.window = titled(display, title);
    if (key.window == 0) throw RuntimeFault("no window is called " + title);
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
