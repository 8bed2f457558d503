#include "app/sound/sound_output.hpp"

#include "app/sound/openal_device.hpp"
#include "app/sound/sound_stream.hpp"
#include "core/base/words.hpp"

#include <glm/geometric.hpp>

#include <array>
#include <chrono>
#include <cstdint>
#include <exception>
#include <memory>

namespace meltpool {

namespace {

constexpr std::chrono::milliseconds kLook(4); // between two checks of the queue, whose blocks last 10 ms

} // namespace

SoundOutput::SoundOutput(SoundFeed& feed) : feed_(feed), thread_([this] { run(); }) {}

SoundOutput::~SoundOutput() {
    ends_ = true;
    thread_.join();
}

void SoundOutput::update(float volume, const glm::vec3& place) {
    volume_.store(volume, std::memory_order_relaxed);
    x_.store(place.x, std::memory_order_relaxed);
    y_.store(place.y, std::memory_order_relaxed);
    z_.store(place.z, std::memory_order_relaxed);
}

std::string SoundOutput::sentence() const {
    if (!fault_.empty()) return phrase("sound.none", {{"reason", fault_}});
    return phrase(headModel_ ? "sound.plays_with_head" : "sound.plays", {{"device", device_}});
}

glm::vec3 SoundOutput::atDesk(const glm::vec3& eye) {
    const float distance = glm::length(eye);
    return distance > 0 ? eye * (kDeskDistance / distance) : glm::vec3(0, 0, -kDeskDistance);
}

void SoundOutput::run() {
    try {
        play();
    } catch (const std::exception& fault) {
        if (state_ == State::opening) fault_ = fault.what();
        state_.store(State::silent, std::memory_order_release);
    }
}

void SoundOutput::play() {
    const std::unique_ptr<OpenAlDevice> device = OpenAlDevice::openDefault();
    device_ = device->name();
    headModel_ = device->hasHeadModel();
    state_.store(State::plays, std::memory_order_release);
    SoundStream stream(feed_);
    std::array<std::int16_t, OpenAlDevice::kBlock> block{};
    while (!ends_) {
        device->volume(volume_.load(std::memory_order_relaxed));
        device->place({x_.load(std::memory_order_relaxed), y_.load(std::memory_order_relaxed),
                       z_.load(std::memory_order_relaxed)});
        for (size_t room = device->room(); room > 0; --room) {
            stream.fill(block);
            device->queue(block);
        }
        std::this_thread::sleep_for(kLook);
    }
}

} // namespace meltpool
