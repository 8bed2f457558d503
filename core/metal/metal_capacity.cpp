#include "core/metal/metal_capacity.hpp"

#include "core/base/memory.hpp"
#include "core/gl/gl.hpp"
#include "shaders/shared/flow.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace meltpool {

namespace {

// Bytes of buffers and their staging copies, rounded up.
constexpr double kHeatCell = 80;
constexpr double kParticle = 300;
constexpr double kFlowParticle = 4.0 * (FLOW_NEIGHBOUR_CAPACITY + 2) + 400;
constexpr double kFlowCell = 8.0 * FLOW_PAGE_WORDS + 100; // bytes of a cell of (2.4 spacings)³
constexpr double kFlowCellVolume = 2.4 * 2.4 * 2.4;
constexpr double kShare = 0.8; // share of the free memory that a metal may take

std::string figure(double value) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.3g", value);
    return text.data();
}

} // namespace

MetalCapacity machineCapacity() {
    GLint texels = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
    return {kShare * static_cast<double>(availableMemory().value_or(size_t(8) << 30)), static_cast<double>(texels)};
}

std::string capacityFault(const MetalSize& size, const MetalCapacity& room) {
    const double bytes = size.heatCells * kHeatCell + size.particles * kParticle + size.flowParticles * kFlowParticle +
                         size.flowVolume / kFlowCellVolume * kFlowCell + size.otherBytes;
    constexpr double kGiga = 1024.0 * 1024 * 1024;
    const std::string needs = "would be " + figure(std::max(size.particles, size.flowParticles) * 1e-6) +
                              " million particles in " + figure(bytes / kGiga) + " GiB, and ";
    if (bytes > room.bytes) return needs + figure(room.bytes / kGiga) + " GiB may be taken";
    const double mostListed = room.bufferTexels / (FLOW_NEIGHBOUR_CAPACITY + 2.0); // rows of neighbour lists
    if (size.flowParticles > mostListed)
        return needs + "the graphics driver's buffers hold " + figure(mostListed * 1e-6) + " million";
    return {};
}

} // namespace meltpool
