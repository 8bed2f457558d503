// What the headset shows besides the metal: floor, table, torch and pointer, as simple solids.
#pragma once

#include "app/headset/torch/tracked_torch.hpp"
#include "core/render/solids.hpp"

#include <optional>
#include <span>
#include <vector>

namespace meltpool {

/// What the hands hold in this frame, in the workshop.
struct HandsView {
    bool torch = false;
    xr::Pose tip;
    xr::Pose grip;
    float heat = 0;                        ///< 0..1: how bright the tip glows
    std::optional<glm::vec3> arcGlow = {}; ///< light of its arc; none: a small glow that follows the heat
    std::optional<glm::vec3> rayStart;     ///< of the pointer
    glm::vec3 rayEnd{0.0f};
    std::span<const Solid> tools;    ///< the demonstration's torch, or the filler rod, in the lesson's world
    glm::mat4 toolsToWorkshop{1.0f}; ///< of that world
};

class WorkshopScene {
  public:
    /// How far a filler rod reaches out of the hand, m.
    static constexpr float kRodReach = 0.30f;

    WorkshopScene();
    /// The solids of this frame, in the workshop, m; valid until the next call. Allocates nothing after the first.
    std::span<const Solid> build(const HeadsetParameters& parameters, const HandsView& hands);

  private:
    void addRoom(float tableHeight);
    void addTorch(const HandsView& hands);
    void add(SolidShape shape, const glm::mat4& toWorld, const glm::vec3& colour, float gloss,
             const glm::vec3& glow = glm::vec3(0.0f));

    std::vector<Solid> solids_;
};

} // namespace meltpool
