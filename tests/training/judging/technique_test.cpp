// Technique against the closed forms of its paths: 0.1 mm, 0.1 degrees, 0.1 mm/s and better.
#include "tests/training/judging/synthetic_weld.hpp"

#include "core/weld/torch/torch_moves.hpp"
#include "tests/support/catch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

using namespace meltpool;
using namespace meltpool::test;
using enum TechniqueQuantity;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kAngleTolerance = 0.02; // degrees
constexpr double kMmTolerance = 0.02;    // mm, and mm/s

Seam jointSeam(WorkpieceKind kind) {
    WorkpieceParameters workpiece;
    workpiece.kind = static_cast<int>(kind);
    return seamOf(workpiece);
}

/// Returns a zigzag from toe to toe with a dwell at both: -1 and 1 are the toes, it begins at the lower one.
double zigzag(double time, double period, double dwell) {
    const double way = period / 2 - dwell;
    const double phase = time - std::floor(time / period) * period;
    if (phase < dwell) return -1;
    if (phase < period / 2) return -1 + 2 * (phase - dwell) / way;
    if (phase < period / 2 + dwell) return 1;
    return 1 - 2 * (phase - period / 2 - dwell) / way;
}

} // namespace

TEST_CASE("speed, tilt in both planes, aim and distance are the path's, both ways", "[training][technique]") {
    const WorkpieceKind kind = GENERATE(WorkpieceKind::Plate, WorkpieceKind::Tee, WorkpieceKind::Butt);
    const int direction = GENERATE(1, -1);
    const double work = GENERATE(-25.0, 0.0, 14.0);
    const double travel = GENERATE(-18.0, 12.0);
    INFO(static_cast<int>(kind) << " " << direction << " " << work << " " << travel);
    Hand held;
    held.direction = direction;
    held.workDeg = work;
    held.travelDeg = travel;
    held.aimMm = 1.3;
    held.distanceMm = 14.2;
    const Technique technique = weldWith(jointSeam(kind), 8, [&](double time) {
        held.placeMm = direction * (-30 + 6.4 * time);
        return held;
    });
    CHECK(technique.direction() == direction);
    const auto seam = alongSeam(technique);
    CHECK(farthestFrom(6.4, seam, travelSpeed) < kMmTolerance);
    CHECK(farthestFrom(work, seam, workAngle) < kAngleTolerance);
    CHECK(farthestFrom(travel, seam, travelAngle) < kAngleTolerance);
    CHECK(farthestFrom(1.3, seam, aim) < kMmTolerance);
    CHECK(farthestFrom(14.2, seam, distance) < kMmTolerance);
    CHECK(farthestFrom(0, seam, weaveWidth) == 0);
    CHECK(farthestFrom(2 * std::cos(work * kPi / 180) * std::cos(travel * kPi / 180), seam, height) < kMmTolerance);
    CHECK(seam.size() == 52); // 8 s at 6.4 mm/s, and a part of the last millimetre
}

TEST_CASE("angles are those that a written torch path asks for", "[training][technique]") {
    // A tee in 2F: the path's work angle counts from the base plate, the technique's from the bisector at 45 degrees.
    TorchMove move;
    move.duration = 6;
    move.from = {0.03F, 0, 0};
    move.to = {-0.03F, 0, 0};
    move.fromOrientation = move.toOrientation = heldOrientation(38 * kPi / 180, 11 * kPi / 180, glm::vec3(-1, 0, 0));
    Technique technique(jointSeam(WorkpieceKind::Tee));
    for (int i = 0; i < 3000; ++i)
        technique.add(move.sample(i * kTimeStep), arcOf({}));
    const auto seam = alongSeam(technique);
    CHECK(farthestFrom(7, seam, workAngle) < kAngleTolerance);
    CHECK(farthestFrom(11, seam, travelAngle) < kAngleTolerance);
    CHECK(farthestFrom(10, seam, travelSpeed) < kMmTolerance);
    CHECK(farthestFrom(0, seam, aim) < kMmTolerance);
}

TEST_CASE("what the hand does now waits for what is not known yet", "[training][technique]") {
    const Seam seam = plateSeam();
    Technique technique(seam);
    Hand held;
    held.travelDeg = 10;
    held.direction = -1;
    const auto goTo = [&](double time) {
        held.placeMm = 20 - 5 * time;
        held.burns = time >= 1;
        technique.add(torchOf(seam, time, held), arcOf(held));
    };
    for (int i = 0; i < 500; ++i)
        goTo(i * kTimeStep);
    CHECK(std::isnan(technique.now()[travelAngle])); // no arc, no travel
    CHECK(std::isnan(technique.now()[travelSpeed]));
    CHECK(std::abs(technique.now()[workAngle]) < 1e-4);
    for (int i = 500; i < 500 + 40; ++i)
        goTo(i * kTimeStep);
    CHECK(std::isnan(technique.now()[travelSpeed])); // 78 ms of arc
    for (int i = 540; i < 500 + 298; ++i)
        goTo(i * kTimeStep);
    CHECK(technique.direction() == 0); // 2.97 mm
    CHECK(technique.now()[travelSpeed] == Approx(5e-3).epsilon(1e-3));
    CHECK(std::isnan(technique.now()[travelAngle]));
    for (int i = 798; i < 900; ++i)
        goTo(i * kTimeStep);
    CHECK(technique.direction() == -1);
    CHECK(technique.now()[travelAngle] == Approx(10 * kPi / 180).epsilon(1e-3));
    CHECK(technique.now()[travelSpeed] == Approx(5e-3).epsilon(1e-3));
}

TEST_CASE("arc length is that of the arc, and the other distance that of the contact tip", "[training][technique]") {
    ArcState arc = arcOf({});
    arc.distance = 0.015F;
    arc.length = 0.003F;
    Technique wire(plateSeam()), electrode(plateSeam(), {DistanceKind::arcLength, 0.5});
    wire.add(torchOf(plateSeam(), 0, {}), arc);
    electrode.add(torchOf(plateSeam(), 0, {}), arc);
    CHECK(wire.now()[distance] == Approx(0.015));
    CHECK(electrode.now()[distance] == Approx(0.003));
    arc.action = ArcAction::out;
    electrode.add(torchOf(plateSeam(), 0.01, {}), arc);
    CHECK(std::isnan(electrode.now()[distance]));
}

TEST_CASE("a sine weave has its width and frequency, its centre line and the speed along the seam",
          "[training][technique]") {
    const double drift = GENERATE(0.0, 0.25); // mm/s across
    const auto seam = alongSeam(weldWith(plateSeam(), 16, [&](double time) {
        Hand hand;
        hand.placeMm = -40 + 4 * time;
        hand.aimMm = 1 + drift * time + 2.7 * std::sin(2 * kPi * 1.3 * time);
        return hand;
    }));
    CHECK(farthestFrom(5.4, seam, weaveWidth) < 0.05);
    CHECK(farthestFrom(1.3, seam, weaveFrequency) < 0.01);
    CHECK(farthestFrom(4, seam, travelSpeed) < kMmTolerance);
    for (const SeamMillimetre& mm : seam) {
        const double time = (mm.place * 1e3 + 40) / 4;
        INFO(mm.place);
        if (mm.judged) CHECK(mm.values[aim] * 1e3 == Approx(1 + drift * time).margin(0.1));
    }
    CHECK(meanOf(seam, weaveDwell) == Approx(0.1310 / 1.3).margin(0.005));
}

TEST_CASE("a zigzag's dwell at the toes is its pause", "[training][technique]") {
    const double dwell = GENERATE(0.0, 0.15, 0.3);
    const auto seam = alongSeam(weldWith(plateSeam(), 18, [&](double time) {
        Hand hand;
        hand.placeMm = -40 + 3 * time;
        hand.aimMm = -0.5 + 4 * zigzag(time, 1.25, dwell);
        return hand;
    }));
    CHECK(farthestFrom(8, seam, weaveWidth) < 0.1);
    CHECK(farthestFrom(0.8, seam, weaveFrequency) < 0.01);
    CHECK(farthestFrom(dwell, seam, weaveDwell) < 0.01);
    CHECK(farthestFrom(-0.5, seam, aim) < 0.1);
}

TEST_CASE("a hand's tremor is no weave", "[training][technique]") {
    const auto seam = alongSeam(weldWith(plateSeam(), 10, [&](double time) {
        Hand hand;
        hand.placeMm = -30 + 6 * time + 0.3 * std::cos(2 * kPi * 8 * time);
        hand.aimMm = 0.3 * std::sin(2 * kPi * 8 * time);
        return hand;
    }));
    CHECK(farthestFrom(0, seam, weaveWidth) == 0);
    CHECK(farthestFrom(0, seam, whipLength) == 0);
    CHECK(farthestFrom(6, seam, travelSpeed) < 0.35);
    CHECK(meanOf(seam, travelSpeed) == Approx(6).margin(0.1));
}

TEST_CASE("tremor that comes and goes neither makes a weave nor hides one", "[training][technique]") {
    // The tremor has twelve waves from 7 to 9 Hz, together 0.3 mm or 2 degrees r.m.s. in each direction.
    const unsigned seed = GENERATE(1U, 2U, 3U);
    std::mt19937 random(seed);
    std::array<std::array<double, 12>, 4> phases{};
    for (auto& each : phases)
        for (double& phase : each)
            phase = static_cast<double>(random()) * (2 * kPi / 4294967296.0);
    const auto tremor = [&](size_t which, double time) {
        double sum = 0;
        for (size_t k = 0; k < 12; ++k)
            sum += std::sin(2 * kPi * (7 + 2 * static_cast<double>(k) / 11) * time + phases[which][k]);
        return sum / std::sqrt(6.0);
    };
    for (const double weave : {0.0, 3.0}) {
        const auto seam = alongSeam(weldWith(plateSeam(), 16, [&](double time) {
            Hand hand;
            hand.placeMm = -40 + 5 * time + 0.3 * tremor(0, time);
            hand.aimMm = weave * std::sin(2 * kPi * 1.1 * time) + 0.3 * tremor(1, time);
            hand.workDeg = 2 * tremor(2, time);
            hand.travelDeg = 10 + 2 * tremor(3, time);
            return hand;
        }));
        INFO(seed << " " << weave);
        CHECK(farthestFrom(0, seam, whipLength) == 0);
        CHECK(farthestFrom(5, seam, travelSpeed) < 1);
        CHECK(meanOf(seam, travelSpeed) == Approx(5).margin(0.1));
        CHECK(meanOf(seam, aim) == Approx(0).margin(0.15));
        CHECK(meanOf(seam, travelAngle) == Approx(10).margin(0.3));
        CHECK(meanOf(seam, workAngle) == Approx(0).margin(0.3));
        CHECK(meanOf(seam, weaveWidth) == Approx(2 * weave).margin(weave > 0 ? 1.2 : 1e-12));
        CHECK(meanOf(seam, weaveFrequency) == Approx(weave > 0 ? 1.1 : 0).margin(0.05));
    }
}

TEST_CASE("on a pipe angles count from the tangent, places go on around it", "[training][technique]") {
    const int direction = GENERATE(1, -1);
    const double height = GENERATE(5.0, 40.0); // far from the pipe the tip is over another place than the arc
    const Seam pipe = Seam::circle({0, -0.03, 0}, {0, 0, -1}, {0, 0, 0});
    const double around = pipe.length() * 1e3;
    const double seconds = (around + 20) / 5;
    const Technique technique = weldWith(pipe, seconds, [&](double time) {
        Hand hand;
        hand.direction = direction;
        hand.placeMm = direction * (around / 2 - 7 + 5 * time); // from below, once around, 20 mm past the start
        hand.workDeg = 6;
        hand.travelDeg = -9;
        hand.aimMm = -0.8;
        hand.tipHeightMm = height;
        return hand;
    });
    CHECK(std::abs(technique.steps().back().place - technique.steps().front().place) * 1e3 ==
          Approx(around + 20).margin(0.1));
    const auto seam = alongSeam(technique);
    CHECK(seam.size() == static_cast<size_t>(std::ceil(around)));
    CHECK(farthestFrom(5, seam, travelSpeed) < kMmTolerance);
    CHECK(farthestFrom(6, seam, workAngle) < kAngleTolerance);
    CHECK(farthestFrom(-9, seam, travelAngle) < kAngleTolerance);
    CHECK(farthestFrom(-0.8, seam, aim) < kMmTolerance);
    CHECK(farthestFrom(12, seam, distance) < kMmTolerance);
}

TEST_CASE("no speed is taken across a gap of the arc or of the tracking", "[training][technique]") {
    const bool tracking = GENERATE(false, true);
    // While the arc is out the torch moves far faster, afterwards as before.
    const Technique technique = weldWith(plateSeam(), 12, [&](double time) {
        Hand hand;
        hand.placeMm = time < 6 ? -40 + 5 * time : time < 6.2 ? -10 + 100 * (time - 6) : 10 + 5 * (time - 6.2);
        const bool gap = time >= 6 && time < 6.2;
        hand.burns = tracking || !gap;
        hand.tracked = !(tracking && gap);
        return hand;
    });
    const auto seam = alongSeam(technique);
    CHECK(farthestFrom(5, seam, travelSpeed) < kMmTolerance);
    for (const SeamMillimetre& mm : seam) {
        INFO(mm.place);
        CHECK((mm.place < -9e-3 || mm.place > 9.5e-3));
    }
    CHECK(technique.faults().lostSeconds == Approx(tracking ? 0.2 : 0).margin(0.003));
}

TEST_CASE("no speed is taken across a jump of the torch, and nothing between was welded", "[training][technique]") {
    const auto seam = alongSeam(weldWith(plateSeam(), 10, [&](double time) {
        Hand hand;
        hand.placeMm = -30 + 5 * time + (time < 5 ? 0 : 4);
        return hand;
    }));
    CHECK(farthestFrom(5, seam, travelSpeed) < kMmTolerance);
    CHECK(std::none_of(seam.begin(), seam.end(),
                       [](const SeamMillimetre& mm) { return mm.place > -5e-3 && mm.place < -1e-3; }));
}

TEST_CASE("a missing sample ends the stretch and is counted", "[training][technique]") {
    const Seam plate = plateSeam();
    Technique technique(plate);
    for (int i = 0; i < 2000; ++i) {
        if (i >= 1000 && i < 1100) continue;
        Hand hand;
        hand.placeMm = 5 * i * kTimeStep + (i < 1000 ? 0 : 15);
        technique.add(torchOf(plate, i * kTimeStep, hand), arcOf(hand));
    }
    CHECK(technique.faults().dropped == 1);
    CHECK(farthestFrom(5, alongSeam(technique), travelSpeed) < kMmTolerance);
    technique.noteDropped();
    CHECK(technique.faults().dropped == 2);
    technique.reset();
    CHECK(technique.faults().dropped == 0);
    CHECK(alongSeam(technique).empty());
    technique.noteDropped(); // without an arc no sample is missing
    CHECK(technique.faults().dropped == 0);
}

TEST_CASE("a whip along the seam has its length, period and dwell in the pool", "[training][technique]") {
    const int direction = GENERATE(1, -1);
    // Each stroke takes 1.2 s: 0.5 s in the pool, forward and back in 0.35 s each; in the pool the torch is stationary.
    constexpr double kPeriod = 1.2, kDwell = 0.5, kPitch = 3.6, kForward = 6;
    const auto seam = alongSeam(weldWith(plateSeam(), 24, [&](double time) {
        const double stroke = std::floor(time / kPeriod), phase = time - stroke * kPeriod;
        double way = 0;
        if (phase >= kDwell) way = kForward * (phase - kDwell) / 0.35;
        if (phase >= kDwell + 0.35) way = kForward - (kForward - kPitch) * (phase - kDwell - 0.35) / 0.35;
        Hand hand;
        hand.direction = direction;
        hand.travelDeg = -10;
        hand.placeMm = direction * (-35 + kPitch * stroke + way);
        return hand;
    }));
    CHECK(farthestFrom((kForward + kForward - kPitch) / 2, seam, whipLength, -28, 28) < 0.1);
    CHECK(farthestFrom(kPeriod, seam, whipPeriod, -28, 28) < 0.02);
    CHECK(farthestFrom(kDwell, seam, whipDwell, -28, 28) < 0.02);
    CHECK(farthestFrom(kPitch / kPeriod, seam, travelSpeed, -28, 28) < 0.1);
    CHECK(farthestFrom(-10, seam, travelAngle) < kAngleTolerance);
}

TEST_CASE("the direction turns with the torch, from where it turned", "[training][technique]") {
    const auto seam = alongSeam(weldWith(plateSeam(), 16, [&](double time) {
        Hand hand;
        hand.placeMm = time < 6 ? -20 + 5 * time : 10 - 5 * (time - 6);
        hand.direction = time < 6 ? 1 : -1;
        hand.travelDeg = time < 6 ? 15 : -15;
        return hand;
    }));
    CHECK(farthestFrom(-15, seam, travelAngle, -38, -21) < kAngleTolerance); // only the way back
    CHECK(farthestFrom(0, seam, travelAngle, -15, 5) < 1);                   // both directions within one millimetre
    CHECK(farthestFrom(5, seam, travelSpeed, -38, 5) < kMmTolerance);
}

TEST_CASE("a rod has its angle over the plate and its rhythm", "[training][technique]") {
    const auto weld = [](double gap, double swing) {
        return alongSeam(weldWith(plateSeam(), 20, [&](double time) {
            Hand hand;
            hand.placeMm = -30 + 3 * time;
            hand.rodDeg = 17;
            hand.rodGapMm = gap - swing * std::cos(2 * kPi * 0.9 * time);
            return hand;
        }));
    };
    const auto dipped = weld(6, 5);
    CHECK(farthestFrom(17, dipped, rodAngle) < kAngleTolerance);
    CHECK(farthestFrom(0.9, dipped, rodFrequency) < 0.01);
    const auto still = weld(3, 0);
    CHECK(farthestFrom(0, still, rodFrequency) == 0);
    Hand none;
    const auto without = alongSeam(weldWith(plateSeam(), 10, [&](double time) {
        none.placeMm = 3 * time;
        return none;
    }));
    CHECK(std::isnan(without[10].values[rodAngle]));
    CHECK(std::isnan(without[10].values[rodFrequency]));
}

TEST_CASE("technique.csv has a row a millimetre, and empty cells for what is unknown", "[training][technique]") {
    const auto seam = alongSeam(weldWith(plateSeam(), 3, [&](double time) {
        Hand hand;
        hand.placeMm = 5 * time;
        hand.travelDeg = 10;
        return hand;
    }));
    const std::string text = techniqueCsv(seam, DistanceKind::arcLength);
    CHECK(text.rfind(
              "place_mm,arc_s,judged,known,direction,aim_mm,height_mm,arc_length_mm,work_angle_deg,travel_angle_deg,"
              "speed_mm_s,weave_mm,weave_hz,weave_dwell_s,whip_mm,whip_period_s,whip_dwell_s,rod_angle_deg,"
              "rod_hz,current_a,voltage_v\n0.5,",
              0) == 0);
    CHECK(std::count(text.begin(), text.end(), '\n') == static_cast<int>(seam.size()) + 1);
    CHECK(text.find(",,,") != std::string::npos); // no rod
    CHECK(techniqueCsv(seam, DistanceKind::ctwd).find(",ctwd_mm,") != std::string::npos);
}

TEST_CASE("the welded range goes from the first to the last place of an arc that lasted, and stops there",
          "[technique]") {
    CHECK_FALSE(weldedRange(Technique(plateSeam())));
    // Flashes at -40 mm, welds from -20 to 10 mm, goes back to 0 with the arc out and welds on to 5 mm.
    const auto hand = [](double t) {
        Hand now;
        if (t < 0.3)
            now.placeMm = -40;
        else if (t < 3.5)
            now.placeMm = -20 + 10 * std::clamp(t - 0.5, 0.0, 3.0);
        else
            now.placeMm = 10 * std::clamp(t - 4, 0.0, 0.5);
        now.burns = t < 0.3 || (t > 0.5 && t < 3.5) || t > 4;
        return now;
    };
    const auto range = weldedRange(weldWith(plateSeam(), 4.6, hand));
    REQUIRE(range);
    CHECK(range->stretch.low * 1e3 == Approx(-20).margin(0.2));
    CHECK(range->stretch.high * 1e3 == Approx(10).margin(0.2));
    CHECK(range->stop * 1e3 == Approx(5).margin(0.2));
}
