// A hand that welds along the seam of a small lesson.
#pragma once

#include "app/session/lesson_session.hpp"

namespace meltpool::test {

/// Holds the torch upright at a height over the plate, 10 mm before the middle of the seam at first, and leads it along
/// the seam while the trigger is pulled.
class SeamHand {
  public:
    static constexpr double kFrame = 1.0 / 45; ///< s
    static constexpr float kHeight = 3e-3f;    ///< m
    static constexpr float kSpeed = 8e-3f;     ///< m/s

    /// Runs `seconds` in frames of kFrame.
    void lead(LessonSession& session, const Controls& controls, double seconds, float trigger, float height = kHeight) {
        for (double time = 0; time < seconds; time += kFrame)
            frame(session, controls, kFrame, trigger, height);
    }
    /// Runs one frame of `seconds`.
    void frame(LessonSession& session, const Controls& controls, double seconds, float trigger,
               float height = kHeight) {
        session.advance(controls, seconds, nullptr, [&](int, int steps) {
            if (trigger > 0) x_ += kSpeed * static_cast<float>(seconds / steps);
            return held(trigger, height);
        });
    }
    /// Goes back to the beginning.
    void goBack() { x_ = kBegin; }
    /// Place along the seam, m.
    float place() const { return x_; }

  private:
    TorchSample held(float trigger, float height) const {
        TorchSample torch;
        torch.tip = {x_, height, 0};
        torch.orientation = glm::angleAxis(-1.5707963f, glm::vec3(1, 0, 0));
        torch.trigger = trigger;
        return torch;
    }

    static constexpr float kBegin = -0.010f; ///< m
    float x_ = kBegin;
};

} // namespace meltpool::test
