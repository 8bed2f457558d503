#include "core/training/feedback/arc_appearance.hpp"

#include "core/scene/torch_model.hpp"
#include "core/weld/workpiece/position.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace meltpool {

void ArcAppearance::open(const SceneView& metal) {
    SpatterGround ground;
    ground.blocks = metal.blocks;
    ground.up = glm::normalize(glm::transpose(glm::mat3(metal.modelToWorld)) * glm::vec3(0, 1, 0));
    ground.table = lowestAlong(ground.up, metal.boxMin, metal.boxMax);
    effects_.setGround(ground);
}

void ArcAppearance::step(const ProcessSettings& process, const SoundStep& heard, const TorchSample& torch,
                         std::uint64_t number) {
    std::array<Reignition, ShortCircuits::kMost> reignitions;
    for (size_t i = 0; i < heard.shortCount; ++i)
        reignitions[i] = {heard.shorts[i].at, heard.shorts[i].power};
    ArcEffectsStep step;
    step.number = number;
    step.time = torch.time;
    step.seconds = heard.seconds;
    step.process = &process;
    step.arc = heard.arc;
    step.place = torchArcLight(torch, process, heard.arc).position;
    step.axis = torch.axis();
    step.wireEnd = torch.tip + step.axis * (heard.arc.extension - static_cast<float>(heldBehind(process)));
    step.reignitions = std::span(reignitions).first(heard.shortCount);
    step.shortPhase = heard.shortPhase;
    step.dropRate = static_cast<double>(heard.dropRate);
    effects_.step(step);
}

} // namespace meltpool
