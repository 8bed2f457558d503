// Simple painted solids that make up things: torches, hands, table, clamps; and markers, which are signs rather than
// things.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cstddef>

namespace meltpool {

/// All but the bend fit into the cube -0.5..0.5; the axis of round shapes is z, the tip of the cone is at -z.
enum class SolidShape {
    box,
    cylinder,
    cone,
    sphere,
    tube,    ///< a cylinder with a bore of kTubeBore of its width
    cup,     ///< a tube that narrows towards -z to kCupMouth of its width
    taper,   ///< a cylinder that narrows towards -z to kTaperEnd of its width
    pill,    ///< a cylinder with round ends
    rounded, ///< a box with round edges and corners
    bend,    ///< a rod of width 1 that begins at the origin along +z and turns by kBendAngle towards +x
    slab,    ///< a face to +y at y = 0 of many small rectangles, the smallest in its middle
    chalk,   ///< a face to +y at y = 0 of ragged streaks along x, with gaps between them
};
constexpr size_t kSolidShapes = 12;

constexpr float kTubeBore = 0.76f;
constexpr float kCupMouth = 0.72f;
constexpr float kTaperEnd = 0.66f;
constexpr float kBendAngle = 0.7853982f; ///< rad
constexpr float kBendRadius = 2.2f;      ///< radius of its middle line, in widths of the rod

struct Solid {
    SolidShape shape = SolidShape::box;
    glm::mat4 toWorld{1.0f};
    glm::vec3 colour{0.5f}; ///< linear sRGB reflectance
    float gloss = 0.2f;     ///< 0 dull .. 1 polished
    glm::vec3 glow{0.0f};   ///< emitted light
    /// Replacement for the finer solids of SceneView::fittings, drawn in their place unless detail is high. Pools
    /// mirror it and it throws a shadow whether it is drawn or not.
    bool coarse = false;
};

/// A solid that shows its own colour in any light, also through the visor, and lets the background through.
struct Marker {
    SolidShape shape = SolidShape::box;
    glm::mat4 toWorld{1.0f};
    glm::vec3 colour{0.5f}; ///< linear sRGB, as displayed
    float opacity = 1;      ///< 0..1
    float face = 1;         ///< share of it on surfaces that face the eye; below 1 the outline is the strongest part
};

/// Returns the transform of a solid that reaches from `from` to `to` with the given width; its -z end is at `to`.
glm::mat4 alongLine(const glm::vec3& from, const glm::vec3& to, float width);

/// Returns the transform of a box or the like with these edges around `middle`.
glm::mat4 boxAt(const glm::vec3& middle, const glm::vec3& size);

} // namespace meltpool
