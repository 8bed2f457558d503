// The desktop trainer: a window with menus in which the mouse holds the torch.
#pragma once

#include "app/session/window_headset.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace meltpool {

/// Use of a headset by the trainer.
enum class HeadsetUse {
    automatic, ///< the trainer uses a headset as soon as it finds one
    wanted,    ///< the program ends with the reason if there is no headset
    off
};

struct DesktopOptions {
    std::string lesson;              ///< catalogue name or TOML file; empty: the window opens on the home page
    std::filesystem::path telemetry; ///< file of the window's telemetry, one JSON object a line; empty: none
    std::filesystem::path settings;  ///< empty: settings.toml in the user's settings folder
    std::filesystem::path record;    ///< file for every step of the lesson as a torch path; empty: none
    std::filesystem::path replay;    ///< saved attempt that the window opens on; empty: none
    std::filesystem::path ghost;     ///< attempt or torch path shown as the ghost; empty: the settings choose
    std::optional<std::string> person; ///< name of the person who welds; empty: the account, or the home page asks
    bool recordings = true;          ///< every attempt gets a recording in the user's folder
    HeadsetUse headset = HeadsetUse::automatic;
    HeadsetMaker makeHeadset;  ///< maker of the window's headset, unused if `headset` is off
    bool watchShaders = false; ///< reloads changed shaders in release builds too
};

/// Returns a sentence on why no window can open here; empty if one can.
std::string missingDisplay();

/// Opens the window and returns when it closes or SIGINT, SIGTERM or SIGHUP arrives. Returns 0, or 1 if a requested
/// record or a recording is incomplete or the settings cannot be saved. If the display goes away, it saves the same
/// files and ends the process with exit code 1. Throws InputError if there is no display or too little OpenGL, or if
/// the lesson or telemetry file cannot be used.
int runDesktop(const DesktopOptions& options);

} // namespace meltpool
