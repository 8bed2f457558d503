// The time of a replayed attempt: its position, its speed, and a requested position.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>

namespace meltpool {

/// Time line of a replay. It holds the requests and the reached time; the maker of the steps reports to it. All times
/// are s of the metal's.
class ReplayTimeline {
  public:
    static constexpr double kSlowest = 0.1, kFastest = 4; ///< attempt's time over real time
    static constexpr double kKeyStep = 1;                 ///< s per stroke of an arrow key

    /// Starts, playing at the attempt's own speed. `duration`: s. `start`: time to begin at, s; the metal is brought
    /// there first.
    void begin(double duration, double start = 0) {
        *this = {};
        duration_ = duration;
        playing_ = true;
        start_ = std::clamp(start, 0.0, duration);
        if (start_ > 0) seek(start_);
    }
    void end() { *this = {}; }

    /// True if steps follow the clock; during a seek, once it ends.
    bool playing() const { return playing_; }
    double time() const { return time_; }
    double duration() const { return duration_; }
    /// Time at which playing begins: what is before it is skipped.
    double start() const { return start_; }
    double speed() const { return speed_; }
    /// True once the last step was made.
    bool over() const { return over_; }

    /// Pauses or continues; at the end it starts again.
    void toggle() {
        const bool again = over_ && !seeking();
        if (again) seek(start_);
        playing_ = again || !playing_;
    }
    void setSpeed(double speed) { speed_ = std::clamp(speed, kSlowest, kFastest); }

    /// Requests another time.
    void seek(double time) {
        target_ = std::clamp(time, 0.0, duration_);
        fresh_ = true;
    }
    bool seeking() const { return target_.has_value(); }
    /// Requested time; time() without a request.
    double target() const { return target_.value_or(time_); }
    /// Returns true once after each seek(), for the maker of the steps to choose their start.
    bool takeFresh() { return std::exchange(fresh_, false); }
    /// Starts the steps to the target at this time.
    void stepFrom(double time) {
        from_ = time_ = time;
        over_ = false;
    }
    /// Share of the way to the target, 0..1.
    double progress() const {
        const double way = target() - from_;
        return way > 0 ? std::clamp((time_ - from_) / way, 0.0, 1.0) : 1;
    }

    /// Takes a step of `step` s that reached `time`; `last`: the attempt has no more. The target counts as reached at
    /// the step nearest to it.
    void reach(double time, double step, bool last) {
        time_ = std::min(time, duration_);
        over_ = last;
        if (target_ && !fresh_ && (last || time >= *target_ - 0.5 * step)) target_.reset();
        if (last && !target_) playing_ = false;
    }

  private:
    bool playing_ = false;
    bool over_ = false;
    bool fresh_ = false;
    double time_ = 0;
    double duration_ = 0;
    double start_ = 0;
    double speed_ = 1;
    double from_ = 0;
    std::optional<double> target_;
};

} // namespace meltpool
