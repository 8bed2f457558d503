// The drawn torch: it extends back from its tip, follows the pose, and glows only with the trigger pulled.
#include "core/scene/torch_model.hpp"
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

/// Returns an arc that burns 2 mm over the metal.
ArcState burning(const ProcessSettings& process) {
    ArcState arc;
    arc.action = ArcAction::burning;
    arc.share = 1;
    if (!isArcWelding(process)) return arc;
    arc.length = 2e-3f;
    arc.distance = process.is<Gmaw>() ? 14e-3f : 2e-3f;
    arc.extension = process.is<Gmaw>() ? 12e-3f : 0;
    arc.voltage = 20;
    arc.current = 200;
    return arc;
}

ProcessSettings with(int kind) {
    ProcessSettings settings;
    settings.kind = kind;
    return settings;
}

} // namespace

TEST_CASE("every process draws a torch that reaches from its tip to the handle", "[weld]") {
    TorchSample torch;
    torch.tip = {0.01f, 0.003f, -0.02f};
    torch.orientation = heldOrientation(0.9, 0.2, {1, 0, 0});
    const glm::mat4 world = glm::scale(glm::mat4(1), glm::vec3(25));
    for (int kind = 0; kind < int(AllProcesses::kCount); ++kind) {
        const ProcessSettings process = with(kind);
        std::vector<Solid> solids;
        buildTorchModel(solids, torch, process, {}, world);
        REQUIRE(solids.size() >= 2);
        CHECK_FALSE(anyGlow(solids));
        float nearest = 1e9f, farthest = -1e9f;
        for (const Solid& solid : solids)
            for (const float end : {-0.5f, 0.5f}) {
                const glm::vec3 place = glm::vec3(solid.toWorld * glm::vec4(0, 0, end, 1)) / 25.0f;
                const float behind = glm::dot(place - torch.tip, -torch.axis());
                CHECK(glm::length(place - torch.tip + torch.axis() * behind) < 1e-4f); // point on the axis
                nearest = std::min(nearest, behind);
                farthest = std::max(farthest, behind);
            }
        CHECK(nearest > -1e-4f);
        CHECK(nearest < 0.02f);
        CHECK(farthest > 0.05f);
        buildTorchModel(solids, torch, process, burning(process), world);
        CHECK(anyGlow(solids) == !process.is<SolderingIron>());
    }
}

TEST_CASE("the wire is drawn as far as it stands out", "[weld]") {
    TorchSample torch;
    ProcessSettings gmaw;
    gmaw.choose<Gmaw>().stickOutMm = 12;
    ArcState arc;
    std::vector<Solid> solids;
    for (const float extension : {5e-3f, 12e-3f, 40e-3f}) {
        arc.extension = extension;
        buildTorchModel(solids, torch, gmaw, arc, glm::mat4(1));
        const glm::vec3 end(solids.front().toWorld * glm::vec4(0, 0, 0.5f, 1));
        const glm::vec3 begin(solids.front().toWorld * glm::vec4(0, 0, -0.5f, 1));
        CHECK(glm::distance(begin, end) == Approx(extension));
    }
}

TEST_CASE("an arc lights what is around it as much as its power says; flames and irons do not", "[weld]") {
    TorchSample torch;
    torch.tip = {0.01f, 0.003f, 0};
    torch.trigger = 1;
    ProcessSettings gmaw;
    gmaw.choose<Gmaw>();
    ArcState arc = burning(gmaw);
    const ArcLight light = torchArcLight(torch, gmaw, arc);
    CHECK(glm::length(light.position - torch.tip) < 0.003f);
    // 4 kW of arc give about 1600 cd: 6.4 klx at half a metre.
    CHECK(light.intensity.g * 160 == Approx(1592.0).epsilon(0.01));
    arc.current /= 2;
    CHECK(torchArcLight(torch, gmaw, arc).intensity.g == Approx(light.intensity.g / 2));
    arc.action = ArcAction::out;
    CHECK(torchArcLight(torch, gmaw, arc).intensity.g == 0);
    int withoutArc = 0;
    for (int kind = 0; kind < static_cast<int>(AllProcesses::kCount); ++kind) {
        const ProcessSettings other = with(kind);
        if (isArcWelding(other)) continue;
        ++withoutArc;
        CHECK(torchArcLight(torch, other, burning(other)).intensity.g == 0);
    }
    CHECK(withoutArc >= 2);
}
