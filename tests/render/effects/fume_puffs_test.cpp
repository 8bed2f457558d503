// Puffs of smoke from the arc's steps: they rise by the law of a plume, conserve their smoke, and are reproducible.
#include "core/render/effects/arc_effects.hpp"
#include "tests/support/catch.hpp"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <cstring>
#include <vector>

namespace meltpool {

namespace {

constexpr double kStep = 1.0 / 90;

ProcessSettings smaw() {
    ProcessSettings settings;
    settings.choose<Smaw>();
    return settings;
}

/// An arc at the origin that burns on demand.
class Burning {
  public:
    explicit Burning(ProcessSettings process) : process_(process) {}

    void run(int steps, bool burns = true) {
        for (int i = 0; i < steps; ++i) {
            ArcEffectsStep step;
            step.number = ++number_;
            step.time = double(number_) * kStep;
            step.seconds = kStep;
            step.process = &process_;
            if (burns) step.arc.action = ArcAction::burning;
            step.arc.current = 115;
            step.arc.voltage = 24;
            step.place = {0, 0.002F, 0};
            effects.step(step);
        }
    }
    std::vector<FumePuff> puffs() {
        const auto shown = effects.view().fume.puffs;
        return {shown.begin(), shown.end()};
    }

    ArcEffects effects;

  private:
    ProcessSettings process_;
    std::uint64_t number_ = 0;
};

double areaOfSmoke(const FumePuff& puff) {
    return double(puff.depth) * 3.14159265358979 * double(puff.radius) * double(glm::length(puff.way));
}

} // namespace

TEST_CASE("air over a source of heat rises as its speed says, and faster by the cube root of the power", "[effects]") {
    const double speed = FumePlume::speedAtMetre(80);
    double height = 0.02;
    constexpr int kParts = 20000;
    for (int i = 0; i < kParts; ++i)
        height += speed / std::cbrt(height) * 0.5 / kParts;
    CHECK(FumePlume::height(0.02, speed, 0.5) == Approx(height).epsilon(1e-3));
    CHECK(FumePlume::speedAtMetre(640) == Approx(2 * speed));
    // The flux of buoyancy is equal at all heights: half width squared times speed times lightness, which falls as
    // z^(-5/3); lightness drives the momentum flux: d(b² w²)/dz = b² g'.
    const double buoyancy = 9.81 * 80 / (3.14159265358979 * 1.2 * 1005 * 293);
    const auto momentum = [&](double z) { return std::pow(FumePlume::kWidens * z * speed / std::cbrt(z), 2); };
    const double z = 0.1, flow = std::pow(FumePlume::kWidens * z, 2) * speed / std::cbrt(z);
    CHECK((momentum(z + 1e-5) - momentum(z - 1e-5)) / 2e-5 ==
          Approx(std::pow(FumePlume::kWidens * z, 2) * buoyancy / flow).epsilon(1e-4));
}

TEST_CASE("puffs rise and grow, and keep their smoke until they thin out", "[effects]") {
    Burning weld(smaw());
    weld.run(4);
    REQUIRE(weld.puffs().size() == 1); // the first puff, followed from here on
    weld.run(2, false);
    FumePuff before = weld.puffs().front();
    const double smoke = areaOfSmoke(before);
    CHECK(smoke > 1e-5);
    int kept = 0;
    for (int i = 0; i < 200 && !weld.puffs().empty(); ++i) {
        weld.run(1, false);
        const auto now = weld.puffs();
        if (now.empty()) break;
        const FumePuff& puff = now.front();
        INFO(i << ": at a height of " << puff.place.y);
        CHECK(puff.place.y > before.place.y);
        CHECK(puff.radius > before.radius);
        CHECK(puff.depth < before.depth);
        // A puff has a plume's width at its height; the plume begins where that equals the arc's own width.
        CHECK(double(puff.radius - before.radius) ==
              Approx(FumePuffs::kSpreads * FumePlume::kWidens * double(puff.place.y - before.place.y)).epsilon(1e-3));
        CHECK(glm::length(puff.way) >= puff.radius);
        if (double(puff.place.y) < FumePuffs::kThins && i < 50) {
            CHECK(areaOfSmoke(puff) == Approx(smoke).epsilon(1e-4));
            ++kept;
        }
        before = puff;
    }
    CHECK(kept > 10);
    CHECK(weld.puffs().empty());
    CHECK(areaOfSmoke(before) < 0.02 * smoke); // it did not vanish at once
}

TEST_CASE("an arc that burns has some two dozen puffs over it, evenly born, and none is far away", "[effects]") {
    Burning weld(smaw());
    weld.run(180);
    size_t most = 0, fewest = 1000;
    for (int i = 0; i < 270; ++i) {
        weld.run(1);
        const auto puffs = weld.puffs();
        most = std::max(most, puffs.size());
        fewest = std::min(fewest, puffs.size());
        for (const FumePuff& puff : puffs) {
            CHECK(puff.place.y >= 0.002F);
            CHECK(double(puff.place.y) < 0.003 + FumePuffs::kHighest);
            CHECK(std::hypot(puff.place.x, puff.place.z) < 0.2F);
            CHECK(puff.depth > 0);
        }
    }
    CHECK(fewest >= 12);
    CHECK(most <= FumePuffs::kMost);
    weld.run(int(FumePuffs::kLongest / kStep) + 2, false);
    CHECK(weld.puffs().empty());
}

TEST_CASE("nothing smokes that has no fume, and another attempt begins with clear air", "[effects]") {
    ProcessSettings gtaw, gmaw;
    gtaw.choose<Gtaw>();
    gmaw.choose<Gmaw>();
    Burning clean(gtaw), wire(gmaw), stick(smaw());
    for (Burning* each : {&clean, &wire, &stick})
        each->run(90);
    CHECK(clean.puffs().empty());
    REQUIRE(wire.puffs().size() == stick.puffs().size());
    CHECK(areaOfSmoke(wire.puffs().back()) < areaOfSmoke(stick.puffs().back()));
    stick.effects.reset();
    CHECK(stick.puffs().empty());
    Burning cold(smaw());
    cold.run(90, false);
    CHECK(cold.puffs().empty());
}

TEST_CASE("two runs have the same puffs to the last bit, whatever was looked at, and so has one that was sought",
          "[effects]") {
    Burning one(smaw()), other(smaw()), sought(smaw());
    one.run(300);
    for (int i = 0; i < 300; ++i) {
        other.run(1);
        (void)other.puffs();
        sought.run(1);
        if (i == 100) sought.effects.reset();
    }
    const auto a = one.puffs();
    REQUIRE(a.size() > 12);
    for (const auto& b : {other.puffs(), sought.puffs()}) {
        REQUIRE(a.size() == b.size());
        CHECK(std::memcmp(a.data(), b.data(), a.size() * sizeof(FumePuff)) == 0);
    }
    for (size_t i = 1; i < a.size(); ++i) // all puffs differ
        CHECK(a[i].grain != a[i - 1].grain);
}

TEST_CASE("smoke under a plate spreads along it", "[effects]") {
    Burning weld(smaw());
    const std::array<WorkpieceBlock, 1> plate{WorkpieceBlock{{-1, 0.03F, -1}, {1, 0.04F, 1}}};
    weld.effects.setGround({plate, {0, 1, 0}, -1});
    weld.run(120);
    float farthest = 0;
    for (const FumePuff& puff : weld.puffs()) {
        CHECK(puff.place.y < 0.03F);
        farthest = std::max(farthest, std::hypot(puff.place.x, puff.place.z));
    }
    CHECK(farthest > 0.1F);
}

} // namespace meltpool
