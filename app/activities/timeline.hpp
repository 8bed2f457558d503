// The time of an attempt that is played again: where it stands, how fast it goes, and where it is to be brought to.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>

namespace meltpool {

/// Only tells what is wanted and what was reached; who makes the steps tells it of them. All times s of the metal's.
class ReplayTimeline {
  public:
    static constexpr double kSlowest = 0.1, kFastest = 4; ///< attempt's time over real time
    static constexpr double kKeyStep = 1;                 ///< s, of a stroke of an arrow key

    /// From the start, playing at the attempt's own speed. `duration` s.
    void begin(double duration) {
        *this = {};
        duration_ = duration;
        playing_ = true;
    }
    void end() { *this = {}; }

    /// Steps follow the clock; while it seeks, as soon as the place is reached.
    bool playing() const { return playing_; }
    double time() const { return time_; }
    double duration() const { return duration_; }
    double speed() const { return speed_; }
    /// The last step has been made.
    bool over() const { return over_; }

    /// Pauses, or goes on; at the end it begins again.
    void toggle() {
        const bool again = over_ && !seeking();
        if (again) seek(0);
        playing_ = again || !playing_;
    }
    void setSpeed(double speed) { speed_ = std::clamp(speed, kSlowest, kFastest); }

    /// Asks for another moment.
    void seek(double time) {
        target_ = std::clamp(time, 0.0, duration_);
        fresh_ = true;
    }
    bool seeking() const { return target_.has_value(); }
    /// Where it is to be brought to; time() where nothing is asked for.
    double target() const { return target_.value_or(time_); }
    /// True once after each seek(): whoever makes the steps decides where they begin.
    bool takeFresh() { return std::exchange(fresh_, false); }
    /// The steps to the target begin at this time.
    void stepFrom(double time) {
        from_ = time_ = time;
        over_ = false;
    }
    /// Share of the way to the target, 0..1.
    double progress() const {
        const double way = target() - from_;
        return way > 0 ? std::clamp((time_ - from_) / way, 0.0, 1.0) : 1;
    }

    /// A step of `step` s has come to `time`; `last`: the attempt has no more. The target is reached by the step that
    /// is nearest to it.
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
    double speed_ = 1;
    double from_ = 0;
    std::optional<double> target_;
};

} // namespace meltpool
