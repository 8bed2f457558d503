#include "app/commands/speed_doctor.hpp"

#include "core/base/resources.hpp"
#include "core/base/text.hpp"
#include "core/gl/context.hpp"
#include "core/training/trainer/trainer.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

namespace meltpool {

namespace {

using Clock = std::chrono::steady_clock;

/// Least speed of the metal over real time. No source: chosen, a fifth of the time for picture, surface and menus.
constexpr double kBearable = 1.25;
constexpr std::array<float, 3> kSpacings{1, 1.5F, 2}; // mm
// The pool has its full width after about a second of welding; 3 x 3.3 s in all.
constexpr double kWarmUp = 1.8;    // s
constexpr double kMeasuring = 1.5; // s

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string speedText(const WeldSpeed& speed) {
    return formatNumber(speed.spacingMm) + " mm: " + std::to_string(std::lround(speed.ratio * 100)) + " %";
}

} // namespace

WeldSpeed measureWeldSpeed(gl::ShaderLibrary& shaders, const Lesson& lesson, double warmUp, double seconds) {
    Trainer trainer(shaders, lesson);
    const auto weld = [&](double wall) {
        const auto start = Clock::now();
        const double before = trainer.time();
        do {
            trainer.advance(trainer.demonstration(), nullptr);
            glFinish();
        } while (secondsSince(start) < wall);
        return (trainer.time() - before) / secondsSince(start);
    };
    weld(0); // the driver compiles its programs
    weld(warmUp);
    return {lesson.workpiece.spacingMm, weld(seconds)};
}

std::optional<float> bearableSpacing(std::span<const WeldSpeed> speeds) {
    std::optional<float> finest;
    for (const WeldSpeed& speed : speeds)
        if (speed.ratio >= kBearable && (!finest || speed.spacingMm < *finest)) finest = speed.spacingMm;
    return finest;
}

Finding speedFinding(std::span<const WeldSpeed> speeds) {
    Finding finding{"speed of a weld", Finding::State::note, "metal alone, share of real time, at ", ""};
    for (size_t i = 0; i < speeds.size(); ++i)
        finding.found += (i == 0 ? "" : ", at ") + speedText(speeds[i]);
    const std::optional<float> spacing = bearableSpacing(speeds);
    if (spacing == speeds.front().spacingMm)
        finding.state = Finding::State::good;
    else if (spacing)
        finding.remedy = "set \"Particle spacing\" to " + formatNumber(*spacing) +
                         " mm on a lesson's first page; the window chooses its picture by itself";
    else
        finding.remedy = "a graphics card; without one lessons run slower than the clock";
    return finding;
}

void inspectSpeed(std::vector<Finding>& findings) {
    try {
        const gl::HeadlessContext context(false);
        gl::ShaderLibrary shaders(resourceFolder() / "shaders");
        Lesson lesson = findLesson("gmaw-bead", resourceFolder() / "data" / "lessons");
        std::vector<WeldSpeed> speeds;
        for (const float spacing : kSpacings) {
            lesson.set("spacing_mm", formatNumber(spacing), "doctor");
            speeds.push_back(measureWeldSpeed(shaders, lesson, kWarmUp, kMeasuring));
            if (bearableSpacing(speeds)) break;
        }
        findings.push_back(speedFinding(speeds));
    } catch (const std::exception& fault) {
        findings.push_back({"speed of a weld", Finding::State::note, fault.what(), ""});
    }
}

} // namespace meltpool
