// Things in the workshop other than the workpiece: the welding table, the holders of the workpiece on it, and the
// machine.
#pragma once

#include "core/render/solid.hpp"
#include "core/weld/process/processes.hpp"
#include "core/weld/workpiece/workpiece.hpp"

#include <vector>

namespace meltpool {

/// Default height of the table's top over the floor, m.
constexpr float kUsualTableHeight = 0.9f;

/// End of the torch's cable: over the table's left edge and down; m from the middle of the table's top, y up, z to the
/// welder.
constexpr glm::vec3 kCableEnd(-0.63f, -0.30f, 0.05f);

/// Adds the table with its slots, and its legs down to the floor `height` (m) below its top. `toWorld`: from the middle
/// of its top, m.
void addTable(std::vector<Solid>& solids, const glm::mat4& toWorld, float height);

/// Adds the machine of this process on the table, Equipment::displays on its front. Without displays there is none.
/// `toWorld`: as for the table. `right`: on the right side of the table, else on the left.
void addMachine(std::vector<Solid>& solids, const glm::mat4& toWorld, const ProcessSettings& process,
                bool right = true);

/// Adds the holders of the workpiece: clamps at both ends of a plate on the table, else a post of height `overTable`
/// (m) under it. `toWorld`: from the workpiece's frame turned into the room's, m.
void addHolders(std::vector<Solid>& solids, const glm::mat4& toWorld, const Workpiece& piece, float overTable);

} // namespace meltpool
