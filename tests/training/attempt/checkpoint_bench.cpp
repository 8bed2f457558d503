#include "tests/training/attempt/checkpoint_bench.hpp"

#include "core/base/text.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <sstream>

namespace meltpool::test {

namespace {

constexpr float kMm = 1e-3F;
constexpr float kQuarterTurn = 1.5707963F;

Lesson shipped(const std::string& name) {
    return findLesson(name, testFolder().parent_path() / "app" / "data" / "lessons");
}

/// Returns a plate so hot that it melts within a second.
Lesson smallPlate(const std::string& name) {
    Lesson lesson = shipped(name);
    lesson.choose.clear(); // a test may set any parameter
    lesson.workpiece.lengthMm = 20;
    lesson.workpiece.widthMm = 14;
    lesson.workpiece.thicknessMm = 4;
    lesson.workpiece.temperatureC = 600;
    lesson.surface.cells = 24;
    return lesson;
}

Lesson smallCube() {
    Lesson lesson = shipped("solder-cube");
    lesson.workpiece.lengthMm = 10;
    lesson.workpiece.spacingMm = 1.25F;
    lesson.workpiece.temperatureC = 150;
    lesson.surface.cells = 24;
    return lesson;
}

Lesson smallClassic() {
    Lesson lesson = shipped("classic");
    lesson.setup.particles = 1000;
    lesson.metal.supportRadius = 0.15F;
    lesson.surface.cells = 16;
    return lesson;
}

/// Returns the height (m) of the process's tip over the middle of the upper face.
float heightOf(const std::string& process, size_t step) {
    if (process == "gtaw") return 2 * kMm;
    if (process == "gmaw") return 3 * kMm;
    if (process == "smaw") return step < 6 ? 0.0F : 2.5F * kMm; // the arc strikes by touch
    if (process == "flame") return 5 * kMm + 10 * kMm;          // height from the cube's middle
    if (process == "iron") return 5 * kMm + 0.5F * kMm;
    return 0;
}

/// Returns a rod in front of the torch that dips in and out.
RodSample rodBefore(const TorchSample& torch, size_t step) {
    RodSample rod;
    const float out = step % 20 < 10 ? 0.0F : 6 * kMm;
    rod.tip = torch.tip + glm::vec3(2 * kMm + out, -1.9F * kMm, 0);
    rod.orientation = glm::angleAxis(0.35F, glm::vec3(0, 0, 1)) * glm::angleAxis(kQuarterTurn, glm::vec3(0, 1, 0));
    rod.feed = 2 * kMm;
    return rod;
}

} // namespace

const std::vector<std::string>& checkpointProcesses() {
    static const std::vector<std::string> kAll{"flame", "gtaw", "gmaw", "smaw", "iron", "classic"};
    return kAll;
}

Lesson checkpointLesson(const std::string& process) {
    if (process == "classic") return smallClassic();
    if (process == "gtaw") return smallPlate("gtaw-rod");
    if (process == "gmaw") return smallPlate("gmaw-bead");
    if (process == "smaw") return smallPlate("smaw-bead");
    Lesson lesson = smallCube();
    if (process == "iron") lesson.process.choose<SolderingIron>() = {};
    return lesson;
}

TorchSample checkpointTorch(const std::string& process, size_t step) {
    TorchSample torch;
    const auto moved = static_cast<float>(step);
    if (process == "classic") {
        torch.tip = glm::vec3(16 * kMm - 0.05F * kMm * moved);
        torch.orientation = {1, 0, 0, 0};
    } else {
        torch.tip = {-4 * kMm + 0.06F * kMm * moved, heightOf(process, step), 0.3F * kMm * std::sin(0.4F * moved)};
        torch.orientation = glm::angleAxis(-kQuarterTurn, glm::vec3(1, 0, 0));
    }
    torch.trigger = step == 0 ? 0.0F : 1.0F;
    if (process == "gtaw") torch.rod = rodBefore(torch, step);
    return torch;
}

void runTo(Trainer& trainer, const std::string& process, size_t step) {
    while (trainer.steps() < step)
        trainer.advance(checkpointTorch(process, trainer.steps()), nullptr);
}

std::string endOf(Trainer& trainer) {
    const LessonResult result = trainer.result();
    const Judgement judgement = trainer.judge();
    std::ostringstream end;
    end.precision(17);
    end << "hash " << formatHexadecimal(result.stateHash) << ", step " << result.steps << ", time " << result.seconds
        << ", particles " << result.metal.particles << ", molten " << result.metal.molten << ", hottest "
        << result.metal.maxTemperature << ", lost " << result.metal.lost << ", fed " << result.wire.fed << ", melted "
        << result.wire.melted << ", arc " << arcActionName(trainer.arc().action) << " "
        << noArcName(trainer.arc().noArc) << " " << trainer.arc().length << " m " << trainer.arc().current << " A "
        << trainer.arc().voltage << " V " << trainer.arc().power << " W " << trainer.arc().rodEaten << " m of rod, "
        << judgement.arc.seconds << " s " << judgement.arc.energy << " J, " << judgement.seam.size()
        << " mm of seam, pace " << judgement.realTime;
    if (judgement.score) end << ", score " << judgement.score->total << judgement.score->reason;
    if (judgement.verdict) end << ", accepted " << judgement.verdict->accepted;
    if (const Technique* technique = trainer.technique()) {
        end << ", steps " << technique->steps().size() << ", direction " << technique->direction();
        for (const QuantityInfo& info : quantities(technique->settings().distance))
            end << " " << technique->now()[info.quantity];
        for (const TechniqueStep& step : technique->steps())
            end << " " << step.place << (step.joined ? "+" : "-");
    }
    return end.str();
}

} // namespace meltpool::test
