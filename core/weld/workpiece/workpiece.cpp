#include "core/weld/workpiece/workpiece.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/weld/workpiece/position.hpp"
#include "core/weld/workpiece/simulated_size.hpp"
#include "core/weld/workpiece/workpiece_shape.hpp"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace meltpool {

namespace {

constexpr std::array<std::string_view, 8> kKinds{"plate", "cube", "bridge", "tee", "lap", "butt", "corner", "pipe"};
constexpr float kMm = 1e-3F;

bool isKind(const WorkpieceParameters& p, std::initializer_list<WorkpieceKind> kinds) {
    return std::find(kinds.begin(), kinds.end(), static_cast<WorkpieceKind>(p.kind)) != kinds.end();
}

/// Called before the particles are made, too: far too many would not even fit the memory.
void requireCount(double particles) {
    if (particles >= 0.5 && particles <= static_cast<double>(kMostWorkpieceParticles)) return;
    throw InputError("the workpiece has " + formatNumber(std::floor(particles)) + " particles; expected 1 to " +
                     std::to_string(kMostWorkpieceParticles) + ": change its size or spacing_mm");
}

} // namespace

ParameterList describe(WorkpieceParameters& p) {
    ParameterList list{
        {"metal", "Metal", "", &p.metal, 0, 0, "Shipped material such as s235 or 304, or a file that ends in .toml."},
        {"workpiece", "Workpiece", "", &p.kind, 0, 7, "Plates are clamped at their ends, a cube at its foot.", kKinds},
        {"position", "Position", "", &p.position, 0, 10,
         "Fillets 1F to 4F, plate and butt 1G to 4G, pipe 5G. Turns the workpiece.", positionNames()},
        {"length_mm", "Length", "mm", &p.lengthMm, 4, 400, "Length along the seam. Edge of a cube."},
        {"width_mm", "Width", "mm", &p.widthMm, 4, 400, "Width across the seam. Length of a pipe."},
        {"thickness_mm", "Thickness", "mm", &p.thicknessMm, 1, 50, "Thickness of each plate, or of a pipe's wall."},
        {"height_mm", "Height", "mm", &p.heightMm, 4, 200,
         "Height of the upright plate of a tee or corner, or of a bridge's piers."},
        {"gap_mm", "Gap", "mm", &p.gapMm, 0, 10, "Gap of a butt joint or a pipe."},
        {"root_face_mm", "Root face", "mm", &p.rootFaceMm, 0, 50, "Height of a bevelled edge without bevel."},
        {"bevel_deg", "Bevel", "deg", &p.bevelDeg, 0, 60,
         "Angle of each edge of a butt joint or a pipe, from the upright."},
        {"diameter_mm", "Diameter", "mm", &p.diameterMm, 10, 400, "Outer diameter of a pipe."},
        {"tack_count", "Tacks", "", &p.tackCount, 0, 50, "Tacks are spread evenly along the seam."},
        {"tack_length_mm", "Length of a tack", "mm", &p.tackLengthMm, 1, 100, "Length of each tack."},
        {"spacing_mm", "Particle spacing", "mm", &p.spacingMm, 0.2, 2,
         "Half the spacing costs sixteen times the time."},
        {"room_above_mm", "Room above", "mm", &p.roomAboveMm, 2, 100, "Filler and drops stay inside it."},
        {"room_below_mm", "Height of supports", "mm", &p.roomBelowMm, 0, 100,
         "Metal that melts through falls this far."},
        {"temperature_c", "Preheat", "°C", &p.temperatureC, -100, 1500, "Temperature at the start."},
    };
    for (Parameter& parameter : list)
        parameter.onlyAtStart = true;
    return list;
}

Material workpieceMaterial(const WorkpieceParameters& parameters) {
    if (parameters.metal.ends_with(".toml")) return readMaterial(parameters.metal);
    return shippedMaterial(parameters.metal);
}

namespace {

using Fault = std::optional<WorkpieceFault>;

std::string mm(float value) {
    return formatNumber(value) + " mm";
}

Fault positionFault(const WorkpieceParameters& p) {
    const auto kind = static_cast<WorkpieceKind>(p.kind);
    const auto position = static_cast<size_t>(p.position);
    if (positionFits(kind, static_cast<WeldPosition>(p.position))) return std::nullopt;
    return WorkpieceFault{"position", "is " + std::string(positionNames()[position]) + ", which is none of a " +
                                          std::string(kKinds[static_cast<size_t>(p.kind)]) + "; expected one of " +
                                          fittingPositions(kind)};
}

Fault grooveFault(const WorkpieceParameters& p) {
    if (!isKind(p, {WorkpieceKind::Butt, WorkpieceKind::Pipe})) return std::nullopt;
    if (p.rootFaceMm > p.thicknessMm)
        return WorkpieceFault{"root_face_mm", "is " + mm(p.rootFaceMm) + "; expected at most thickness_mm, which is " +
                                                  mm(p.thicknessMm)};
    if (p.gapMm >= p.widthMm)
        return WorkpieceFault{"gap_mm",
                              "is " + mm(p.gapMm) + "; expected less than width_mm, which is " + mm(p.widthMm)};
    const float groove = p.gapMm + 2 * WorkpieceShape::bevelRun(p);
    if (groove >= p.widthMm)
        return WorkpieceFault{"bevel_deg", "makes a groove of " + mm(groove) +
                                               "; expected one narrower than width_mm, which is " + mm(p.widthMm)};
    return std::nullopt;
}

Fault pipeFault(const WorkpieceParameters& p) {
    if (!isKind(p, {WorkpieceKind::Pipe}) || 2 * p.thicknessMm < p.diameterMm) return std::nullopt;
    return WorkpieceFault{"thickness_mm", "is " + mm(p.thicknessMm) + "; expected less than half of diameter_mm, " +
                                              "which is " + mm(p.diameterMm)};
}

Fault tackFault(const WorkpieceParameters& p) {
    if (p.tackCount == 0) return std::nullopt;
    if (isKind(p, {WorkpieceKind::Plate, WorkpieceKind::Cube, WorkpieceKind::Bridge}))
        return WorkpieceFault{"tack_count",
                              "is " + std::to_string(p.tackCount) + "; expected 0, as this workpiece has no joint"};
    const float seam = WorkpieceShape::seamLength(p);
    const float tacks = static_cast<float>(p.tackCount) * p.tackLengthMm;
    if (tacks > seam)
        return WorkpieceFault{"tack_count",
                              "makes tacks of " + mm(tacks) + " in all; expected at most the seam's " + mm(seam)};
    const bool corner = isKind(p, {WorkpieceKind::Tee, WorkpieceKind::Lap, WorkpieceKind::Corner});
    if (!corner && p.gapMm < p.spacingMm && WorkpieceShape::bevelRun(p) < 2 * p.spacingMm)
        return WorkpieceFault{"tack_count", "is " + std::to_string(p.tackCount) +
                                                "; expected 0, or a gap_mm or bevel_deg that leaves room for tacks"};
    return std::nullopt;
}

/// Room around the parts, mm, at the low and at the high end of each axis.
struct Margins {
    glm::vec3 low, high;
};

Margins marginsOf(const WorkpieceParameters& p, const glm::vec3& down) {
    const bool stands = isKind(p, {WorkpieceKind::Cube, WorkpieceKind::Bridge});
    const float below = stands ? 0 : p.roomBelowMm;
    const float beside = stands ? p.roomAboveMm : 3 * p.spacingMm;
    Margins room{{beside, below, beside}, {beside, p.roomAboveMm, beside}};
    if (isKind(p, {WorkpieceKind::Corner})) room.high.z = p.roomAboveMm;
    if (isKind(p, {WorkpieceKind::Pipe})) {
        room.low = {p.roomAboveMm, std::max(below, p.roomAboveMm), beside};
        room.high.x = p.roomAboveMm;
    }
    constexpr float kFalls = 0.5F; // component of a unit vector, enough at 45 degrees too
    for (int axis = 0; axis < 3; ++axis) {
        if (down[axis] < -kFalls) room.low[axis] = std::max(room.low[axis], below);
        if (down[axis] > kFalls) room.high[axis] = std::max(room.high[axis], below);
    }
    // Overhead the torch is in the way of falling metal, which must not end up before it.
    if (down.y > kFalls) room.high.y = p.roomAboveMm + below;
    return room;
}

void addParts(Workpiece& piece, const WorkpieceShape& shape, float kelvin) {
    for (const WorkpieceShape::Box& box : shape.boxes())
        for (MetalSeed& seed : latticeSeeds(piece.lattice, box.low * kMm, box.high * kMm, kelvin)) {
            if (!shape.holds(seed.position / kMm)) continue;
            if (shape.held(seed.position / kMm)) seed.phase |= PHASE_CLAMPED;
            piece.seeds.push_back(seed);
        }
}

void addTacks(Workpiece& piece, const WorkpieceShape& shape, float kelvin) {
    const WorkpieceShape::Box box = shape.aroundTacks();
    for (const MetalSeed& seed : latticeSeeds(piece.lattice, box.low * kMm, box.high * kMm, kelvin)) {
        if (!shape.inTack(seed.position / kMm)) continue;
        piece.seeds.push_back(seed);
        ++piece.tackSeeds;
    }
}

/// Places the faces for pictures, light and clamps at those of the particles.
void addFaces(Workpiece& piece, const WorkpieceShape& shape, const WorkpieceParameters& p) {
    const auto filled = [&](const WorkpieceShape::Box& box) {
        return latticeBox(piece.lattice, box.low * kMm, box.high * kMm);
    };
    for (const WorkpieceShape::Box& box : shape.fullBoxes())
        if (const auto [low, high] = filled(box); glm::all(glm::lessThan(low, high)))
            piece.blocks.push_back({low, high});
    const LatticeBox body = filled(shape.around());
    piece.bodyLow = body.low;
    piece.bodyHigh = body.high;
    if (!isKind(p, {WorkpieceKind::Pipe})) return;
    const float radius = p.diameterMm / 2 * kMm; // the round faces of a pipe are across the layers
    piece.pipe = {{0, -radius}, body.low.z, body.high.z, radius, radius - p.thicknessMm * kMm};
    piece.bodyLow = {-radius, -2 * radius, body.low.z};
    piece.bodyHigh = {radius, 0, body.high.z};
}

Fault faultOf(const WorkpieceParameters& parameters) {
    for (const auto& find : {positionFault, pipeFault, grooveFault, tackFault})
        if (Fault fault = find(parameters)) return fault;
    return std::nullopt;
}

} // namespace

std::optional<WorkpieceFault> workpieceFault(const WorkpieceParameters& parameters) {
    if (Fault fault = faultOf(parameters)) return fault;
    Fault fault = faultOf(simulatedWorkpiece(parameters));
    if (fault) fault->sentence += ". " + simulatedSizesText(parameters);
    return fault;
}

Workpiece makeWorkpiece(const WorkpieceParameters& parameters) {
    if (const Fault fault = workpieceFault(parameters))
        throw InputError("the workpiece's " + std::string(fault->key) + " " + fault->sentence);
    const WorkpieceParameters p = simulatedWorkpiece(parameters);
    const WorkpieceShape shape(p);
    const auto [low, high] = shape.around();
    const Fixture fixture = fixtureOf(p);
    const Margins room = marginsOf(p, fixture.down());
    // The lattice's cells must end at the parts' faces, so the space grows in whole spacings.
    const auto whole = [&](glm::vec3 mm) { return glm::ceil(mm / p.spacingMm - 1e-3F) * p.spacingMm; };
    const glm::vec3 spaceLow = low - whole(room.low), spaceHigh = high + whole(room.high);
    const glm::vec3 cells = (spaceHigh - spaceLow) / p.spacingMm;
    if (cells.x * cells.y * cells.z > 64e6F)
        throw InputError("the workpiece is too large for its spacing_mm; expected fewer than 64 million lattice cells");
    requireCount(shape.volume() / static_cast<double>(p.spacingMm * p.spacingMm * p.spacingMm));
    Workpiece piece;
    piece.lattice = MetalLattice::covering(spaceLow * kMm, spaceHigh * kMm, p.spacingMm * kMm);
    addFaces(piece, shape, p);
    addParts(piece, shape, p.temperatureC + 273.15F);
    requireCount(static_cast<double>(piece.seeds.size()));
    if (p.tackCount > 0) addTacks(piece, shape, p.temperatureC + 273.15F);
    piece.low = piece.lattice.low;
    piece.high = piece.lattice.low + glm::vec3(piece.lattice.cells()) * piece.lattice.spacing;
    piece.turn = fixture.turn;
    piece.up = fixture.up();
    piece.floorHeight = lowestAlong(piece.up, piece.low, piece.high);
    return piece;
}

} // namespace meltpool
