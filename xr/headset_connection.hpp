// Finds a headset in the background, opens it, notices its loss and finds it again.
#pragma once

#include "xr/headset.hpp"

#include <chrono>
#include <memory>
#include <optional>
#include <string>

namespace meltpool::xr {

enum class ConnectionState {
    searching, ///< no runtime or no headset yet; the search is repeated
    asleep,    ///< connected, but nobody wears it
    running,   ///< the runtime asks for frames
    stalled,   ///< the runtime does not answer; used again as soon as it does
    ended,     ///< the runtime asked the program to leave the headset; the window continues without it
};

/// Owns the headset while there is one. No call blocks for longer than Headset::kPatience, whatever the runtime does:
/// looking for one, opening a session and every call on it happen on other threads.
class HeadsetConnection {
  public:
    explicit HeadsetConnection(HeadsetSettings settings);
    ~HeadsetConnection();
    HeadsetConnection(const HeadsetConnection&) = delete;
    HeadsetConnection& operator=(const HeadsetConnection&) = delete;

    /// Settings for the next session.
    void use(const HeadsetSettings& settings) { settings_ = settings; }

    /// To be called once a frame: opens a headset that was found, polls the runtime's events, notices a loss. The eyes
    /// are drawn with the OpenGL context that is current at the opening.
    ConnectionState update();
    /// The headset while it is open; nullptr while searching.
    Headset* headset() { return opened_ ? headset_.get() : nullptr; }
    const Headset* headset() const { return opened_ ? headset_.get() : nullptr; }
    /// A call on the headset failed: closes it, keeps the reason, and searches again.
    void onFault(const XrFault& fault);
    /// A call on the headset was given up: the headset is not used until the call is over.
    void onStall();
    /// Closes the headset and searches no more.
    void close();

    ConnectionState state() const { return state_; }
    /// Why there is no headset at the moment, as a sentence for the person; empty while there is one.
    const std::string& reason() const { return reason_; }
    /// The file that names the runtime is at fault.
    bool manifestAtFault() const { return manifestAtFault_; }
    /// How long a runtime may answer that it has no headset before there is none to be hoped for. A machine that is too
    /// busy to answer is not counted.
    static constexpr std::chrono::seconds kPatience{15};
    /// No runtime can be loaded, so that no headset is found until somebody changes the machine's settings; or searches
    /// have found none for kPatience.
    bool hopeless() const;
    /// How often a headset was opened.
    int openings() const { return openings_; }

  private:
    /// The result of a search. A call that hangs may keep it longer than the connection lives.
    struct Search {
        std::atomic<bool> over = false;
        std::unique_ptr<Instance> instance;
        std::string reason;
        bool manifestAtFault = false;
        bool noRuntime = false;
    };

    static void look(Search& search);
    void search();
    void noteFailure();
    bool open();
    void lose(std::string reason);
    void release();

    HeadsetSettings settings_;
    ConnectionState state_ = ConnectionState::searching;
    std::string reason_ = "looking for a headset";
    std::unique_ptr<Headset> headset_;
    std::shared_ptr<Search> looking_;
    std::shared_ptr<const std::atomic<bool>> gone_; ///< the last instance is destroyed; before that none may be made
    std::chrono::steady_clock::time_point nextLook_;
    /// The first failed search since the last opening.
    std::optional<std::chrono::steady_clock::time_point> failedSince_;
    std::chrono::milliseconds pause_;
    bool opened_ = false;
    bool manifestAtFault_ = false;
    bool noRuntime_ = false;
    int openings_ = 0;
};

/// What a failed call means and what to do about it, as a sentence for the person.
std::string explain(const XrFault& fault);

} // namespace meltpool::xr
