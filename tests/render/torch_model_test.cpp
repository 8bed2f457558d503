// The drawn torch: it stands behind its tip, follows the pose, and glows only with the trigger pulled.
#include "core/render/torch_model.hpp"
#include "core/weld/torch/torch_moves.hpp"
#include "tests/support/catch.hpp"

#include <glm/ext/matrix_transform.hpp>

using namespace meltpool;

namespace {

bool anyGlow(const std::vector<Solid>& solids) {
    for (const Solid& solid : solids)
        if (glm::length(solid.glow) > 0) return true;
    return false;
}

ProcessParameters with(ProcessKind kind) {
    ProcessParameters parameters;
    parameters.kind = static_cast<int>(kind);
    return parameters;
}

} // namespace

TEST_CASE("every process draws a torch that reaches from its tip to the handle", "[weld]") {
    TorchSample torch;
    torch.tip = {0.01f, 0.003f, -0.02f};
    torch.orientation = heldOrientation(0.9, 0.2, {1, 0, 0});
    const glm::mat4 world = glm::scale(glm::mat4(1), glm::vec3(25));
    for (const ProcessKind process : {ProcessKind::Flame, ProcessKind::Tig, ProcessKind::Gmaw, ProcessKind::Iron}) {
        std::vector<Solid> solids;
        torch.trigger = 0;
        buildTorchModel(solids, torch, with(process), world);
        REQUIRE(solids.size() >= 2);
        CHECK_FALSE(anyGlow(solids));
        float nearest = 1e9f, farthest = -1e9f;
        for (const Solid& solid : solids)
            for (const float end : {-0.5f, 0.5f}) {
                const glm::vec3 place = glm::vec3(solid.toWorld * glm::vec4(0, 0, end, 1)) / 25.0f;
                const float behind = glm::dot(place - torch.tip, -torch.axis());
                CHECK(glm::length(place - torch.tip + torch.axis() * behind) < 1e-4f); // on the axis
                nearest = std::min(nearest, behind);
                farthest = std::max(farthest, behind);
            }
        CHECK(nearest > -1e-4f);
        CHECK(nearest < 0.02f);
        CHECK(farthest > 0.05f);
        torch.trigger = 1;
        buildTorchModel(solids, torch, with(process), world);
        CHECK(anyGlow(solids) == (process != ProcessKind::Iron));
    }
}

TEST_CASE("an arc lights what is around it as much as its power says; flames and irons do not", "[weld]") {
    TorchSample torch;
    torch.tip = {0.01f, 0.003f, 0};
    torch.trigger = 1;
    ProcessParameters gmaw = with(ProcessKind::Gmaw);
    gmaw.voltage = 20;
    gmaw.current = 200;
    const ArcLight light = torchArcLight(torch, gmaw);
    CHECK(glm::length(light.position - torch.tip) < 0.002f);
    // 4 kW of arc give about 1600 cd: 6.4 klx at half a metre.
    CHECK(light.intensity.g * 160 == Approx(1592.0).epsilon(0.01));
    torch.trigger = 0.5f;
    CHECK(torchArcLight(torch, gmaw).intensity.g == Approx(light.intensity.g / 2));
    torch.trigger = 0;
    CHECK(torchArcLight(torch, gmaw).intensity.g == 0);
    torch.trigger = 1;
    CHECK(torchArcLight(torch, with(ProcessKind::Flame)).intensity.g == 0);
    CHECK(torchArcLight(torch, with(ProcessKind::Iron)).intensity.g == 0);
}
