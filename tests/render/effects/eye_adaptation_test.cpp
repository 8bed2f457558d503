// The auto-darkening filter's times, the eye's step response, and looks into the arc.
#include "core/render/effects/worn_visor.hpp"
#include "core/render/look/heat_colours.hpp"
#include "tests/support/catch.hpp"

#include <cmath>
#include <numbers>

namespace meltpool {

namespace {

/// Returns the seconds until the exposure has covered 63 % of its way, in logarithms, after the scene changes from
/// `before` to `after`.
double timeConstant(const EyeScene& before, const EyeScene& after) {
    EyeAdaptation eye;
    eye.update(before, 1);
    const double from = std::log(double(eye.exposure())), to = std::log(EyeAdaptation::aim(after));
    constexpr double kStep = 1e-3;
    for (double time = 0; time < 10; time += kStep) {
        if (std::abs(std::log(double(eye.exposure())) - from) >= (1 - std::exp(-1.0)) * std::abs(to - from))
            return time;
        eye.update(after, kStep);
    }
    return 10;
}

} // namespace

TEST_CASE("light about the pool is the mean over a disc of 30 mm of what the arc throws there", "[effects]") {
    const double height = 2e-3, intensity = 10, radius = 15e-3;
    double sum = 0;
    constexpr int kRings = 20000;
    for (int i = 0; i < kRings; ++i) {
        const double r = (i + 0.5) * radius / kRings, square = r * r + height * height;
        sum += intensity * height / std::sqrt(square) / (std::numbers::pi * square) * 2 * r * radius / kRings;
    }
    CHECK(poolLight(intensity, height) == Approx(0.3 * sum / (radius * radius)).epsilon(1e-4));
}

TEST_CASE("the eye is used to more light after 0.3 s and to less after 1 to 2 s", "[effects]") {
    EyeScene dark, bright;
    dark.room = 0.1;
    bright.room = 0.5;
    CHECK(EyeAdaptation::aim(dark) == Approx(1.8));
    CHECK(EyeAdaptation::aim(bright) == Approx(0.36));
    CHECK(timeConstant(dark, bright) == Approx(0.3).margin(0.02));
    CHECK(timeConstant(bright, dark) == Approx(1.5).margin(0.05));
    // One step and many steps give one result.
    EyeAdaptation coarse, fine;
    for (EyeAdaptation* eye : {&coarse, &fine})
        eye->update(dark, 1);
    coarse.update(bright, 0.5);
    for (int i = 0; i < 500; ++i)
        fine.update(bright, 1e-3);
    CHECK(coarse.exposure() == Approx(fine.exposure()).epsilon(1e-4));
    EyeScene black;
    CHECK(EyeAdaptation::aim(black) == Approx(EyeAdaptation::kBrightest));
    bright.room = 1e6;
    CHECK(EyeAdaptation::aim(bright) == Approx(EyeAdaptation::kDarkest));
}

TEST_CASE("an auto-darkening filter darkens in its time, stays dark, and clears", "[effects]") {
    const VisorSettings visor{11, 4, 0.2F};
    VisorFilter filter;
    CHECK(filter.shade(visor) == 4);
    filter.update(true, 0.1, visor);
    CHECK(filter.shade(visor) == Approx(7.5));
    filter.update(true, 0.1, visor);
    CHECK(filter.shade(visor) == Approx(11));
    filter.update(false, 0.14, visor);
    CHECK(filter.shade(visor) == Approx(11));
    filter.update(false, 0.01 + 0.125, visor);
    CHECK(filter.shade(visor) == Approx(7.5));
    filter.update(false, 1, visor);
    CHECK(filter.shade(visor) == 4);
    VisorFilter quick;
    quick.update(true, 1e-4, {11, 4, 1e-4F});
    CHECK(quick.darkness() == 1);
    // A filter without a light state is always dark; a missing visor never is.
    CHECK(VisorFilter().shade({11, 0, 1e-4F}) == 11);
    CHECK(VisorFilter().shade({0, 3, 1e-4F}) == 0);
}

TEST_CASE("after the arc the picture is dark and brightens as the visor clears and the eye recovers", "[effects]") {
    LookParameters look;
    look.adaptation = true;
    look.visorShade = 10;
    look.visorLightShade = 3;
    const VisorSettings visor = visorOf(look);
    WornVisor worn;
    const SeenArc arc{10, 1.5e-3, true, {0, 0, -1}};
    const auto light = [&] { // displayed light of paper in the workshop
        LookParameters seen = look;
        worn.wear(visor, seen);
        return double(seen.exposure * filterShare(seen.visorShade));
    };
    for (int i = 0; i < 300; ++i)
        worn.update(arc, visor, look, 0.01);
    const double dark = light();
    CHECK(worn.filter().shade(visor) == 10);
    worn.update({}, visor, look, 0.1);
    const double held = light();
    for (int i = 0; i < 40; ++i)
        worn.update({}, visor, look, 0.01);
    const double cleared = light();
    for (int i = 0; i < 500; ++i)
        worn.update({}, visor, look, 0.01);
    const double adapted = light();
    CHECK(held < 2 * dark);
    CHECK(cleared > 100 * dark);
    CHECK(adapted > 2 * cleared);
    CHECK(adapted > 0.3);
    CHECK(worn.sentence().empty()); // the visor protected the eye
}

TEST_CASE("looks into the arc are told with their length, whether without a visor or through one that was slow",
          "[effects]") {
    LookParameters look;
    const SeenArc arc{10, 1.5e-3, true, {0, 0, -1}};
    WornVisor bare;
    for (int i = 0; i < 120; ++i)
        bare.update(arc, visorOf(look), look, 0.01);
    CHECK(bare.sentence() == "You looked into the arc without a visor for 1.2 s.");
    CHECK(bare.eye().afterImage().strength == Approx(1 - std::exp(-1.2 / EyeAdaptation::kBurnsIn)).epsilon(1e-3));
    bare.update({}, visorOf(look), look, 4);
    CHECK(bare.sentence() == "You looked into the arc without a visor for 1.2 s.");
    CHECK(bare.eye().afterImage().strength < 0.4F);
    bare.update({}, visorOf(look), look, 4);
    CHECK(bare.sentence().empty());
    // An arc away from the gaze does not count.
    WornVisor aside;
    SeenArc beside = arc;
    beside.inSight = false;
    aside.update(beside, visorOf(look), look, 1);
    CHECK(aside.sentence().empty());
    CHECK(aside.eye().afterImage().strength == 0);
    look.visorShade = 10;
    look.visorLightShade = 3;
    look.visorSwitching = 1;
    WornVisor slow;
    for (int i = 0; i < 200; ++i)
        slow.update(arc, visorOf(look), look, 0.01);
    CHECK(slow.sentence() == "The visor was still light: you looked into the arc for 0.6 s.");
}

TEST_CASE("a look with a fixed visor and without adaptation stays as it is", "[effects]") {
    LookParameters look;
    look.visorShade = 10;
    WornVisor worn;
    worn.update({10, 1e-3, true, {0, 0, -1}}, visorOf(look), look, 0.5);
    LookParameters seen = look;
    worn.wear(visorOf(look), seen);
    CHECK(seen.visorShade == 10);
    CHECK(seen.exposure == 1);
}

} // namespace meltpool
