// Measures of each level of detail that bring a picture nearer to a welder's view, with their words.
#pragma once

#include "core/render/look/look.hpp"

#include <array>
#include <string_view>

namespace meltpool {

/// A part of a picture that a level may leave out. The cues of the pool's edge are none: emissivity that jumps at the
/// melting point, and solid metal duller than liquid metal.
enum class DetailFeature : unsigned {
    torchShadow,
    glare,
    roughLobes,
    poolMirror,
    calmHighlights,
    ripples,
    spatter,
    fume,
    room,
    fittings,
    millScale,
    floatingOxide
};

/// A row of the table of levels.
struct MeasureRow {
    DetailFeature measure;
    PictureDetail from;        ///< the lowest level that has it
    std::string_view key;      ///< one word, for figures
    std::string_view sentence; ///< sentence about its visible effect
};

/// The table, in the order of DetailFeature. `meltpool bench looks` prints the cost of each.
constexpr std::array<MeasureRow, 12> kMeasures{{
    {DetailFeature::torchShadow, kMediumDetail, "torch_shadow", "the torch's shadow in the lamp's light"},
    {DetailFeature::glare, kMediumDetail, "glare", "the veil that an arc throws in the eye"},
    {DetailFeature::roughLobes, kHighDetail, "rough_lobes",
     "lamp, arc and room mirrored as rough metal does, and the light that roughness hides; without it Phong's lobes"},
    {DetailFeature::poolMirror, kHighDetail, "pool_mirror", "torch, filler and workpiece mirrored in the pool"},
    {DetailFeature::calmHighlights, kHighDetail, "calm_highlights",
     "highlights as wide as the normals within a pixel make them"},
    {DetailFeature::ripples, kHighDetail, "ripples", "lines of one freezing time in a bead; they need rough lobes"},
    {DetailFeature::spatter, kMediumDetail, "spatter",
     "drops that the arc throws, the wire's drops, and the beads that lie"},
    {DetailFeature::fume, kMediumDetail, "fume", "smoke that the arc lights, and puffs of it that rise"},
    {DetailFeature::room, kMediumDetail, "room", "a workshop with depth, and table, clamps and machine in it"},
    {DetailFeature::fittings, kHighDetail, "fittings", "torch and hands in their own form, with hose and cable"},
    {DetailFeature::millScale, kMediumDetail, "mill_scale",
     "rolled steel under its scale, ground bright along the seam"},
    {DetailFeature::floatingOxide, kHighDetail, "floating_oxide",
     "islands of oxide that drift with the pool; they need its mirror"},
}};

constexpr unsigned bitOf(DetailFeature measure) {
    return 1u << static_cast<unsigned>(measure);
}

/// Returns the measures of a picture of this look, a bit each: those that its level has and that are not left out.
constexpr unsigned measuresOf(const LookParameters& look) {
    unsigned bits = 0;
    for (const MeasureRow& row : kMeasures)
        if (look.detail >= row.from) bits |= bitOf(row.measure);
    return bits & ~look.leftOut;
}

constexpr bool has(const LookParameters& look, DetailFeature measure) {
    return (measuresOf(look) & bitOf(measure)) != 0;
}

} // namespace meltpool
