#include "core/training/trainer/classic_model.hpp"

#include "core/surface/surface.hpp"
#include "core/training/lesson/lesson.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

/// The box with its source; everything else is the default of a SceneView.
class ClassicScene : public MetalScene {
  public:
    ClassicScene(const bool& cold, const ClassicParameters& parameters) : cold_(cold), parameters_(parameters) {}

    SceneView view(const TorchSample& torch) override {
        SceneView scene;
        scene.source.shown = true;
        scene.source.position = classicSourcePosition(torch.tip);
        scene.source.on = torch.trigger > 0;
        scene.source.cold = cold_;
        scene.source.reach = std::sqrt(parameters_.heatRadius);
        return scene;
    }

  private:
    // of the metal, whose lesson may change them
    const bool& cold_;
    const ClassicParameters& parameters_;
};

} // namespace

glm::vec3 classicSourcePosition(const glm::vec3& tip) {
    return glm::clamp(tip / kClassicUnit, glm::vec3(-1.0f), glm::vec3(1.0f));
}

ClassicModel::ClassicModel(gl::ShaderLibrary& shaders, const Lesson& lesson) : metal_(shaders, lesson.setup) {
    apply(lesson);
}

void ClassicModel::apply(const Lesson& lesson) {
    metal_.parameters = lesson.metal;
    cold_ = lesson.source.kind == 1;
}

void ClassicModel::step(const TorchSample& torch, gl::Profiler* profiler) {
    trigger_ = torch.trigger;
    metal_.step({classicSourcePosition(torch.tip), torch.trigger, cold_}, profiler);
}

float ClassicModel::liquidShare(float temperature) const {
    return std::clamp(temperature, 0.0f, 1.0f);
}

ArcState ClassicModel::arc(const SurfaceDistance& surface) const {
    ArcState state;
    state.distance = surface.ahead;
    state.liquid = surface.liquid;
    const float reach = std::sqrt(metal_.parameters.heatRadius) * kClassicUnit;
    if (trigger_ <= 0 || !(surface.nearest < reach)) return state;
    state.action = ArcAction::burning;
    state.share = std::min(trigger_, 1.0F) * (1 - std::max(surface.nearest, 0.0F) / reach);
    return state;
}

void ClassicModel::prepare(Surface& surface) const {
    // Less than a fiftieth of a cell or a thousandth of the temperature range is invisible.
    surface.incremental = {true, 0.02F, 0.001F};
}

std::unique_ptr<MetalScene> ClassicModel::makeScene() const {
    return std::make_unique<ClassicScene>(cold_, metal_.parameters);
}

} // namespace meltpool
