// Encodes packets for Monado's remote driver, protocol "mndrmt3".
#include "tests/xr/remote_driver.hpp"

#include "core/base/error.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <string>
#include <thread>

namespace meltpool::test {

namespace {

/// Appends little-endian fields; the machines that run this are little-endian themselves.
class Writer {
  public:
    void value(float v) { raw(&v, sizeof v); }
    void flag(bool v) { bytes_.push_back(v ? 1 : 0); }
    void padding(std::size_t count) { bytes_.insert(bytes_.end(), count, std::uint8_t{0}); }
    void raw(const void* data, std::size_t size) {
        const auto* from = static_cast<const std::uint8_t*>(data);
        bytes_.insert(bytes_.end(), from, from + size);
    }
    void pose(const xr::Pose& pose) {
        for (const float v : {pose.orientation.x, pose.orientation.y, pose.orientation.z, pose.orientation.w,
                              pose.position.x, pose.position.y, pose.position.z})
            value(v);
    }
    std::vector<std::uint8_t> take() { return std::move(bytes_); }

  private:
    std::vector<std::uint8_t> bytes_;
};

void writeHead(Writer& out, const RemoteState& state) {
    for (std::size_t eye = 0; eye < state.eyes.size(); ++eye) {
        const xr::FieldOfView& fov = state.fov[eye];
        for (const float angle : {fov.left, fov.right, fov.up, fov.down})
            out.value(angle);
        out.pose(state.eyes[eye]);
        out.padding(4);
    }
    out.pose(state.head);
    out.flag(state.ownEyes);
    out.padding(3);
}

void writeHand(Writer& out, const RemoteHand& hand) {
    constexpr std::size_t velocities = 6, fingers = 5;
    out.pose(hand.pose);
    for (std::size_t i = 0; i < velocities + fingers; ++i)
        out.value(0);
    out.value(hand.trigger);
    out.value(hand.squeeze);
    out.value(0); // squeeze force
    out.value(hand.thumbstickX);
    out.value(hand.thumbstickY);
    for (int i = 0; i < 3; ++i)
        out.value(0); // trackpad force, x, y
    out.flag(false);  // hand tracking
    out.flag(hand.active);
    out.flag(false); // system click
    out.flag(false); // system touch
    out.flag(hand.a);
    out.flag(hand.a);
    out.flag(hand.b);
    out.flag(hand.b);
    out.flag(hand.trigger > 0.9f);
    out.flag(hand.trigger > 0.0f);
    out.flag(hand.thumbstickClick);
    out.flag(hand.thumbstickClick);
    out.flag(false); // trackpad touch
    out.padding(3);
}

} // namespace

std::vector<std::uint8_t> encode(const RemoteState& state) {
    Writer out;
    out.raw("mndrmt3", 8);
    writeHead(out, state);
    for (const RemoteHand& hand : state.hands)
        writeHand(out, hand);
    return out.take();
}

RemoteDriver::RemoteDriver(int port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    for (int i = 0; i < 3000; ++i) { // minutes: a busy machine takes long to start the runtime
        socket_ = ::socket(AF_INET, SOCK_STREAM, 0);
        if (::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) {
            const int on = 1;
            ::setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
            return;
        }
        ::close(socket_);
        socket_ = -1;
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    throw RuntimeFault("no remote driver listens on port " + std::to_string(port));
}

RemoteDriver::~RemoteDriver() {
    if (socket_ >= 0) ::close(socket_);
}

bool RemoteDriver::send(const RemoteState& state) {
    const std::vector<std::uint8_t> packet = encode(state);
    return ::send(socket_, packet.data(), packet.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(packet.size());
}

} // namespace meltpool::test
