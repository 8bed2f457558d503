// The desktop trainer: a window with menus in which the mouse holds the torch.
#pragma once

#include "app/session/window_headset.hpp"

#include <filesystem>
#include <string>

namespace meltpool {

/// Whether the trainer looks for a headset.
enum class HeadsetUse {
    automatic, ///< one is used as soon as there is one
    wanted,    ///< without one the program ends with the reason
    off
};

struct DesktopOptions {
    std::string lesson;              ///< catalogue name or TOML file; empty: the window opens on the home page
    std::filesystem::path telemetry; ///< where the window writes what it does, one JSON object a line; empty: nowhere
    std::filesystem::path settings;  ///< empty: settings.toml in the user's settings folder
    std::filesystem::path record;    ///< where every step of the lesson goes as a torch path; empty: nowhere
    std::filesystem::path replay;    ///< a kept attempt that the window opens on; empty: none
    std::filesystem::path ghost;     ///< an attempt or torch path shown beside one's own; empty: as the settings say
    bool recordings = true;          ///< each attempt has one in the user's folder
    HeadsetUse headset = HeadsetUse::automatic;
    HeadsetMaker makeHeadset;  ///< of the headset beside the window, unless `headset` is off
    bool watchShaders = false; ///< reload changed shaders in release builds too
};

/// Why no window can be opened here, as a sentence; empty when one can.
std::string missingDisplay();

/// Opens the window and returns when it is closed or SIGINT, SIGTERM or SIGHUP came: 0, or 1 where a record that was
/// wanted, or a recording, is not whole or the settings cannot be saved. Where the display goes away it keeps what they
/// would keep, and the process ends with exit code 1. Throws InputError when there is no display or too little OpenGL,
/// or the lesson or telemetry file cannot be used.
int runDesktop(const DesktopOptions& options);

} // namespace meltpool
