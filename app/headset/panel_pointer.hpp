// Opens, closes and places the panel in the workshop, and chooses the hand that points at it.
#pragma once

#include "app/headset/headset_panel.hpp"
#include "app/headset/headset_parameters.hpp"
#include "app/headset/workshop.hpp"
#include "xr/input.hpp"
#include "xr/panel.hpp"

#include <optional>
#include <span>

namespace meltpool {

class PanelPointer {
  public:
    /// Distance of the panel in front, behind the workpiece's middle, m.
    static constexpr float kBehind = 0.35f;
    using Hands = std::span<const xr::HandInput, 2>; ///< in the order of xr::Hand

    explicit PanelPointer(const HeadsetParameters& parameters) : parameters_(parameters) {}

    /// Takes the frame's hands. The menu button of a hand opens and closes the panel, and that hand points; the other
    /// one takes over when it pulls its trigger at the panel. `torchWorks`: the torch is at the metal, so that its hand
    /// does not point, wherever its controller is directed, unless it opened the panel itself.
    void update(Hands hands, const Workshop& workshop, const xr::PanelShape& shape, xr::Hand torchHand,
                bool torchWorks);
    /// Moves the panel towards its place, but never while a trigger is pulled at it: in front of the person, or `aside`
    /// of the workpiece, away from the torch's hand. `eyes`: their place in the workshop, empty while unknown; the
    /// panel takes its height from them when it comes in front. For the other hand it goes to the other side by way of
    /// the front, where it meets no machine. `elapsed`: real seconds since the last frame.
    void move(bool aside, const std::optional<glm::vec3>& eyes, xr::Hand torchHand, double elapsed);
    /// Takes the height in front from the eyes again, after the workshop was moved.
    void forgetHeight() { heightKnown_ = false; }

    bool open() const { return open_; }
    /// Opens the panel because something on it must be answered or read.
    void show() {
        if (!open_) called_ = false;
        open_ = true;
    }
    void hide() { open_ = false; }
    /// Pose of the panel in the workshop.
    const xr::Pose& pose() const { return pose_; }
    const PointerOnPanel& pointer() const { return pointer_; }
    /// Side of the place aside: -1 left, 1 right of the workpiece. The machine is on the other one.
    float side() const { return side_; }
    /// Hand that points at the panel now; empty: none.
    std::optional<xr::Hand> pointingHand() const;
    /// Pointer's ray in the workshop, from the hand to the panel. Valid only while a hand points at it.
    const glm::vec3& rayStart() const { return ray_.position; }
    const glm::vec3& rayEnd() const { return rayEnd_; }

  private:
    bool pointWith(xr::Hand which, Hands hands, const Workshop& workshop, const xr::PanelShape& shape);

    const HeadsetParameters& parameters_;
    xr::Pose pose_;
    float aside_ = 0;  ///< 0 in front .. 1 aside
    float side_ = -1;  ///< side of the place aside: -1 left .. 1 right
    float height_ = 0; ///< height of the middle in front, m
    float tilt_ = 0;   ///< rad, leans the panel in front back to the eyes
    bool heightKnown_ = false;
    xr::Hand hand_ = xr::Hand::right; ///< hand that opened the panel, or last pulled its trigger at it
    bool open_ = false;
    bool called_ = false; ///< the torch's hand opened the panel by its button
    PointerOnPanel pointer_;
    xr::Pose ray_; ///< ray of the pointing hand, in the workshop
    glm::vec3 rayEnd_{0.0f};
};

} // namespace meltpool
