#include "app/session/torch_lead.hpp"

#include "core/training/trainer/classic_model.hpp"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

#include <utility>

namespace meltpool {

namespace {

/// Torch of the source. `turn`: from the workpiece's frame to the room's, in which the source is steered.
TorchSample torchOf(const SteeredSource& source, const glm::mat3& turn) {
    const glm::mat3 toWorkpiece = glm::transpose(turn);
    TorchSample sample;
    sample.tip = toWorkpiece * (source.position() * kClassicUnit);
    const glm::quat down = glm::angleAxis(-glm::half_pi<float>(), glm::vec3(1, 0, 0));
    sample.orientation = glm::quat_cast(toWorkpiece) * down;
    sample.trigger = source.on() ? 1.0f : 0.0f;
    return sample;
}

/// Returns true if the trigger only switches: the wire of a machine that feeds it, or the current of an electrode that
/// strikes by touch.
bool triggerIsSwitch(const ProcessSettings& settings) {
    const ProcessTraits& traits = traitsOf(settings);
    return traits.feedsWire || traits.striking == Striking::touch;
}

} // namespace

TorchLeader TorchLead::leader(const Allowed& allowed) const {
    if (!allowed.ownTorch) return allowed.values ? TorchLeader::path : TorchLeader::none;
    return held_ ? TorchLeader::hand : TorchLeader::desk;
}

void TorchLead::update(const Controls& controls, const glm::mat3& toScreen, double seconds,
                       const ProcessSettings& process) {
    desk_.update(controls.hand(), {toScreen, seconds}, controls.parameters, process);
}

TorchSample TorchLead::next(const Trainer& trainer, const Controls& controls, const TorchSource& held,
                            const glm::mat3& turn, int step, int steps) {
    if (std::exchange(heldBefore_, held_) != held_ && trainer.torch().trigger > 0) {
        TorchSample out = trainer.torch();
        out.trigger = 0;
        return out;
    }
    TorchSample sample = personal(trainer, controls, held, turn, step, steps);
    if (trainer.lesson().model == LessonModel::Weld && triggerIsSwitch(trainer.lesson().process))
        sample.trigger = switch_.pass(sample.trigger);
    return sample;
}

TorchSample TorchLead::personal(const Trainer& trainer, const Controls& controls, const TorchSource& held,
                                const glm::mat3& turn, int step, int steps) {
    if (held_) return held(step, steps);
    if (!desk_.leads()) return torchOf(controls.source(), turn);
    return desk_.next(step, steps, trainer.timeStep(), trainer.metal().model().burntOff(), controls.trigger());
}

} // namespace meltpool
