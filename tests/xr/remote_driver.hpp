// Moves the scripted headset and controllers: a client of Monado's remote driver.
#pragma once

#include "xr/pose.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace meltpool::test {

/// State of one controller. Poses are in the driver's own space: metres, y up, origin on the floor.
struct RemoteHand {
    bool active = true; ///< false: switched off
    xr::Pose pose;
    float trigger = 0;
    float squeeze = 0;
    bool a = false;
    bool b = false;
    bool thumbstickClick = false;
    float thumbstickX = 0;
    float thumbstickY = 0;
};

struct RemoteState {
    xr::Pose head{{1, 0, 0, 0}, {0, 1.6f, 0}};
    /// Places of the eyes from the head's centre and their fields of view; used while `ownEyes`.
    bool ownEyes = false;
    std::array<xr::Pose, 2> eyes{xr::Pose{{1, 0, 0, 0}, {-0.0315f, 0, 0}}, xr::Pose{{1, 0, 0, 0}, {0.0315f, 0, 0}}};
    std::array<xr::FieldOfView, 2> fov{};
    std::array<RemoteHand, 2> hands; ///< left, right
};

constexpr std::size_t kRemotePacket = 376;

/// Returns the packet's bytes, as the driver reads them.
std::vector<std::uint8_t> encode(const RemoteState& state);

class RemoteDriver {
  public:
    /// Connects to the driver on this machine. Throws RuntimeFault if no driver listens within a minute.
    explicit RemoteDriver(int port);
    ~RemoteDriver();
    RemoteDriver(const RemoteDriver&) = delete;
    RemoteDriver& operator=(const RemoteDriver&) = delete;

    /// Sends the state, which takes effect in the next frame. Returns false if the driver has gone.
    bool send(const RemoteState& state);

  private:
    int socket_ = -1;
};

} // namespace meltpool::test
