#include "core/metal/classic/arrangement.hpp"

#include "core/base/error.hpp"

#include <cmath>
#include <cstdint>

namespace meltpool {

namespace {

/// SplitMix64 (Steele, Lea and Flood 2014). Unlike the standard library's distributions it gives equal numbers with
/// every compiler.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    /// The next value, 0 <= value < 1 in steps of 2^-24.
    float next() {
        state_ += 0x9E3779B97F4A7C15U;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
        return static_cast<float>((z ^ (z >> 31U)) >> 40U) * 0x1p-24F;
    }

    glm::vec4 placeInCube(float halfEdge) {
        const float x = next(), y = next(), z = next();
        return {(2 * x - 1) * halfEdge, (2 * y - 1) * halfEdge, (2 * z - 1) * halfEdge, 0};
    }

  private:
    std::uint64_t state_;
};

size_t latticeEdge(size_t particles) {
    auto edge = static_cast<size_t>(std::cbrt(static_cast<double>(particles)));
    while ((edge + 1) * (edge + 1) * (edge + 1) <= particles) // cbrt may round a cube down
        ++edge;
    while (edge * edge * edge > particles)
        --edge;
    return edge;
}

void appendLattice(std::vector<glm::vec4>& places, size_t edge) {
    const auto middle = [edge](size_t i) { return (static_cast<float>(i) + 0.5F) / static_cast<float>(edge) - 0.5F; };
    for (size_t z = 0; z < edge; ++z)
        for (size_t y = 0; y < edge; ++y)
            for (size_t x = 0; x < edge; ++x)
                places.emplace_back(middle(x), middle(y), middle(z), 0.0F);
}

} // namespace

std::vector<glm::vec4> arrangeParticles(const ClassicSetup& setup) {
    if (setup.particles < 1) throw InputError("the classic metal has no particles; expected at least 1");
    const auto count = static_cast<size_t>(setup.particles);
    const bool ordered = setup.arrangement == ClassicSetup::kOrdered;
    std::vector<glm::vec4> places;
    places.reserve(count);
    if (ordered) appendLattice(places, latticeEdge(count));
    Random random(static_cast<std::uint64_t>(setup.seed));
    while (places.size() < count)
        places.push_back(random.placeInCube(ordered ? 0.25F : 0.5F));
    return places;
}

} // namespace meltpool
