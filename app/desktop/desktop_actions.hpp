// The table of the window's actions. Keys, menus and the headset look them up here.
#pragma once

#include "app/session/input.hpp"
#include "app/session/menu_state.hpp"

#include <optional>
#include <span>

namespace meltpool {

class DesktopApp;

/// Only keys ask `allowed`: a menu decides itself where it shows a button.
struct DesktopAction {
    const char* name;
    MenuRequest request;    ///< by which menus and headset ask for it; none: they do not
    std::optional<Key> key; ///< empty: no key of its own
    bool (*allowed)(const DesktopApp& app);
    void (*run)(DesktopApp& app);
};

/// Each name, key and request is that of one action.
std::span<const DesktopAction> desktopActions();

} // namespace meltpool
