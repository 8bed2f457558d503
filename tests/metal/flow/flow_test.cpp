// The flow's passes against their twin in double precision, and the laws that hold for any motion of the metal.
#include "core/metal/flow/flow.hpp"
#include "core/metal/flow/flow_oracle.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/geometric.hpp>

#include <functional>
#include <random>

namespace meltpool {

namespace {

HeatTable steelTable() {
    Material steel;
    steel.solidus = 1768;
    steel.liquidus = 1813;
    steel.latentHeat = 2.7e5;
    steel.solidConductivity = steel.liquidConductivity = Property::constant(30);
    steel.solidSpecificHeat = steel.liquidSpecificHeat = Property::constant(700);
    return HeatTable(steel);
}

struct Scene {
    MetalState state;
    Flow flow;
    Scene(const std::vector<MetalSeed>& seeds, const FlowFluid& fluid, const FlowSpace& space, glm::vec3 gravity)
        : state(MetalLattice::covering(space.low, space.high, static_cast<float>(fluid.spacing)), steelTable(),
                fluid.density, seeds.size()),
          flow(test::shaders(), state, fluid, space) {
        state.setGravity(gravity);
        state.add(seeds);
    }
};

constexpr float kHot = 2000;

/// Returns a slightly shaken block of liquid on two layers of solid, 9 x 9 x 7 particles.
std::vector<MetalSeed> puddle(float dx) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> shake(-0.1F, 0.1F);
    std::vector<MetalSeed> seeds;
    for (int z = 0; z < 9; ++z)
        for (int y = 0; y < 7; ++y)
            for (int x = 0; x < 9; ++x) {
                MetalSeed seed;
                seed.position = (glm::vec3(x, y, z) + 0.5F) * dx;
                seed.temperature = y < 2 ? 300 : kHot;
                if (y >= 2) {
                    seed.phase |= PHASE_LIQUID;
                    seed.position += dx * glm::vec3(shake(random), shake(random), shake(random));
                    seed.velocity = 0.5F * glm::vec3(shake(random), shake(random), shake(random));
                }
                seeds.push_back(seed);
            }
    return seeds;
}

std::vector<OracleParticle> twinOf(const std::vector<MetalSeed>& seeds) {
    std::vector<OracleParticle> particles;
    for (const MetalSeed& seed : seeds)
        particles.push_back({glm::dvec3(seed.position), glm::dvec3(seed.velocity), (seed.phase & PHASE_LIQUID) != 0,
                             static_cast<double>(seed.temperature)});
    return particles;
}

FlowSpace roomAround(float dx) {
    return {glm::vec3(-10 * dx), glm::vec3(20 * dx)};
}

} // namespace

TEST_CASE("the flow's sweeps do what their twin does") {
    test::context();
    const float dx = 1e-3F;
    const auto seeds = puddle(dx);
    FlowFluid fluid;
    fluid.spacing = 1e-3;
    fluid.wetting = 0.7;
    fluid.wallFriction = 0.6;
    fluid.coldWetting = 0.3; // the walls' 300 K are between cold and warm wetting
    fluid.coldBelow = 200;
    fluid.warmAbove = 400;
    const glm::vec3 gravity(1, -9.81F, 2);
    Scene scene(seeds, fluid, roomAround(dx), gravity);
    auto particles = twinOf(seeds);
    const FlowOracle twin(fluid, glm::dvec3(gravity));
    const double dt = 1.0 / 1440;
    for (int steps = 0; steps < 3; ++steps) {
        twin.step(particles, dt);
        scene.flow.step(dt, 1, nullptr);
        const auto computed = scene.flow.readParticles();
        const auto velocities = scene.state.velocity.read<vec4>(seeds.size());
        const auto positions = scene.state.position.read<vec4>(seeds.size());
        double delta = 0, gradient = 0, velocity = 0, position = 0;
        for (size_t i = 0; i < seeds.size(); ++i) {
            if (!particles[i].liquid) continue;
            delta = std::max(delta, std::abs(double(computed[i].density) - particles[i].delta));
            gradient = std::max(gradient, glm::length(glm::dvec3(computed[i].normal) - particles[i].gradient));
            velocity = std::max(velocity, glm::length(glm::dvec3(velocities[i]) - particles[i].velocity));
            position = std::max(position, glm::length(glm::dvec3(positions[i]) - particles[i].position));
        }
        INFO("step " << steps);
        CHECK(delta < 2e-5);
        CHECK(gradient * 1e-3 < 1e-4);
        CHECK(velocity < 1e-4);
        CHECK(position < 1e-7);
    }
    CHECK_FALSE(scene.flow.readFaults().any());
    CHECK(scene.flow.readMoving() == 9 * 9 * 5);
}

TEST_CASE("a wetting that is set moves the liquid like one from the start") {
    test::context();
    const float dx = 1e-3F;
    const auto seeds = puddle(dx);
    FlowFluid cold, warm;
    cold.coldWetting = 0.3;
    cold.coldBelow = 600;
    cold.warmAbove = 900;
    warm.coldWetting = 0.5;
    warm.coldBelow = 200; // the walls have 300 K
    warm.warmAbove = 700;
    Scene set(seeds, cold, roomAround(dx), glm::vec3(0)), made(seeds, warm, roomAround(dx), glm::vec3(0)),
        left(seeds, cold, roomAround(dx), glm::vec3(0));
    set.flow.setWetting(warm);
    for (Scene* scene : {&set, &made, &left})
        scene->flow.step(1.0 / 144, nullptr);
    const auto places = [&](Scene& scene) { return scene.state.position.read<vec4>(seeds.size()); };
    const auto a = places(set), b = places(made), c = places(left);
    bool same = true, differs = false;
    for (size_t i = 0; i < seeds.size(); ++i) {
        same = same && a[i] == b[i];
        differs = differs || a[i] != c[i];
    }
    CHECK(same);
    CHECK(differs);
}

TEST_CASE("the same scene moves to the same bits") {
    test::context();
    const float dx = 1e-3F;
    const auto seeds = puddle(dx);
    FlowFluid fluid;
    fluid.wetting = 0.7;
    Scene first(seeds, fluid, roomAround(dx), glm::vec3(0, -9.81F, 0));
    Scene second(seeds, fluid, roomAround(dx), glm::vec3(0, -9.81F, 0));
    for (int frame = 0; frame < 3; ++frame) {
        first.flow.step(1.0 / 90, nullptr);
        second.flow.step(1.0 / 90, nullptr);
    }
    CHECK(first.state.position.read<vec4>(seeds.size()) == second.state.position.read<vec4>(seeds.size()));
    CHECK(first.state.velocity.read<vec4>(seeds.size()) == second.state.velocity.read<vec4>(seeds.size()));
}

TEST_CASE("space that repeats has no seam") {
    test::context();
    const float dx = 1e-3F;
    FlowFluid fluid;
    const FlowSpace space{glm::vec3(0), glm::vec3(8 * dx), glm::bvec3(true), glm::vec3(0)};
    std::mt19937 random(3);
    std::uniform_real_distribution<float> shake(-0.2F, 0.2F);
    std::vector<MetalSeed> seeds;
    for (int i = 0; i < 512; ++i) {
        MetalSeed seed;
        seed.position =
            (glm::vec3(i % 8, i / 8 % 8, i / 64) + 0.5F + glm::vec3(shake(random), shake(random), shake(random))) * dx;
        seed.phase |= PHASE_LIQUID;
        seed.temperature = kHot;
        seeds.push_back(seed);
    }
    Scene scene(seeds, fluid, space, glm::vec3(0));
    auto particles = twinOf(seeds);
    const FlowOracle twin(fluid, glm::dvec3(0), glm::dvec3(space.high));
    twin.step(particles, 1.0 / 1440);
    scene.flow.step(1.0 / 1440, 1, nullptr);
    const auto velocities = scene.state.velocity.read<vec4>(seeds.size());
    double velocity = 0;
    glm::dvec3 momentum(0);
    for (size_t i = 0; i < seeds.size(); ++i) {
        velocity = std::max(velocity, glm::length(glm::dvec3(velocities[i]) - particles[i].velocity));
        momentum += glm::dvec3(velocities[i]);
    }
    CHECK(velocity < 1e-4);
    CHECK(glm::length(momentum) < 1e-4);
    CHECK_FALSE(scene.flow.readFaults().any());
}

TEST_CASE("what melts begins to move, what freezes stands still, none is lost") {
    test::context();
    const float dx = 1e-3F;
    auto seeds = puddle(dx);
    FlowFluid fluid;
    Scene scene(seeds, fluid, roomAround(dx), glm::vec3(0, -9.81F, 0));
    std::mt19937 random(5);
    std::uniform_real_distribution<double> chance(0, 1);
    auto phases = scene.state.phase.read<uint>(seeds.size());
    for (int frame = 0; frame < 30; ++frame) {
        for (size_t i = 0; i < seeds.size(); ++i)
            if (seeds[i].position.y > 2 * dx && chance(random) < 0.1) phases[i] ^= PHASE_LIQUID;
        scene.state.phase.write(std::span<const uint>(phases));
        scene.state.noteRegrouping();
        const auto before = scene.state.position.read<vec4>(seeds.size());
        scene.flow.step(1.0 / 90, nullptr);
        const auto after = scene.state.position.read<vec4>(seeds.size());
        const auto velocities = scene.state.velocity.read<vec4>(seeds.size());
        unsigned moving = 0;
        size_t wrong = 0;
        for (size_t i = 0; i < seeds.size(); ++i) {
            const bool liquid = (phases[i] & PHASE_LIQUID) != 0;
            moving += liquid ? 1U : 0U;
            const bool rests = before[i] == after[i] && glm::length(glm::vec3(velocities[i])) == 0;
            wrong += liquid == rests ? 1U : 0U;
        }
        CHECK(wrong == 0);
        CHECK(scene.flow.readMoving() == moving);
    }
    CHECK_FALSE(scene.flow.readFaults().any());
    const auto end = scene.state.position.read<vec4>(seeds.size());
    for (const vec4& place : end) // liquid may wet the plate's rim, but clings to it
        CHECK(glm::length(glm::vec3(place) - 4.5F * dx) < 10 * dx);
}

namespace {

/// Returns a level pool without solid, 16 x 8 x 16 particles; warmer by `slope` K a metre towards +x.
std::vector<MetalSeed> levelPool(float dx, float slope) {
    std::vector<MetalSeed> seeds;
    for (int z = 0; z < 16; ++z)
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 16; ++x) {
                MetalSeed seed;
                seed.position = (glm::vec3(x, y, z) + 0.5F) * dx;
                seed.temperature = kHot + slope * seed.position.x;
                seed.phase |= PHASE_LIQUID;
                seeds.push_back(seed);
            }
    return seeds;
}

/// Returns the difference of the force (N) on the `chosen` particles in one short substep, with and without the
/// settings of `change`.
glm::dvec3 forceOf(const FlowFluid& fluid, const std::vector<MetalSeed>& seeds, const FlowSpace& space,
                   const ArcPressure& arc, const std::function<bool(glm::vec3)>& chosen) {
    Scene scene(seeds, fluid, space, glm::vec3(0));
    scene.flow.setArc(arc);
    const double dt = 1e-4;
    scene.flow.step(dt, 1, nullptr);
    const auto velocities = scene.state.velocity.read<vec4>(seeds.size());
    glm::dvec3 force(0);
    for (size_t i = 0; i < seeds.size(); ++i)
        if (chosen(seeds[i].position)) force += glm::dvec3(velocities[i]) * scene.flow.constants().mass / dt;
    return force;
}

} // namespace

TEST_CASE("an arc presses with its pressure's integral") {
    test::context();
    const float dx = 1e-3F;
    const auto seeds = levelPool(dx, 0);
    const FlowSpace space{glm::vec3(-0.01F), glm::vec3(0.03F)};
    const auto all = [](glm::vec3) { return true; };
    const ArcPressure arc{glm::vec3(8, 8, 8) * dx, glm::vec3(0, -1, 0), 2e-3F, 500};
    const glm::dvec3 force = forceOf({}, seeds, space, arc, all) - forceOf({}, seeds, space, {}, all);
    const double expected = 2 * 3.14159265 * 4e-6 * 500;
    CHECK(-force.y == Approx(expected).epsilon(0.05));
    CHECK(std::abs(force.x) < 0.02 * expected);
}

TEST_CASE("an arc's jet drags the surface away from its axis, by its drag's integral") {
    test::context();
    const float dx = 1e-3F;
    const auto seeds = levelPool(dx, 0);
    const FlowSpace space{glm::vec3(-0.01F), glm::vec3(0.03F)};
    ArcPressure arc{glm::vec3(8, 8, 8) * dx, glm::vec3(0, -1, 0), 2e-3F, 500};
    // One quarter of a ring about the axis, far from the pool's edges: along its middle line the drag is outwards.
    const auto quarter = [&](glm::vec3 place) {
        const glm::vec3 off = place - arc.place;
        return off.x > std::abs(off.z) && glm::length(glm::vec3(off.x, 0, off.z)) < 5 * dx;
    };
    const glm::dvec3 pressed = forceOf({}, seeds, space, arc, quarter);
    arc.shear = 50;
    const glm::dvec3 force = forceOf({}, seeds, space, arc, quarter) - pressed;
    // Beltaos and Rajaratnam 1974, with h = 15.1 sigma; over a quarter the parts along x are cos: 2 sin(45 degrees).
    double expected = 0;
    const double ring = 1e-5;
    for (double r = ring / 2; r < 5e-3; r += ring) {
        const double far = r / (15.1 * 2e-3), pressure = std::exp(-114 * far * far);
        expected += 50 * (0.18 * (1 - pressure) / far - 9.43 * far * pressure) * r * ring * std::sqrt(2.0);
    }
    CHECK(force.x == Approx(expected).epsilon(0.1));
    CHECK(std::abs(force.z) < 0.1 * expected);
    CHECK(std::abs(force.y) < 0.1 * expected);
}

TEST_CASE("cold metal is wetted less than hot metal") {
    test::context();
    const double dx = 1e-3;
    FlowFluid fluid;
    fluid.coldWetting = 0.5;
    fluid.coldBelow = 700;
    fluid.warmAbove = 1200;
    std::vector<double> heights;
    for (const float temperature : {500.0F, 1500.0F}) {
        std::vector<MetalSeed> seeds;
        for (int z = -12; z < 12; ++z)
            for (int y = -3; y < 5; ++y)
                for (int x = -12; x < 12; ++x) {
                    MetalSeed seed;
                    seed.position = (glm::vec3(x, y, z) + 0.5F) * static_cast<float>(dx);
                    seed.temperature = y < 0 ? temperature : kHot;
                    const bool drop = y >= 0 && std::max(std::abs(2 * x + 1), std::abs(2 * z + 1)) < 6;
                    if (y >= 0 && !drop) continue;
                    if (drop) seed.phase |= PHASE_LIQUID;
                    seeds.push_back(seed);
                }
        Scene scene(seeds, fluid, {glm::vec3(-12e-3F), glm::vec3(12e-3F)}, glm::vec3(0, -9.81F, 0));
        for (int frame = 0; frame < 30; ++frame)
            scene.flow.step(1.0 / 90, nullptr);
        double sum = 0, count = 0;
        const auto places = scene.state.position.read<vec4>(seeds.size());
        for (size_t i = 0; i < seeds.size(); ++i)
            if (seeds[i].phase & PHASE_LIQUID) {
                sum += static_cast<double>(places[i].y);
                count += 1;
            }
        heights.push_back(sum / count / dx);
    }
    CHECK(heights[0] > 1.5);              // remains a drop
    CHECK(heights[1] < 0.7 * heights[0]); // spreads
}

TEST_CASE("frozen metal off the lattice stops drops, and a moving piece takes them along") {
    test::context();
    const float dx = 1e-3F;
    const bool piece = GENERATE(false, true);
    const glm::vec3 rising = piece ? glm::vec3(0, 0.05F, 0) : glm::vec3(0);
    std::mt19937 random(5);
    std::uniform_real_distribution<float> shake(-0.15F, 0.15F);
    std::vector<MetalSeed> seeds;
    for (int i = 0; i < 15 * 2 * 15; ++i) {
        MetalSeed seed;
        const glm::vec3 off(shake(random), shake(random), shake(random));
        seed.position = (glm::vec3(i % 15, i / 15 % 2, i / 30) + 0.5F + off) * dx;
        if (piece) seed.phase |= 1U << PHASE_FRAGMENT_SHIFT;
        seed.velocity = rising;
        seeds.push_back(seed);
    }
    const size_t slab = seeds.size();
    for (int i = 0; i < 9; ++i) { // drops apart from each other, each at another offset to the slab's particles
        MetalSeed drop;
        drop.position =
            glm::vec3(3.5F + 4.13F * static_cast<float>(i % 3), 5, 3.5F + 4.21F * static_cast<float>(i / 3)) * dx;
        drop.temperature = kHot;
        drop.phase |= PHASE_LIQUID;
        drop.velocity = glm::vec3(0, -1, 0);
        seeds.push_back(drop);
    }
    Scene scene(seeds, {}, roomAround(dx), glm::vec3(0, -9.81F, 0));
    float height = 2 * dx;
    for (int frame = 0; frame < 9; ++frame) {
        scene.flow.step(1.0 / 90, nullptr);
        if (!piece) continue;
        auto places = scene.state.position.read<vec4>(seeds.size()); // done in a simulation by the fragments' own step
        for (size_t i = 0; i < slab; ++i)
            places[i].y += rising.y / 90;
        scene.state.position.write(std::span<const vec4>(places));
        height += rising.y / 90;
    }
    const auto places = scene.state.position.read<vec4>(seeds.size());
    for (size_t i = slab; i < seeds.size(); ++i) {
        CHECK(places[i].y > height - 0.6F * dx);
        CHECK(places[i].y < height + 1.5F * dx);
    }
}

TEST_CASE("warmth pulls the surface towards the cold") {
    test::context();
    const float dx = 1e-3F;
    const float slope = 1e5F; // K/m
    const auto seeds = levelPool(dx, slope);
    FlowFluid fluid;
    FlowSpace space{glm::vec3(0, -0.01F, 0), glm::vec3(16 * dx, 0.03F, 16 * dx)};
    space.repeats = glm::bvec3(false, false, true);
    const auto inTheMiddle = [&](glm::vec3 place) { return std::abs(place.x - 8 * dx) < 3 * dx; };
    const glm::dvec3 without = forceOf(fluid, seeds, space, {}, inTheMiddle);
    fluid.tensionSlopes.values.fill(-4e-4);
    const glm::dvec3 force = forceOf(fluid, seeds, space, {}, inTheMiddle) - without;
    const double area = 2 * 6e-3 * 16e-3; // upper and lower face
    CHECK(force.x == Approx(-4e-4 * static_cast<double>(slope) * area).epsilon(0.1));
    CHECK(std::abs(force.y) < 0.02 * std::abs(force.x));
}

TEST_CASE("the slope of surface tension at a place's own temperature drives it") {
    test::context();
    const float dx = 1e-3F;
    const float slope = 1e5F; // K/m; 1600 K from end to end
    const auto seeds = levelPool(dx, slope);
    FlowFluid fluid;
    FlowSpace space{glm::vec3(0, -0.01F, 0), glm::vec3(16 * dx, 0.03F, 16 * dx)};
    space.repeats = glm::bvec3(false, false, true);
    const auto left = [&](glm::vec3 place) { return std::abs(place.x - 5 * dx) < 2 * dx; };
    const auto right = [&](glm::vec3 place) { return std::abs(place.x - 11 * dx) < 2 * dx; };
    const glm::dvec3 leftWithout = forceOf(fluid, seeds, space, {}, left);
    const glm::dvec3 rightWithout = forceOf(fluid, seeds, space, {}, right);
    // The slope falls from +4e-4 to -4e-4 over the pool's temperatures and is 0 in its middle.
    TensionSlopes slopes;
    slopes.from = static_cast<double>(kHot);
    slopes.step = static_cast<double>(slope) * 16e-3 / 15;
    for (size_t i = 0; i < 16; ++i)
        slopes.values[i] = 4e-4 - 8e-4 * static_cast<double>(i) / 15;
    fluid.tensionSlopes = slopes;
    const double area = 2 * 4e-3 * 16e-3;                                       // upper and lower face
    const double expected = 4e-4 * 3.0 / 8 * static_cast<double>(slope) * area; // 3 of 8 spacings from the middle
    CHECK(forceOf(fluid, seeds, space, {}, left).x - leftWithout.x == Approx(expected).epsilon(0.1));
    CHECK(forceOf(fluid, seeds, space, {}, right).x - rightWithout.x == Approx(-expected).epsilon(0.1));
}

} // namespace meltpool
