// The cost of a dispatch without work and the barrier after it: passes over absent metal cost this.
#include "app/bench/bench.hpp"
#include "app/bench/parts.hpp"
#include "core/gl/buffer.hpp"

#include <array>

namespace meltpool {

namespace {

constexpr int kDispatches = 200;

} // namespace

BenchRow measureEmptyDispatches(Bench& bench) {
    const gl::Program& program = bench.shaders().compute("bench/empty.comp");
    const gl::Buffer groups("bench groups", std::span<const GLuint>(std::array<GLuint, 3>{0, 1, 1}));
    BenchRow row = bench.measure(std::to_string(kDispatches) + " empty indirect dispatches with barrier",
                                 [&](gl::Profiler& profiler) {
                                     const gl::Scope scope(&profiler, "empty dispatches");
                                     glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, groups.name());
                                     for (int i = 0; i < kDispatches; ++i) {
                                         program.dispatchIndirect(0);
                                         glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
                                     }
                                 });
    row.further = {{"us_per_dispatch", row.stepMs * 1e3 / kDispatches}};
    return row;
}

void benchEmptyDispatches(Bench& bench) {
    bench.add(measureEmptyDispatches(bench));
}

} // namespace meltpool
