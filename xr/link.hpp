// The headset as something that comes and goes: looked for in the background, opened, lost, found again.
#pragma once

#include "xr/headset.hpp"

#include <chrono>
#include <memory>
#include <string>

namespace meltpool::xr {

enum class LinkState {
    searching, ///< no runtime or no headset yet; another look every now and then
    asleep,    ///< connected, but on nobody's head
    running,   ///< frames are asked for
    stalled,   ///< the runtime does not answer; taken again as soon as it does
    ended,     ///< the runtime asked the program to leave the headset; the desk goes on alone
};

/// Owns the headset while there is one. No call blocks for longer than Headset::kPatience, whatever the runtime does:
/// looking for one, opening a session and every call on it happen on other threads.
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
    Headset* headset() { return opened_ ? headset_.get() : nullptr; }
    const Headset* headset() const { return opened_ ? headset_.get() : nullptr; }
    /// A call on the headset failed: drops it, says why, and looks for it anew. The desk goes on whatever it was.
    void onFault(const XrFault& fault);
    /// A call on the headset was given up: the desk goes on alone until it is over.
    void onStall();
    /// Leaves the headset for good.
    void close();

    LinkState state() const { return state_; }
    /// Why there is no headset at the moment, as a sentence for the person; empty while there is one.
    const std::string& reason() const { return reason_; }
    /// How often a headset was opened.
    int openings() const { return openings_; }

  private:
    /// What a search finds. It may outlive this link, in a call that hangs.
    struct Search {
        std::atomic<bool> over = false;
        std::unique_ptr<Instance> instance;
        std::string reason;
    };

    static void look(Search& search);
    void search();
    bool open();
    void drop(std::string reason);
    void letGo();

    HeadsetSettings settings_;
    LinkState state_ = LinkState::searching;
    std::string reason_ = "looking for a headset";
    std::unique_ptr<Headset> headset_;
    std::shared_ptr<Search> looking_;
    std::shared_ptr<const std::atomic<bool>> gone_; ///< the last headset's instance is; a new one has to wait for it
    std::chrono::steady_clock::time_point nextLook_;
    std::chrono::milliseconds pause_;
    bool opened_ = false;
    int openings_ = 0;
};

/// What a failed connection means to a teacher, and what to do about it.
std::string explain(const XrFault& fault);

} // namespace meltpool::xr
