// The headset as something that comes and goes: looked for in the background, opened, lost, found again.
#pragma once

#include "xr/headset.hpp"

#include <chrono>
#include <future>
#include <optional>
#include <string>

namespace meltpool::xr {

enum class LinkState {
    searching, ///< no runtime or no headset yet; another look every now and then
    asleep,    ///< connected, but on nobody's head
    running,   ///< frames are asked for
    ended,     ///< the runtime asked the program to leave the headset; the desk goes on alone
};

/// Owns the headset while there is one. No call blocks for longer than the runtime takes to open a session; looking for
/// a runtime happens on a thread of its own, so the window stays alive.
class HeadsetLink {
  public:
    explicit HeadsetLink(HeadsetSettings settings);
    ~HeadsetLink();
    HeadsetLink(const HeadsetLink&) = delete;
    HeadsetLink& operator=(const HeadsetLink&) = delete;

    /// For the next opening.
    void use(const HeadsetSettings& settings) { settings_ = settings; }

    /// Once a frame: opens what was found, passes on the runtime's events, notices a loss. The context that is current
    /// draws.
    LinkState update();
    /// The headset while it is open; nullptr while searching.
    Headset* headset() { return headset_.get(); }
    const Headset* headset() const { return headset_.get(); }
    /// A call on the headset failed: drops it, says why, and looks for it anew. The desk goes on whatever it was.
    void onFault(const XrFault& fault);
    /// Leaves the headset for good.
    void close();

    LinkState state() const { return state_; }
    /// Why there is no headset at the moment, as a sentence for the person; empty while there is one.
    const std::string& reason() const { return reason_; }
    /// How often a headset was opened.
    int openings() const { return openings_; }

  private:
    struct Found {
        std::unique_ptr<Instance> instance;
        std::string reason;
    };

    static Found look();
    void search();
    void open(std::unique_ptr<Instance> instance);
    void drop(std::string reason);

    HeadsetSettings settings_;
    LinkState state_ = LinkState::searching;
    std::string reason_ = "looking for a headset";
    std::unique_ptr<Headset> headset_;
    std::optional<std::future<Found>> looking_;
    std::chrono::steady_clock::time_point nextLook_;
    std::chrono::milliseconds pause_;
    int openings_ = 0;
};

/// What a failed connection means to a teacher, and what to do about it.
std::string explain(const XrFault& fault);

} // namespace meltpool::xr
