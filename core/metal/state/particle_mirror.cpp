#include "core/metal/state/particle_mirror.hpp"

#include "core/base/error.hpp"
#include "core/gl/software_driver/software_driver.hpp"
#include "core/metal/state/metal_state.hpp"

#include <algorithm>

namespace meltpool {

void ParticleMirror::take(const ParticleView& original, gl::ContextThread& there) {
    const std::array<const gl::Buffer*, kBuffers> from{original.positions, original.phases,       original.heats,
                                                       original.frozenAt,  original.latticeSlots, original.numbers};
    std::array<const std::byte*, kBuffers> memory{};
    there.run([&] {
        for (size_t i = 0; i < kBuffers; ++i)
            if (from[i] != nullptr) memory[i] = gl::directMemory(from[i]->name());
    });
    const auto take = [&](size_t number, size_t bytes) { return copy(number, from[number], memory[number], bytes); };
    view_ = original;
    view_.positions = take(0, original.count * sizeof(vec4));
    view_.phases = take(1, original.count * sizeof(uint));
    view_.heats = take(2, original.count * sizeof(vec4));
    view_.frozenAt = take(3, original.count * sizeof(float));
    view_.latticeSlots = take(4, original.lattice != nullptr ? original.lattice->cellCount() * sizeof(uint) : 0);
    view_.numbers = take(5, original.count * sizeof(uint));
}

/// Copies the first `bytes` of a buffer into one with the original's capacity.
const gl::Buffer* ParticleMirror::copy(size_t number, const gl::Buffer* original, const std::byte* memory,
                                       size_t bytes) {
    if (original == nullptr) return nullptr;
    if (memory == nullptr)
        throw RuntimeFault("the graphics driver does not share its memory, so another context cannot show the metal");
    gl::Buffer& buffer = buffers_[number];
    if (!buffer || buffer.bytes() < original->bytes()) buffer = gl::Buffer("shown particles", original->bytes());
    buffer.write(std::span(memory, std::min(bytes, original->bytes())));
    return &buffer;
}

size_t ParticleMirror::bytes() const {
    size_t sum = 0;
    for (const gl::Buffer& buffer : buffers_)
        if (buffer) sum += buffer.bytes();
    return sum;
}

} // namespace meltpool
