#include "core/weld/workpiece.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"

#include <glm/common.hpp>

#include <array>
#include <cmath>

namespace meltpool {

namespace {

constexpr std::array<std::string_view, 6> kKinds{"plate", "cube", "bridge", "tee", "lap", "butt"};
constexpr float kMm = 1e-3F;
constexpr float kClampMm = 4; ///< how far clamps reach over the ends

/// A block of metal, mm in the workpiece frame.
struct Block {
    glm::vec3 low;
    glm::vec3 high;
};

std::vector<Block> blocksOf(const WorkpieceParameters& p) {
    const float l = p.lengthMm / 2, w = p.widthMm / 2, t = p.thicknessMm;
    switch (static_cast<WorkpieceKind>(p.kind)) {
    case WorkpieceKind::Plate:
        return {{{-l, -t, -w}, {l, 0, w}}};
    case WorkpieceKind::Cube:
        return {{{-l, -l, -l}, {l, l, l}}};
    case WorkpieceKind::Bridge:
        return {{{-l, -p.heightMm, -w}, {-l + 2 * kClampMm, 0, w}},
                {{l - 2 * kClampMm, -p.heightMm, -w}, {l, 0, w}},
                {{-l + 2 * kClampMm, -t, -w}, {l - 2 * kClampMm, 0, w}}};
    case WorkpieceKind::Tee:
        return {{{-l, -t, -w}, {l, 0, w}}, {{-l, 0, -t}, {l, p.heightMm, 0}}};
    case WorkpieceKind::Lap:
        return {{{-l, -t, -w / 2}, {l, 0, w}}, {{-l, 0, -w}, {l, t, 0}}};
    case WorkpieceKind::Butt:
        return {{{-l, -t, -w}, {l, 0, -p.gapMm / 2}}, {{-l, -t, p.gapMm / 2}, {l, 0, w}}};
    }
    return {};
}

/// Clamps hold the ends of plates, the foot of a cube and the feet of a bridge's piers.
bool clamped(const WorkpieceParameters& p, glm::vec3 placeMm, glm::vec3 bodyLow) {
    const auto kind = static_cast<WorkpieceKind>(p.kind);
    if (kind == WorkpieceKind::Cube || kind == WorkpieceKind::Bridge) return placeMm.y < bodyLow.y + p.spacingMm;
    return std::abs(placeMm.x) > p.lengthMm / 2 - std::min(kClampMm, p.lengthMm / 8);
}

/// mm³
double volumeOf(const std::vector<Block>& blocks) {
    double volume = 0;
    for (const Block& block : blocks) {
        const glm::dvec3 size = block.high - block.low;
        volume += size.x * size.y * size.z;
    }
    return volume;
}

/// Asked before the particles are made, too: far too many would not even fit the memory.
void requireCount(double particles) {
    if (particles >= 0.5 && particles <= static_cast<double>(kMostWorkpieceParticles)) return;
    throw InputError("the workpiece has " + formatNumber(std::floor(particles)) + " particles; expected 1 to " +
                     std::to_string(kMostWorkpieceParticles) + ": change its size or spacing_mm");
}

} // namespace

ParameterList describe(WorkpieceParameters& p) {
    ParameterList list{
        {"metal", "Metal", "", &p.metal, 0, 0, "a shipped material such as s235 or 304, or a file that ends in .toml"},
        {"workpiece", "Workpiece", "", &p.kind, 0, 5, "plates are clamped at their ends, a cube at its foot", kKinds},
        {"length_mm", "Length", "mm", &p.lengthMm, 4, 400, "along the seam; of a cube its edge"},
        {"width_mm", "Width", "mm", &p.widthMm, 4, 400, "across the seam"},
        {"thickness_mm", "Thickness", "mm", &p.thicknessMm, 1, 50, "of each plate"},
        {"height_mm", "Height", "mm", &p.heightMm, 4, 200, "of a tee's standing plate and a bridge's piers"},
        {"gap_mm", "Gap", "mm", &p.gapMm, 0, 10, "of a butt joint"},
        {"spacing_mm", "Particle spacing", "mm", &p.spacingMm, 0.2, 2, "halving it costs sixteen times the time"},
        {"room_above_mm", "Room above", "mm", &p.roomAboveMm, 2, 100, "filler and drops stay inside it"},
        {"room_below_mm", "Height of supports", "mm", &p.roomBelowMm, 0, 100, "what melts through falls that far"},
        {"temperature_c", "Preheat", "°C", &p.temperatureC, -100, 1500, "temperature at the start"},
    };
    for (Parameter& parameter : list)
        parameter.onlyAtStart = true;
    return list;
}

Material workpieceMaterial(const WorkpieceParameters& parameters) {
    if (parameters.metal.ends_with(".toml")) return readMaterial(parameters.metal);
    return shippedMaterial(parameters.metal);
}

Workpiece makeWorkpiece(const WorkpieceParameters& p) {
    const std::vector<Block> blocks = blocksOf(p);
    glm::vec3 low = blocks[0].low, high = blocks[0].high;
    for (const Block& block : blocks) {
        low = glm::min(low, block.low);
        high = glm::max(high, block.high);
    }
    const bool stands =
        p.kind == static_cast<int>(WorkpieceKind::Cube) || p.kind == static_cast<int>(WorkpieceKind::Bridge);
    const float below = stands ? 0 : p.roomBelowMm;
    const float beside = stands ? p.roomAboveMm : 3 * p.spacingMm;
    const glm::vec3 margin(beside, 0, beside);
    // The lattice's cells must lie on the blocks' faces, so the space grows in whole spacings.
    const auto whole = [&](float mm) { return std::ceil(mm / p.spacingMm - 1e-3F) * p.spacingMm; };
    const glm::vec3 spaceLow = low - glm::vec3(whole(margin.x), whole(below), whole(margin.z));
    const glm::vec3 spaceHigh = high + glm::vec3(whole(margin.x), whole(p.roomAboveMm), whole(margin.z));

    const glm::vec3 cells = (spaceHigh - spaceLow) / p.spacingMm;
    if (cells.x * cells.y * cells.z > 64e6F)
        throw InputError("the workpiece is too large for its spacing_mm; expected fewer than 64 million lattice cells");
    requireCount(volumeOf(blocks) / static_cast<double>(p.spacingMm * p.spacingMm * p.spacingMm));
    Workpiece piece;
    piece.lattice = MetalLattice::covering(spaceLow * kMm, spaceHigh * kMm, p.spacingMm * kMm);
    for (const Block& block : blocks)
        piece.blocks.push_back({block.low * kMm, block.high * kMm});
    for (const Block& block : blocks)
        for (MetalSeed& seed :
             latticeSeeds(piece.lattice, block.low * kMm, block.high * kMm, p.temperatureC + 273.15F)) {
            if (clamped(p, seed.position / kMm, low)) seed.phase |= PHASE_CLAMPED;
            piece.seeds.push_back(seed);
        }
    requireCount(static_cast<double>(piece.seeds.size()));
    piece.low = piece.lattice.low;
    piece.high = piece.lattice.low + glm::vec3(piece.lattice.cells()) * piece.lattice.spacing;
    piece.bodyLow = low * kMm;
    piece.bodyHigh = high * kMm;
    piece.floorHeight = spaceLow.y * kMm;
    return piece;
}

} // namespace meltpool
