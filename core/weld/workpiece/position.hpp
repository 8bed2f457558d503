// Welding positions: the hold of a workpiece, and with it the direction of gravity in its own frame.
#pragma once

#include "core/weld/workpiece/workpiece.hpp"

#include <glm/mat3x3.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace meltpool {

/// AWS A3.0 (ISO 6947 in brackets). F: fillets, G: grooves and beads. asItLies: the workpiece frame is the room's.
/// flat: the weld's face looks up. 1F (PA): fillet in a trough, its face looks up. 2F (PB): base plate level, the other
/// plate upright. 3F (PF, PG): vertical seam, the fillet's face looks at the welder. 4F (PD): overhead, the base plate
/// on top. 1G (PA): plate level. 2G (PC): plate upright, seam horizontal. 3G (PF, PG): plate upright, seam vertical. 4G
/// (PE): plate overhead, welded from below. 5G: pipe with a horizontal axis that is not turned.
enum class WeldPosition { asItLies, flat, f1, f2, f3, f4, g1, g2, g3, g4, g5 };

/// Returns the names in files, in the order of WeldPosition: "as_it_lies", "flat", "1F" ...
std::span<const std::string_view> positionNames();
/// Returns the position with this name; nothing for an unknown one.
std::optional<WeldPosition> findPosition(std::string_view name);

/// Hold of the workpiece in the room, whose y points up and whose z points towards the welder.
struct Fixture {
    glm::mat3 turn{1};      ///< rotation from the workpiece's frame to the room's
    float overTable = 0;    ///< m above a workpiece that is on the table
    glm::vec3 up() const;   ///< unit vector against gravity, in the workpiece's frame
    glm::vec3 down() const; ///< unit vector along gravity, in the workpiece's frame
};

/// Returns the fixture of a workpiece. Travel along +x is upwards in 3F and 3G, to the right in the other positions, to
/// the left overhead.
Fixture fixtureOf(const WorkpieceParameters& parameters);

/// Returns how far a box with these corners reaches against `up`: the least coordinate along it, in the corners' unit.
float lowestAlong(const glm::vec3& up, const glm::vec3& low, const glm::vec3& high);

/// Returns true if a workpiece of this kind can be held so.
bool positionFits(WorkpieceKind kind, WeldPosition position);

/// Returns the names of the positions that fit, with commas.
std::string fittingPositions(WorkpieceKind kind);

} // namespace meltpool
