// Moves the scripted headset and controllers: a client of Monado's remote driver.
#pragma once

#include "xr/pose.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace meltpool::test {

/// What one controller does. Poses are in the driver's own space: metres, y up, origin on the floor.
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
    /// Where the eyes stand from the head's centre and what they see; used while `ownEyes`.
    bool ownEyes = false;
    std::array<xr::Pose, 2> eyes{xr::Pose{{1, 0, 0, 0}, {-0.0315f, 0, 0}}, xr::Pose{{1, 0, 0, 0}, {0.0315f, 0, 0}}};
    std::array<xr::FieldOfView, 2> fov{};
    std::array<RemoteHand, 2> hands; ///< left, right
};

constexpr std::size_t kRemotePacket = 376;

/// The packet's bytes, as the driver reads them.
std::vector<std::uint8_t> encode(const RemoteState& state);

class RemoteDriver {
  public:
    /// Connects to the driver on this machine. Throws RuntimeFault when nothing listens within a minute.
    explicit RemoteDriver(int port);
    ~RemoteDriver();
    RemoteDriver(const RemoteDriver&) = delete;
    RemoteDriver& operator=(const RemoteDriver&) = delete;

    /// Takes effect in the next frame. False: the driver is gone.
    bool send(const RemoteState& state);

  private:
    int socket_ = -1;
};

} // namespace meltpool::test
