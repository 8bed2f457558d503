// The table of the window's actions. Keys, menus and the headset look them up here.
#pragma once

#include "app/session/input.hpp"
#include "app/session/menu_state.hpp"

#include <optional>
#include <span>

namespace meltpool {

class DesktopApp;

/// Describes one action of the window. Only keys ask `allowed`: a menu decides itself when it shows a button.
struct DesktopAction {
    const char* name;
    MenuRequest request;    ///< request by which menus and headset ask for the action; none: they do not
    std::optional<Key> key; ///< key of the action; empty: none
    bool (*allowed)(const DesktopApp& app);
    void (*run)(DesktopApp& app);
};

/// Returns the table of actions. No two actions share a name, a key or a request.
std::span<const DesktopAction> desktopActions();

} // namespace meltpool
