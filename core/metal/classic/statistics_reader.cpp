#include "core/metal/classic/statistics_reader.hpp"

#include "core/gl/order.hpp"

#include "shaders/shared/classic.h"

#include <algorithm>
#include <cstring>
#include <span>

namespace meltpool {

StatisticsReader::StatisticsReader(gl::ShaderLibrary& library, size_t particles)
    : particles_(particles),
      chunks_((particles + CLASSIC_STATISTICS_CHUNK - 1) / CLASSIC_STATISTICS_CHUNK),
      program_(library.compute("metal/classic/statistics.comp")),
      sums_("classic statistics", chunks_ * sizeof(ClassicChunk) + sizeof(uint)),
      answers_("classic statistics", sums_.bytes(), kStatisticsInFlight) {}

void StatisticsReader::reduce(const gl::Buffer& refused) const {
    sums_.bindStorage(CLASSIC_STATISTICS);
    program_.dispatchGroups(static_cast<unsigned>(chunks_));
    gl::memoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    refused.copyTo(sums_, sizeof(uint), 0, chunks_ * sizeof(ClassicChunk));
}

MetalStatistics StatisticsReader::sum(const void* answer) const {
    const std::span chunks(static_cast<const ClassicChunk*>(answer), chunks_);
    MetalStatistics total;
    total.particles = particles_;
    uint refused = 0;
    std::memcpy(&refused, chunks.data() + chunks.size(), sizeof refused);
    total.nonFinite = refused;
    total.minTemperature = static_cast<double>(chunks.front().minTemperature);
    total.maxTemperature = static_cast<double>(chunks.front().maxTemperature);
    double temperatures = 0;
    for (const ClassicChunk& chunk : chunks) {
        temperatures += static_cast<double>(chunk.temperatureSum);
        total.minTemperature = std::min(total.minTemperature, static_cast<double>(chunk.minTemperature));
        total.maxTemperature = std::max(total.maxTemperature, static_cast<double>(chunk.maxTemperature));
        total.molten += chunk.molten;
        total.lost += chunk.outside;
    }
    total.meanTemperature = temperatures / static_cast<double>(particles_);
    return total;
}

void StatisticsReader::request(const gl::Buffer& refused) {
    reduce(refused);
    answers_.request(sums_);
}

std::optional<MetalStatistics> StatisticsReader::poll() {
    const void* answer = answers_.pollInPlace();
    return answer == nullptr ? std::nullopt : std::optional(sum(answer));
}

std::optional<MetalStatistics> StatisticsReader::await() {
    const void* answer = answers_.awaitInPlace();
    return answer == nullptr ? std::nullopt : std::optional(sum(answer));
}

MetalStatistics StatisticsReader::now(const gl::Buffer& refused) const {
    reduce(refused);
    return sum(sums_.read<std::byte>(sums_.bytes()).data());
}

size_t StatisticsReader::bytes() const {
    return sums_.bytes() + answers_.bytes();
}

} // namespace meltpool
