// A quantity over the time of an attempt, at even intervals, as far as it has been played.
#pragma once

#include <span>
#include <vector>

namespace meltpool {

class CurveTrack {
  public:
    static constexpr size_t kPlaces = 400; ///< count of values, as many as a time line is wide

    /// Sets all values to unknown. `duration`: s.
    void begin(double duration);
    /// Adds the value at `time`; NaN is unknown. A known value stays when that time is played again.
    void add(double time, double value);

    /// kPlaces values from the start to the end, NaN if unknown.
    std::span<const float> values() const { return values_; }
    float least() const { return least_; } ///< least known value; 0 without any
    float most() const { return most_; }

  private:
    std::vector<float> values_;
    double duration_ = 0;
    float least_ = 0, most_ = 0;
    bool known_ = false;
};

} // namespace meltpool
