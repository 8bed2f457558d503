// What the headset shows besides the metal: floor, table, torch and pointer, as simple solids.
#pragma once

#include "app/headset/tracked_torch.hpp"
#include "core/render/solids.hpp"
#include "core/scene/bench_things.hpp"
#include "core/weld/process/processes.hpp"

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
    /// What the torch in the hand is for; null: a plain one, on a plain table.
    const ProcessSettings* process = nullptr;
    float extension = 0;                 ///< m, of its wire or electrode, see ArcState; 0: as it is set
    std::optional<xr::Pose> rod;         ///< grip of the hand that holds the filler rod
    std::span<const Solid> toolFittings; ///< of `tools`, instead of those of the hands; in the lesson's world
    std::span<const Solid> holders;      ///< what holds the workpiece, likewise
};

class WorkshopScene {
  public:
    /// How far a filler rod reaches out of the hand, m.
    static constexpr float kRodReach = 0.30f;

    WorkshopScene();
    /// The solids of this frame, in the workshop, m; valid until the next call. Allocates nothing after the first.
    std::span<const Solid> build(const HeadsetParameters& parameters, const HandsView& hands);
    /// The finer solids of torch and hands of the last build(), see SceneView::fittings.
    std::span<const Solid> fittings() const { return fittings_; }
    /// Table, machine and what holds the workpiece, of the last build() for a process; see SceneView::furniture.
    std::span<const Solid> furniture() const { return furniture_; }

  private:
    /// What table and machine follow from.
    struct FurnitureKey {
        float tableHeight = 0;
        int process = 0;
        std::array<MachineDisplay, 2> displays{};
        bool operator==(const FurnitureKey&) const = default;
    };

    void addProcessTorch(const HeadsetParameters& parameters, const HandsView& hands);
    void addGlow(const HandsView& hands);
    void furnish(const HeadsetParameters& parameters, const HandsView& hands);
    void addRoom(float tableHeight);
    void addTorch(const HandsView& hands);
    void add(SolidShape shape, const glm::mat4& toWorld, const glm::vec3& colour, float gloss,
             const glm::vec3& glow = glm::vec3(0.0f));

    std::vector<Solid> solids_;
    std::vector<Solid> fittings_;
    std::vector<Solid> furniture_;
    std::vector<Solid> torch_;
    std::optional<FurnitureKey> furnished_;
    size_t standing_ = 0; ///< how many of the furniture are table and machine
};

} // namespace meltpool
