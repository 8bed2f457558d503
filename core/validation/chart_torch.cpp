#include "core/validation/chart_torch.hpp"

#include <cmath>

namespace meltpool {

namespace {

constexpr double kWireStarts = 0.25;   // s until the arc of a wire has a pool
constexpr double kTungstenPools = 3;   // s until the arc of a tungsten electrode has one
constexpr double kLowers = 0.06;       // s
constexpr double kTouches = 0.08;      // s on the metal, too short to stick
constexpr double kLifts = 0.07;        // s
constexpr double kElectrodePools = 0.6; // s until the arc of a covered electrode has one
constexpr float kPressed = 0.3e-3F; // m by which the hand goes deeper than the metal

/// Collects moves, each from where the last one ended.
class Hand {
  public:
    explicit Hand(const ChartHand& hand) : hand_(hand) {
        orientation_ = heldOrientation(hand.held.workAngle, hand.held.travelAngle, {1, 0, 0});
        at_ = place(hand.from, hand.held.height);
    }

    void touch() {
        move(kLowers, place(hand_.from, -kPressed));
        move(kTouches, at_);
        move(kLifts, place(hand_.from, hand_.held.height));
    }

    void wait(double seconds) { follow(move(seconds, at_)); }

    void weld() {
        TorchMove& run = move(hand_.travel, place(hand_.to, hand_.held.height));
        if (run.rod) run.rod->frequency = hand_.rod->frequency;
        if (hand_.weave.width > 0) {
            run.weaveSide = acrossSeam({1, 0, 0});
            run.weaveWidth = hand_.weave.width;
            run.weaveHalfSwings = static_cast<int>(std::lround(2 * hand_.weave.frequency * hand_.travel));
        }
        follow(run);
    }

    TorchPath path() const { return TorchPath(moves_); }

  private:
    glm::vec3 handle() const { return orientation_ * glm::vec3(0, 0, 1); }

    glm::vec3 place(double along, float height) const {
        return glm::vec3(static_cast<float>(along), 0, static_cast<float>(hand_.aim)) + handle() * height;
    }

    TorchMove& move(double seconds, const glm::vec3& to) {
        TorchMove next;
        next.begin = moves_.empty() ? 0 : moves_.back().begin + moves_.back().duration;
        next.duration = seconds;
        next.from = at_;
        next.to = at_ = to;
        next.fromOrientation = next.toOrientation = orientation_;
        next.trigger = 1;
        next.rod = restingRod();
        return moves_.emplace_back(next);
    }

    void follow(TorchMove& run) {
        run.followed = followed_;
        run.follow = hand_.follow;
        followed_ += hand_.follow * run.duration;
    }

    std::optional<RodHold> restingRod() const {
        std::optional<RodHold> rod = hand_.rod;
        if (!rod) return rod;
        rod->travel = {1, 0, 0};
        rod->up = glm::normalize(handle() - handle().x * rod->travel);
        rod->frequency = 0;
        return rod;
    }

    const ChartHand& hand_;
    double followed_ = 0; ///< m
    glm::quat orientation_;
    glm::vec3 at_{0};
    std::vector<TorchMove> moves_;
};

bool touches(const ProcessSettings& process) {
    return traitsOf(process).striking == Striking::touch;
}

double waits(const ProcessSettings& process) {
    if (touches(process)) return kElectrodePools;
    return equipmentOf(process).wireRate() > 0 ? kWireStarts : kTungstenPools;
}

} // namespace

double strikingSeconds(const ProcessSettings& process) {
    return waits(process) + (touches(process) ? kLowers + kTouches + kLifts : 0);
}

TorchPath chartPath(const ChartHand& hand, const ProcessSettings& process) {
    Hand path(hand);
    if (touches(process)) path.touch();
    path.wait(waits(process));
    path.weld();
    return path.path();
}

} // namespace meltpool
