// Asks the headset for a display rate and for processors that hold their speed, where the runtime can do so.
#pragma once

#include "xr/session.hpp"

#include <optional>
#include <span>

namespace meltpool::xr {

/// Highest display rate that is asked for, in Hz. A faster display leaves the metal's steps too little of each frame.
constexpr float kHighestRate = 90.0f;

/// The highest of the offered rates (Hz) up to kHighestRate; empty if all are higher.
std::optional<float> chooseRefreshRate(std::span<const float> offered);

/// Requests the chosen display rate (XR_FB_display_refresh_rate), and sustained high speed of both processors
/// (XR_EXT_performance_settings). A runtime that refuses keeps its own values.
void requestSpeed(const Session& session);

} // namespace meltpool::xr
