#include "core/metal/classic/statistics_reader.hpp"

#include "shaders/shared/classic.h"

#include <algorithm>
#include <cstring>
#include <span>

namespace meltpool {

StatisticsReader::StatisticsReader(gl::ShaderLibrary& library, size_t particles)
    : particles_(particles),
      chunks_((particles + CLASSIC_STATISTICS_CHUNK - 1) / CLASSIC_STATISTICS_CHUNK),
      program_(library.compute("metal/classic/statistics.comp")),
      waited_("classic statistics", chunks_ * sizeof(ClassicChunk) + sizeof(uint)) {
    for (Slot& slot : slots_) {
        slot.buffer = gl::Buffer("classic statistics", waited_.bytes());
        slot.answer.emplace("classic statistics", waited_.bytes());
    }
}

void StatisticsReader::discard() {
    for (Slot& slot : slots_) {
        slot.answer->forget();
        slot.pending = false;
    }
    oldest_ = 0;
}

void StatisticsReader::reduce(const gl::Buffer& refused, const gl::Buffer& target) const {
    target.bindStorage(CLASSIC_STATISTICS);
    program_.dispatchGroups(static_cast<unsigned>(chunks_));
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    refused.copyTo(target, sizeof(uint), 0, chunks_ * sizeof(ClassicChunk));
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
    for (size_t age = 0; age < slots_.size(); ++age) {
        Slot& slot = slots_[(oldest_ + age) % slots_.size()];
        if (slot.pending) continue;
        reduce(refused, slot.buffer);
        slot.answer->request(slot.buffer);
        slot.pending = true;
        return;
    }
}

std::optional<MetalStatistics> StatisticsReader::poll() {
    std::optional<MetalStatistics> newest;
    for (size_t age = 0; age < slots_.size(); ++age) {
        Slot& slot = slots_[oldest_];
        if (!slot.pending) break;
        const void* answer = slot.answer->pollInPlace();
        if (answer == nullptr) break;
        slot.pending = false;
        newest = sum(answer);
        oldest_ = (oldest_ + 1) % slots_.size();
    }
    return newest;
}

MetalStatistics StatisticsReader::now(const gl::Buffer& refused) const {
    reduce(refused, waited_);
    return sum(waited_.read<std::byte>(waited_.bytes()).data());
}

size_t StatisticsReader::bytes() const {
    return 2 * slots_.size() * waited_.bytes() + waited_.bytes();
}

} // namespace meltpool
