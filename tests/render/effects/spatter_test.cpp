// Spatter's births from the arc's steps: as many bursts as re-ignitions, none with tungsten, and reproducible.
#include "core/render/effects/arc_effects.hpp"
#include "core/render/effects/counted_chance.hpp"
#include "tests/support/catch.hpp"

#include <glm/geometric.hpp>

#include <array>
#include <cstring>

namespace meltpool {

namespace {

constexpr double kStep = 1.0 / 90;

ProcessSettings gmaw() {
    ProcessSettings settings;
    settings.choose<Gmaw>();
    return settings;
}

ArcState arcOf(ArcAction action, float stretch = 0) {
    ArcState arc;
    arc.action = action;
    arc.current = 180;
    arc.voltage = 21;
    arc.length = action == ArcAction::shorting ? 0 : 3e-3F;
    arc.shorts = action == ArcAction::shorting ? 80.0F : 0;
    arc.stretch = stretch;
    return arc;
}

const std::array<WorkpieceBlock, 1> kPlate{WorkpieceBlock{{-0.05F, -0.006F, -0.025F}, {0.05F, 0, 0.025F}}};

/// Welds with this arc; each third step has a short circuit, and each ninth step has one more.
class Weld {
  public:
    Weld(ProcessSettings process, ArcState arc) : process_(process), arc_(arc) {
        effects.setGround({kPlate, {0, 1, 0}, -0.012F});
    }

    void run(int steps) {
        for (int i = 0; i < steps; ++i) {
            ++number_;
            std::array<Reignition, 2> shorts{{{0.2F * float(kStep), 3500}, {0.7F * float(kStep), 3500}}};
            size_t count = 0;
            if (arc_.action == ArcAction::shorting) count = number_ % 9 == 0 ? 2 : number_ % 3 == 0 ? 1 : 0;
            reignitions += count;
            ArcEffectsStep step;
            step.number = number_;
            step.time = double(number_) * kStep;
            step.seconds = kStep;
            step.process = &process_;
            step.arc = arc_;
            step.place = {0, 0.001F, 0};
            step.wireEnd = {0, 0.003F, 0};
            step.reignitions = std::span(shorts).first(count);
            step.dropRate = 40;
            effects.step(step);
        }
    }
    void burn(const ArcState& arc) { arc_ = arc; }
    void goOut() { arc_ = {}; }

    ArcEffects effects;
    size_t reignitions = 0;

  private:
    ProcessSettings process_;
    ArcState arc_;
    std::uint64_t number_ = 0;
};

} // namespace

TEST_CASE("each short circuit that ends throws one burst, and the strike one more", "[effects]") {
    Weld weld(gmaw(), arcOf(ArcAction::striking));
    weld.run(1);
    CHECK(weld.effects.spatter().bursts() == 1);
    weld.burn(arcOf(ArcAction::shorting));
    weld.run(89);
    REQUIRE(weld.reignitions == 40);
    CHECK(weld.effects.spatter().bursts() == 41);
    CHECK(weld.effects.spatter().born() >= 41);
    CHECK(weld.effects.spatter().born() <= 25 + 45 + 40 * 14);
    const auto born = weld.effects.spatter().born();
    weld.goOut();
    weld.run(60);
    CHECK(weld.effects.spatter().born() == born); // none without an arc
    CHECK(weld.effects.spatter().bursts() == 41);
}

TEST_CASE("short circuits that the machine controls throw nothing", "[effects]") {
    ProcessSettings process = gmaw();
    process.of<Gmaw>().shortCircuits = static_cast<int>(ShortCircuitKind::controlled);
    Weld weld(process, arcOf(ArcAction::striking));
    weld.run(1);
    const auto born = weld.effects.spatter().born();
    CHECK(born > 0);
    weld.burn(arcOf(ArcAction::shorting));
    weld.run(89);
    CHECK(weld.reignitions == 40);
    CHECK(weld.effects.spatter().born() == born);
}

TEST_CASE("a long arc spatters more than a short one, a covered electrode more than a wire, tungsten never",
          "[effects]") {
    const auto bornOf = [](const ProcessSettings& process, const ArcState& arc) {
        Weld weld(process, arc);
        weld.run(900);
        return weld.effects.spatter().born();
    };
    const auto normal = bornOf(gmaw(), arcOf(ArcAction::burning)),
               stretched = bornOf(gmaw(), arcOf(ArcAction::breaking, 0.8F));
    CHECK(stretched > 5 * normal);
    CHECK(normal > 60); // sum over ten seconds
    ProcessSettings smaw, gtaw;
    smaw.choose<Smaw>();
    gtaw.choose<Gtaw>();
    const auto rutile = bornOf(smaw, arcOf(ArcAction::burning));
    CHECK(rutile > normal);
    smaw.of<Smaw>().electrode = 2; // cellulosic electrode
    CHECK(double(bornOf(smaw, arcOf(ArcAction::burning))) == Approx(2 * double(rutile)).epsilon(0.1));
    CHECK(bornOf(gtaw, arcOf(ArcAction::breaking, 0.9F)) == 0);
}

TEST_CASE("two runs of the same steps show the same spatter, to the last bit", "[effects]") {
    Weld one(gmaw(), arcOf(ArcAction::shorting)), other(gmaw(), arcOf(ArcAction::shorting));
    one.run(200);
    for (int i = 0; i < 200; ++i) {
        other.run(1);
        (void)other.effects.view(); // intermediate frames have no effect
    }
    const ArcEffectsView a = one.effects.view(), b = other.effects.view();
    REQUIRE(a.sparks.size() == b.sparks.size());
    REQUIRE(a.sparks.size() > 20);
    CHECK(a.onTable == b.onTable);
    CHECK(std::memcmp(a.sparks.data(), b.sparks.data(), a.sparks.size_bytes()) == 0);
}

TEST_CASE("what flies is born at the arc, and what has landed lies on the plate or on the table and stays",
          "[effects]") {
    Weld weld(gmaw(), arcOf(ArcAction::shorting));
    weld.run(300);
    weld.goOut();
    weld.run(900);
    const ArcEffectsView view = weld.effects.view();
    REQUIRE(view.sparks.size() > 20);
    REQUIRE(view.sparks.size() <= Spatter::kMostBeads);
    REQUIRE(view.onTable > 0);
    const size_t onPlate = view.sparks.size() - view.onTable;
    for (size_t i = 0; i < view.sparks.size(); ++i) {
        const Spark& bead = view.sparks[i];
        INFO(bead.place.x << " " << bead.place.y << " " << bead.place.z);
        CHECK(bead.way == glm::vec3(0));
        CHECK(2 * bead.radius >= Spatter::kSticks);
        CHECK(bead.kelvin < 900);
        if (i >= onPlate) CHECK(bead.place.y == Approx(-0.012).margin(1e-3));
        if (i < onPlate) CHECK((bead.place.y < 1e-3F && bead.place.y > -0.0065F));
        CHECK(glm::distance(bead.place, {0, 0.001F, 0}) > 4e-3F); // none inside the pool
    }
    const std::vector<Spark> before(view.sparks.begin(), view.sparks.end());
    weld.run(90);
    CHECK(weld.effects.view().sparks.size() == before.size());
}

TEST_CASE("chance is even, and its counters give unrelated numbers", "[effects]") {
    double sum = 0, squares = 0, product = 0;
    for (std::uint64_t step = 0; step < 100; ++step)
        for (std::uint64_t draw = 0; draw < 100; ++draw) {
            const auto a = double(countedChance(step, draw)), b = double(countedChance(step, draw + 1));
            CHECK((a >= 0 && a < 1));
            sum += a;
            squares += a * a;
            product += (a - 0.5) * (b - 0.5);
        }
    CHECK(sum / 1e4 == Approx(0.5).margin(0.01));
    CHECK(squares / 1e4 == Approx(1.0 / 3).margin(0.01));
    CHECK(std::abs(product / 1e4) < 0.003);
}

TEST_CASE("a wire's drops have its volume, and fall from its end into the pool", "[effects]") {
    const double d = WireDrops::dropDiameter(1.2e-3, 0.075, 60);
    CHECK(60 * d * d * d / 6 == Approx(0.075 * 1.2e-3 * 1.2e-3 / 4).epsilon(1e-9));
    CHECK(WireDrops::dropDiameter(1.2e-3, 0.075, 1) == Approx(1.6 * 1.2e-3)); // no thicker drops hang
    Weld weld(gmaw(), arcOf(ArcAction::burning));
    size_t most = 0;
    for (int i = 0; i < 90; ++i) {
        weld.run(1);
        std::vector<Spark> none, all;
        const ArcEffectsView view = weld.effects.view();
        (void)weld.effects.spatter().show((i + 1) * kStep, none);
        const size_t drops = view.sparks.size() - none.size();
        REQUIRE(drops >= 1);
        most = std::max(most, drops);
        for (size_t k = 1; k < drops; ++k) {
            CHECK(view.sparks[k].place.y <= 0.003F);
            CHECK(view.sparks[k].place.y >= 0.0F);
        }
    }
    CHECK(most >= 2);
}

} // namespace meltpool
