// Builds the headset's picture apart from the metal: floor, table, torch and pointer, as simple solids.
#pragma once

#include "app/headset/tracked_torch.hpp"
#include "core/render/solids.hpp"
#include "core/scene/torch_geometry.hpp"
#include "core/scene/workshop_furniture.hpp"
#include "core/weld/process/processes.hpp"

#include <optional>
#include <span>
#include <vector>

namespace meltpool {

/// Tools in the hands in this frame, in the workshop.
struct HandsView {
    bool torch = false;
    bool laidAside = false; ///< the hand holds no torch: another torch, of a demonstration or replay, welds
    xr::Pose tip;
    HandPose holder;                       ///< hand that holds the torch
    float heat = 0;                        ///< 0..1: brightness of the tip's glow
    std::optional<glm::vec3> arcGlow = {}; ///< light of the torch's arc; none: a small glow that follows the heat
    std::optional<glm::vec3> rayStart;     ///< start of the pointer's ray
    glm::vec3 rayEnd{0.0f};
    std::span<const Solid> tools;    ///< the demonstration's torch, or the filler rod, in the lesson's world
    glm::mat4 toolsToWorkshop{1.0f}; ///< transform from the lesson's world
    /// Process of the torch in the hand, drawn with hands and fittings in a furnished workshop; null: see plainly.
    const ProcessSettings* process = nullptr;
    /// Process of a torch that is drawn without fittings, on a plain table; null: a plain torch.
    const ProcessSettings* plainly = nullptr;
    float extension = 0;         ///< m, of the wire or electrode, see ArcState; 0: the set length
    float burnt = 0;             ///< m of the electrode that have burnt off before `tip`
    std::optional<HandPose> rod; ///< hand that holds the filler rod
    /// Torch of a demonstration or replay, in the workpiece's frame; null: the hand's own, or hidden by a cut.
    const TorchSample* demonstrated = nullptr;
    glm::mat4 workpieceToWorkshop{1.0f}; ///< transform of its frame
    bool rightHand = true;               ///< the torch's hand, of the person who watches, too
    bool machineRight = true;            ///< side of the machine; the panel is on the other one
    std::span<const Solid> holders;      ///< holders of the workpiece, in the lesson's world
};

class WorkshopScene {
  public:
    /// Length of a filler rod out of the hand, m.
    static constexpr float kRodReach = 0.30f;

    WorkshopScene();
    /// Builds the solids of this frame, in the workshop, m; valid until the next call. Allocates nothing after the
    /// first.
    std::span<const Solid> build(const HeadsetParameters& parameters, const HandsView& hands);
    /// Finer solids of torch and hands of the last build(), see SceneView::fittings.
    std::span<const Solid> fittings() const { return fittings_; }
    /// Torch and hands of the last build(), the finer ones where it made them; see SceneView::hands.
    std::span<const Solid> hands() const;
    /// Table, machine and holders of the workpiece, of the last build() for a process; see SceneView::furniture.
    std::span<const Solid> furniture() const { return furniture_; }

  private:
    /// Values that table and machine depend on.
    struct FurnitureKey {
        float tableHeight = 0;
        int process = 0;
        std::array<MachineDisplay, 2> displays{};
        bool right = true; ///< side of the machine
        bool operator==(const FurnitureKey&) const = default;
    };

    void addProcessTorch(const HeadsetParameters& parameters, const HandsView& hands, const ProcessSettings& process);
    void addDemonstratedTorch(const HeadsetParameters& parameters, const HandsView& hands);
    void addGlow(const HandsView& hands);
    void furnish(const HeadsetParameters& parameters, const HandsView& hands);
    void addRoom(float tableHeight);
    void addTorch(const HandsView& hands);
    void addHandle(const HandsView& hands, const TorchGeometry& torch);
    void addEmptyHand(const HandsView& hands);
    void addRodHand(const HandsView& hands);
    void add(SolidShape shape, const glm::mat4& toWorld, const glm::vec3& colour, float gloss,
             const glm::vec3& glow = glm::vec3(0.0f));

    std::vector<Solid> solids_;
    size_t room_ = 0; ///< number of the first solids that are a plain room
    std::vector<Solid> fittings_;
    std::vector<Solid> furniture_;
    std::vector<Solid> torch_;
    std::vector<Solid> demonstrated_; ///< fittings of a demonstration's torch
    std::optional<FurnitureKey> furnished_;
    size_t standing_ = 0; ///< number of furniture solids that are table and machine
};

} // namespace meltpool
