// The heat source of the classic metal as drawn: a burner whose flame points down, and the line to the place below it.
#pragma once

#include "core/render/scene.hpp"

#include <vector>

namespace meltpool {

struct SourceModel {
    std::vector<Solid> solids;
    std::vector<Marker> markers; ///< the flame's outer cones, which let the metal through, and the line
};

/// Fills `model` with burner and flame in the world; the flame is as long as the source's heat reaches. A source that
/// is off has its pilot flame only.
void buildSource(SourceModel& model, const SourceView& source, const glm::mat4& modelToWorld);

} // namespace meltpool
