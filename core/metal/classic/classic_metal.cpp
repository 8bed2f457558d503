#include "core/metal/classic/classic_metal.hpp"

#include "core/metal/classic/arrangement.hpp"

namespace meltpool {

ClassicMetal::ClassicMetal(gl::ShaderLibrary&, const ClassicSetup& setup) : setup_(setup) {
    reset();
}

void ClassicMetal::reset() {
    const std::vector<glm::vec4> places = arrangeParticles(setup_);
    positions_ = gl::Buffer("classic positions", std::span<const glm::vec4>(places));
}

void ClassicMetal::step(const ClassicSource&, gl::Profiler*) {}
ParticleView ClassicMetal::particles() const {
    return {&positions_, static_cast<size_t>(setup_.particles)};
}
MetalStatistics ClassicMetal::statistics() const {
    return {static_cast<size_t>(setup_.particles)};
}
void ClassicMetal::requestStatistics() {}
std::optional<MetalStatistics> ClassicMetal::pollStatistics() {
    return std::nullopt;
}
std::uint64_t ClassicMetal::stateHash() const {
    return 0;
}
size_t ClassicMetal::bytes() const {
    return positions_.bytes();
}
void ClassicMetal::useAllPairs(bool) {}

} // namespace meltpool
