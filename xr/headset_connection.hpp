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
    asleep,    ///< connected, but not worn
    running,   ///< the runtime asks for frames
    stalled,   ///< the runtime does not answer; used again as soon as it does
    ended,     ///< the runtime asked the program to leave the headset; the window continues without it
};

/// Owns the headset while there is one. No call blocks for longer than Headset::kPatience, even if the runtime hangs:
/// the search, the opening of a session and every call on it run on other threads.
class HeadsetConnection {
  public:
    explicit HeadsetConnection(HeadsetSettings settings);
    ~HeadsetConnection();
    HeadsetConnection(const HeadsetConnection&) = delete;
    HeadsetConnection& operator=(const HeadsetConnection&) = delete;

    /// Settings for the next session.
    void use(const HeadsetSettings& settings) { settings_ = settings; }

    /// Call it once a frame: opens a headset that was found, polls the runtime's events, notices a loss. The eyes are
    /// drawn with the OpenGL context that is current at the opening.
    ConnectionState update();
    /// The headset while it is open; nullptr while searching.
    Headset* headset() { return opened_ ? headset_.get() : nullptr; }
    const Headset* headset() const { return opened_ ? headset_.get() : nullptr; }
    /// Call it after a failed call on the headset: closes it, stores the reason, and searches again.
    void onFault(const XrFault& fault);
    /// Call it after an abandoned call on the headset: the headset is unused until the call is over.
    void onStall();
    /// Closes the headset and stops searching.
    void close();

    ConnectionState state() const { return state_; }
    /// Reason why there is no headset at the moment, as a sentence for the person; empty while there is one.
    const std::string& reason() const { return reason_; }
    /// True if the file that names the runtime is at fault.
    bool manifestAtFault() const { return manifestAtFault_; }
    /// Time for which a runtime may answer that it has no headset before the search counts as hopeless. Time in which
    /// the machine is too busy to answer does not count.
    static constexpr std::chrono::seconds kPatience{15};
    /// True if no runtime can be loaded, so that a headset needs a change of the machine's settings, or if searches
    /// have found none for kPatience.
    bool hopeless() const;
    /// Number of openings of a headset.
    int openings() const { return openings_; }

  private:
    /// The result of a search. A call that hangs may make it outlive the connection.
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
    std::shared_ptr<const std::atomic<bool>> gone_; ///< true once the last instance is destroyed; before that none may
                                                    ///< be made
    std::chrono::steady_clock::time_point nextLook_;
    /// Time of the first failed search since the last opening.
    std::optional<std::chrono::steady_clock::time_point> failedSince_;
    std::chrono::milliseconds pause_;
    bool opened_ = false;
    bool manifestAtFault_ = false;
    bool noRuntime_ = false;
    int openings_ = 0;
};

/// Explains a failed call and its remedy, as a sentence for the person.
std::string explain(const XrFault& fault);

} // namespace meltpool::xr
