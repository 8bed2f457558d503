// The scene of one frame: all data that the renderer needs.
#pragma once

#include "core/metal/material/materials.hpp"
#include "core/metal/state/particle_view.hpp"
#include "core/render/effects/eye_adaptation.hpp"
#include "core/render/effects/spark.hpp"
#include "core/render/section.hpp"
#include "core/render/solids.hpp"
#include "core/render/view.hpp"
#include "core/surface/surface_mesh.hpp"
#include "core/weld/process/ripples.hpp"
#include "core/weld/workpiece/rolled_faces.hpp"
#include "core/weld/workpiece/workpiece.hpp"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <span>

namespace meltpool {

/// Heat or cold source of the classic lesson, drawn as a burner with a flame that points down; its shadow and the place
/// that its heat reaches are on the metal.
struct SourceView {
    bool shown = false;
    glm::vec3 position{0.0f}; ///< model units
    float reach = 0.32f;      ///< model units, distance that its heat reaches
    bool on = false;
    bool cold = false;
};

/// Mapping of the temperatures of vertices and particles to colours.
struct TemperatureMeaning {
    float coldest = 0.0f;  ///< lower end of the temperature colours
    float hottest = 1.0f;  ///< upper end of the temperature colours
    bool kelvin = false;   ///< false: the classic model's 0..1, whose look depends on the temperature itself
    float solidus = 0.0f;  ///< K: dull below
    float liquidus = 0.0f; ///< K: fully liquid and glossy above
};

/// Light of a welding arc.
struct ArcLight {
    glm::vec3 position{0.0f};  ///< model units
    glm::vec3 intensity{0.0f}; ///< luminous intensity in kPaperLuminance times square model units; 0: no arc
    float radius = 1e-3f;      ///< model units; nearer surfaces are lit as from this distance
};

/// The workshop as geometry around the scene.
struct WorkshopView {
    bool shown = false; ///< false: the sky is drawn, alike from everywhere
    /// Transform from the workshop's frame (m, floor at WORKSHOP_FLOOR): one scale, translation.
    glm::mat4 toWorld{1.0f};
};

struct SceneView {
    SurfaceMesh mesh;             ///< null buffers: no surface is drawn
    bool meshIsOpen = false;      ///< without caps: the inside is visible
    ParticleView particles;       ///< particles for the points mode; null: none
    glm::mat4 modelToWorld{1.0f}; ///< rotation, one scale, translation
    glm::vec3 boxMin{-1.0f};      ///< model units
    glm::vec3 boxMax{1.0f};
    float cubeWidth = 1.0f; ///< model units; frost, clouds and absorption of ice and wax scale with it
    SourceView source;
    TemperatureMeaning temperature;
    const MaterialLooks* looks = nullptr; ///< physical material; null: LookParameters::material
    FreezingRipples ripples;              ///< ripples of frozen metal, if `looks` names no frequency
    RolledFaces rolled;                   ///< model units; under mill scale if `looks` has some
    float oxideRadius = 0;                ///< radius of the islands on a pool, model units; 0: none float there
    SectionView section;
    ArcLight arc;
    ArcEffectsView effects;
    AfterImage afterImage;
    bool tableShown = false;                ///< a table is among the solids, and spatter can be on it
    std::span<const WorkpieceBlock> blocks; ///< model units; they block the arc's light from the solids behind them
    std::span<const Solid> chalk;           ///< marks on the workpiece, placed in model units
    std::span<const Solid> solids;          ///< torch, table, clamps
    std::span<const Solid> fittings;        ///< finer solids of torch and hands, for high detail
    WorkshopView room;                      ///< for detail that is not low; else, and from outside of it, the sky
    std::span<const Solid> furniture;       ///< things in the room other than the workpiece; drawn with it only
    float tableTop = -1e9f;                 ///< world height of the table among them
    size_t holderSolids = 0;                ///< number of the last of them that hold the workpiece
    /// Torch, gloves and forearms of a person whose hands are tracked, as drawn: medium detail shows them, too.
    std::span<const Solid> hands;
    std::span<const Marker> ghost;   ///< drawn over the rest, unless something is in front of it
    std::span<const Marker> markers; ///< drawn likewise, after the ghost
    size_t rodSolids = 0;            ///< number of the last of them that are the filler rod in the other hand

    /// Takes torch, hands and rod out of the picture.
    void putTorchAway() {
        solids = {};
        fittings = {};
        hands = {};
        rodSolids = 0;
    }
};

/// Lets an eye below the table's top see the workpiece from beneath, as in an empty room.
inline void lookThroughTable(SceneView& scene, const View& view) {
    if (view.eye.y >= scene.tableTop) return;
    scene.furniture = {};
    scene.tableShown = false;
}

} // namespace meltpool
