#include "core/validation/case_size.hpp"

#include "core/base/error.hpp"
#include "core/base/memory.hpp"
#include "core/base/text.hpp"
#include "core/gl/gl.hpp"
#include "shaders/shared/flow.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace meltpool {

namespace {

// Bytes that buffers and their staging copies take, rounded up.
constexpr double kHeatCell = 80;
constexpr double kParticle = 300;
constexpr double kFlowParticle = 4.0 * (FLOW_NEIGHBOUR_CAPACITY + 2) + 400;
constexpr double kFlowCell = 8.0 * FLOW_PAGE_WORDS + 100; // of (2.4 spacings)³
constexpr double kFlowCellVolume = 2.4 * 2.4 * 2.4;
constexpr double kShare = 0.8; // of what is free, that a case may take

std::string figure(double value) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.3g", value);
    return text.data();
}

/// Most flowing particles that the driver's buffer textures can list neighbours of.
double mostListed() {
    GLint texels = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
    return texels / (FLOW_NEIGHBOUR_CAPACITY + 2.0);
}

} // namespace

void requireRoom(const ValidationCase& from, const CaseSize& size) {
    const double bytes = size.heatCells * kHeatCell + size.particles * kParticle + size.flowParticles * kFlowParticle +
                         size.flowVolume / kFlowCellVolume * kFlowCell;
    constexpr double kGiga = 1024.0 * 1024 * 1024;
    const std::string needs = "spacing_mm: the case would be " +
                              figure(std::max(size.particles, size.flowParticles) * 1e-6) + " million particles in ";
    const double free = kShare * static_cast<double>(availableMemory().value_or(size_t(8) << 30));
    if (bytes > free)
        throw InputError(from.file, 0,
                         needs + figure(bytes / kGiga) + " GiB, and " + figure(free / kGiga) +
                             " GiB may be taken; expected a larger spacing or a smaller case");
    if (size.flowParticles > mostListed())
        throw InputError(from.file, 0,
                         needs + figure(bytes / kGiga) + " GiB, and the graphics driver's buffers hold " +
                             figure(mostListed() * 1e-6) + " million; expected a larger spacing or a smaller case");
}

void requireSteps(const ValidationCase& from, double steps) {
    constexpr double kMost = 2e7; // an hour of the least that a step takes
    if (steps > kMost)
        throw InputError(from.file, 0,
                         "spacing_mm: the case would take " + figure(steps * 1e-6) +
                             " million steps; expected a larger spacing or a shorter time");
}

void requireSpacings(const ValidationCase& from, std::string_view key, double length, double least) {
    if (length >= (least - 1e-6) * from.spacing) return;
    throw InputError(from.file, 0,
                     "[case] " + std::string(key) + ": " + figure(length * 1e3) +
                         " mm is too little for particles of " + figure(from.spacing * 1e3) +
                         " mm; expected at least " + figure(least) + " times spacing_mm");
}

} // namespace meltpool
