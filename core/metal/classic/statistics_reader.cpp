#include "core/metal/classic/statistics_reader.hpp"

#include "shaders/shared/classic.h"

#include <algorithm>

namespace meltpool {

namespace {

constexpr size_t kRing = 3;

} // namespace

StatisticsReader::StatisticsReader(gl::ShaderLibrary& library, size_t particles)
    : particles_(particles),
      chunks_((particles + CLASSIC_STATISTICS_CHUNK - 1) / CLASSIC_STATISTICS_CHUNK),
      program_(library.compute("metal/classic_statistics.comp")) {
    for (Slot& slot : slots_)
        slot.buffer = gl::Buffer("classic statistics", chunks_ * sizeof(ClassicChunk) + sizeof(uint));
}

StatisticsReader::~StatisticsReader() {
    forget();
}

void StatisticsReader::forget() {
    for (Slot& slot : slots_) {
        if (slot.fence != nullptr) glDeleteSync(slot.fence);
        slot.fence = nullptr;
    }
    oldest_ = 0;
}

void StatisticsReader::reduce(const gl::Buffer& refused, const gl::Buffer& target) const {
    target.bindStorage(CLASSIC_STATISTICS);
    program_.dispatchGroups(static_cast<unsigned>(chunks_));
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    refused.copyTo(target, sizeof(uint), 0, chunks_ * sizeof(ClassicChunk));
}

MetalStatistics StatisticsReader::read(const gl::Buffer& buffer) const {
    MetalStatistics total;
    total.particles = particles_;
    total.nonFinite = buffer.read<uint>(1, chunks_ * sizeof(ClassicChunk)).front();
    const std::vector<ClassicChunk> chunks = buffer.read<ClassicChunk>(chunks_);
    total.minTemperature = static_cast<double>(chunks.front().minTemperature);
    total.maxTemperature = static_cast<double>(chunks.front().maxTemperature);
    double sum = 0;
    for (const ClassicChunk& chunk : chunks) {
        sum += static_cast<double>(chunk.temperatureSum);
        total.minTemperature = std::min(total.minTemperature, static_cast<double>(chunk.minTemperature));
        total.maxTemperature = std::max(total.maxTemperature, static_cast<double>(chunk.maxTemperature));
        total.molten += chunk.molten;
        total.lost += chunk.outside;
    }
    total.meanTemperature = sum / static_cast<double>(particles_);
    return total;
}

void StatisticsReader::request(const gl::Buffer& refused) {
    for (size_t age = 0; age < kRing; ++age) {
        Slot& slot = slots_[(oldest_ + age) % kRing];
        if (slot.fence != nullptr) continue;
        reduce(refused, slot.buffer);
        slot.fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
        return;
    }
}

std::optional<MetalStatistics> StatisticsReader::poll() {
    std::optional<MetalStatistics> newest;
    for (size_t age = 0; age < kRing; ++age) {
        Slot& slot = slots_[oldest_];
        if (slot.fence == nullptr) break;
        // The flush makes sure that the commands get going even if nothing else is drawn.
        if (glClientWaitSync(slot.fence, GL_SYNC_FLUSH_COMMANDS_BIT, 0) == GL_TIMEOUT_EXPIRED) break;
        glDeleteSync(slot.fence);
        slot.fence = nullptr;
        newest = read(slot.buffer);
        oldest_ = (oldest_ + 1) % kRing;
    }
    return newest;
}

MetalStatistics StatisticsReader::now(const gl::Buffer& refused) const {
    reduce(refused, slots_[kRing].buffer);
    return read(slots_[kRing].buffer);
}

size_t StatisticsReader::bytes() const {
    return slots_.size() * slots_.front().buffer.bytes();
}

} // namespace meltpool
