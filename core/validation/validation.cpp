#include "core/validation/validation.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>

namespace meltpool {

namespace {

struct Runner {
    std::string_view kind;
    CaseRunner run;
};

constexpr std::array kRunners{
    Runner{"conduction_step", runConductionStep},
    Runner{"conduction_flux", runConductionFlux},
    Runner{"stefan_one_phase", runStefan},
    Runner{"stefan_two_phase", runStefan},
    Runner{"rosenthal_thick", runRosenthal},
    Runner{"rosenthal_thin", runRosenthal},
    Runner{"energy", runEnergy},
    Runner{"cavity_melting", runCavityMelting},
    Runner{"bead_on_plate", runBeadOnPlate},
    Runner{"fillet", runFillet},
    Runner{"chart_tee", runChartWeld},
    Runner{"chart_lap", runChartWeld},
    Runner{"chart_butt", runChartWeld},
    Runner{"arc_spot", runArcSpot},
    Runner{"cooling", runCooling},
    Runner{"droplet_pressure", runDropletPressure},
    Runner{"droplet_oscillation", runDropletOscillation},
    Runner{"sessile_drop", runSessileDrop},
    Runner{"hydrostatic", runHydrostatic},
    Runner{"dam_break", runDamBreak},
    Runner{"poiseuille", runPoiseuille},
};

/// Returns a number next to its measured reference; the error is relative, but for a measured 0 a hundred times ours.
ValidationNumber measuredNumber(const std::string& name, double reference, double ours, double tolerance) {
    const double by = reference == 0 ? 1 : std::abs(reference);
    const double off = 100 * std::abs(ours - reference) / by;
    return {name, "measured", reference, ours, off, tolerance, off <= tolerance, {}};
}

} // namespace

bool ValidationResult::passed() const {
    if (!error.empty()) return false;
    for (const ValidationNumber& number : numbers)
        if (!number.passed) return false;
    return true;
}

void ValidationResult::compareExact(const ValidationCase& from, std::string numberName, double reference, double ours,
                                    double scale) {
    const double by = scale > 0 ? scale : reference == 0 ? 1 : std::abs(reference);
    const double off = 100 * std::abs(ours - reference) / by;
    // This comparison makes a number that is not finite fail.
    const bool good = off <= from.tolerancePercent;
    numbers.push_back({std::move(numberName), "exact", reference, ours, off, from.tolerancePercent, good, {}});
}

void ValidationResult::compareLimit(std::string numberName, double limit, double ours) {
    const bool good = std::abs(ours) <= limit;
    numbers.push_back({std::move(numberName), "limit", limit, ours, 0, 0, good, {}});
}

void ValidationResult::tell(std::string numberName, double ours) {
    numbers.push_back({std::move(numberName), "ours", 0, ours, 0, 0, std::isfinite(ours), {}});
}

void ValidationResult::compareMeasured(const ValidationCase& from, const std::string& numberName, double ours,
                                       size_t index, const std::string& moment) {
    const auto found = from.measured.find(numberName);
    if (found == from.measured.end() || index >= found->second.values.size()) {
        tell(numberName, ours);
        numbers.back().moment = moment;
        return;
    }
    numbers.push_back(measuredNumber(numberName, found->second.values[index], ours, found->second.tolerancePercent));
    numbers.back().moment = moment;
}

void ValidationResult::compareLeftMeasured(const ValidationCase& from) {
    for (const auto& [measuredName, measured] : from.measured) {
        const auto isOne = [&name = measuredName](const ValidationNumber& number) { return number.name == name; };
        const auto found = std::find_if(numbers.begin(), numbers.end(), isOne);
        const bool missing = found == numbers.end();
        if (!missing && found->origin == "measured") continue;
        const double ours = missing ? std::nan("") : found->ours;
        const auto number = measuredNumber(measuredName, measured.values[0], ours, measured.tolerancePercent);
        numbers.insert(missing ? found : found + 1, number);
    }
}

void runValidationCase(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result) {
    result.name = from.name;
    result.kind = from.kind->name;
    result.file = from.file;
    result.spacing = from.spacing;
    const auto start = std::chrono::steady_clock::now();
    for (const Runner& runner : kRunners)
        if (runner.kind == from.kind->name) {
            runner.run(from, shaders, result);
            result.compareLeftMeasured(from);
            result.wallSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            return;
        }
    throw InputError(from.file, 0,
                     "this program cannot compute cases of kind '" + std::string(from.kind->name) +
                         "' yet; expected another kind");
}

ValidationResult runValidationCase(const ValidationCase& from, gl::ShaderLibrary& shaders) {
    ValidationResult result;
    runValidationCase(from, shaders, result);
    return result;
}

namespace {

/// Returns `text` with blanks in front up to `width`; a negative width puts them behind.
std::string padded(std::string text, int width) {
    const auto size = static_cast<size_t>(std::abs(width));
    if (text.size() >= size) return text;
    const std::string blanks(size - text.size(), ' ');
    return width < 0 ? text + blanks : blanks + text;
}

std::string figure(double value, int digits) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.*g", digits, value);
    return text.data();
}

/// Returns one line of the table: name, origin of the reference, reference, ours, error, tolerance, verdict.
std::string row(const std::array<std::string, 7>& cells) {
    std::string line = "      " + padded(cells[0], -36) + padded(cells[1], -10) + padded(cells[2], 12) +
                       padded(cells[3], 13) + padded(cells[4], 11) + padded(cells[5], 11) + "  " + cells[6];
    line.erase(line.find_last_not_of(' ') + 1);
    return line + "\n";
}

std::string numberText(const ValidationNumber& n) {
    const std::string name = n.moment.empty() ? n.name : n.name + " at " + n.moment;
    if (n.origin == "ours") return row({name, "", "", figure(n.ours, 6), "", "", ""});
    const bool limit = n.origin == "limit";
    return row({name, limit ? "at most" : n.origin, figure(n.reference, 6), figure(n.ours, 6),
                limit ? "" : figure(n.errorPercent, 3) + " %", limit ? "" : figure(n.tolerancePercent, 3) + " %",
                n.passed ? "ok" : "FAIL"});
}

} // namespace

std::string validationHeads() {
    return row({"number", "reference", "value", "ours", "error", "tolerance", "verdict (none: no limit)"});
}

std::string validationText(const ValidationResult& result) {
    std::string text = (result.passed() ? "pass  " : "FAIL  ") + result.name + " (" + result.kind + ", spacing " +
                       figure(result.spacing * 1e3, 4) + " mm, " + std::to_string(result.particles) + " particles, " +
                       std::to_string(result.steps) + " steps, " + figure(result.wallSeconds, 3) + " s)\n";
    for (const ValidationNumber& number : result.numbers)
        text += numberText(number);
    for (const std::string& fault : result.faults)
        text += "      fault: " + fault + "\n";
    if (!result.error.empty()) text += "      ended early: " + result.error + "\n";
    return text;
}

} // namespace meltpool
