#include "core/training/feedback/sound/sound_step.hpp"

#include "core/weld/process/shielding_gas.hpp"
#include "core/weld/process/weld_constants.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr double kMm = 1e-3;

bool isOpen(const ArcState& arc) {
    return arc.action == ArcAction::burning || arc.action == ArcAction::breaking;
}

} // namespace

double wireDropRate(double diameter, double speed, double current, const ShieldingGas& gas) {
    const double share = sprayShare(current, diameter / kMm, gas);
    const double drop = diameter * std::lerp(kGlobularDrop, 1.0, share);
    // A cylinder of wire becomes balls: speed pi d²/4 = rate pi D³/6.
    return 1.5 * speed * diameter * diameter / (drop * drop * drop);
}

void SoundSource::reset() {
    shorts_.reset();
    last_ = {};
    tip_.reset();
}

void SoundSource::transfer(gl::StateArchive& archive) {
    shorts_.transfer(archive);
    bool known = tip_.has_value();
    archive.values(known);
    if (archive.restores()) tip_ = known ? std::optional(glm::vec3(0)) : std::nullopt;
    if (tip_) archive.values(*tip_);
}

void SoundSource::step(const ProcessSettings& settings, const ArcState& arc, const TorchSample& torch, double seconds,
                       double hottest) {
    const Equipment tools = equipmentOf(settings);
    shorts_.step(arc, seconds, tools.controlledShorts);
    last_ = {};
    last_.seconds = seconds;
    last_.process = &traitsOf(settings);
    last_.arc = arc;
    last_.trigger = std::clamp(torch.trigger, 0.0F, 1.0F);
    last_.hottest = static_cast<float>(hottest);
    if (tip_ && seconds > 0) last_.tipSpeed = glm::distance(*tip_, torch.tip) / static_cast<float>(seconds);
    tip_ = torch.tip;
    if (alternating_) last_.alternating = last_.process->alternating;
    last_.withoutGas = tools.withoutGas();
    if (tools.wire > 0 && isOpen(arc))
        last_.dropRate = std::max(static_cast<float>(wireDropRate(tools.wire, tools.wireSpeed,
                                                                  static_cast<double>(arc.current), *tools.gas)) -
                                      arc.shorts,
                                  0.0F); // a drop that bridges the arc does not fall
    last_.shortPhase = shorts_.phase();
    last_.shortCount = shorts_.last().size();
    std::copy(shorts_.last().begin(), shorts_.last().end(), last_.shorts.begin());
}

} // namespace meltpool
