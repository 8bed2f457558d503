// Runner of validation cases: it reports the metal's errors against exact solutions and experiments.
#pragma once

#include "core/gl/program.hpp"
#include "core/validation/validation_case.hpp"
#include "core/weld/gauge/weld_figures.hpp"
#include "core/weld/process/processes.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace meltpool {

/// One number of a result with its reference.
struct ValidationNumber {
    std::string name; ///< documented name, such as front_mm
    /// "exact", "measured", "limit" (ours must stay below the reference) or "ours" (without a reference).
    std::string origin;
    double reference = 0;
    double ours = 0;
    double errorPercent = 0; ///< relative to `scale`; for "limit": 0
    double tolerancePercent = 0;
    bool passed = true;
    std::string moment; ///< distinguishes several with one name, such as "132 s"; else empty
};

/// A whole weld for a verdict by a standard's limits.
struct JudgedWeld {
    WeldMeasures measures;
    NominalWeld nominal;
    ProcessSettings process;
    double current = 0, voltage = 0; ///< A, V of the arc, means over the time in which it burned
};

struct ValidationResult {
    std::string name;
    std::string kind;
    std::filesystem::path file;
    double spacing = 0; ///< m
    size_t particles = 0;
    size_t steps = 0;
    double wallSeconds = 0;
    std::vector<ValidationNumber> numbers;
    std::string error; ///< reason why the case ended early; else empty
    std::optional<JudgedWeld> weld;  ///< of a weld at a chart's values
    std::vector<std::string> faults; ///< imperfections of that weld beyond a limit, in words

    bool passed() const;

    /// Adds a number that has a closed form; the error is relative to `scale` (the reference itself for 0).
    void compareExact(const ValidationCase& from, std::string numberName, double reference, double ours,
                      double scale = 0);
    /// Adds a number that must not exceed `limit`.
    void compareLimit(std::string numberName, double limit, double ours);
    /// Adds a number without a reference.
    void tell(std::string numberName, double ours);
    /// Compares with value `index` of [measured] if the case gives that name; else only adds it.
    void compareMeasured(const ValidationCase& from, const std::string& numberName, double ours, size_t index = 0,
                         const std::string& moment = {});
    /// Compares the values of [measured] that are not compared yet, next to the closed form or the number without a
    /// reference; a number that the case did not yield fails.
    void compareLeftMeasured(const ValidationCase& from);
};

/// Runs one case on the current GL context. Throws InputError if the case cannot be built, RuntimeFault if the state
/// stops being finite.
ValidationResult runValidationCase(const ValidationCase& from, gl::ShaderLibrary& shaders);

/// Runs one case into `result`, which then still has the numbers found before a fault.
void runValidationCase(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result);

/// Function that runs a kind of case; fills numbers, particles and steps.
using CaseRunner = void (*)(const ValidationCase&, gl::ShaderLibrary&, ValidationResult&);

void runConductionStep(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result);
void runConductionFlux(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result);
void runStefan(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result);
void runRosenthal(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result);
void runEnergy(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result);
void runCavityMelting(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result);
void runBeadOnPlate(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result);
void runFillet(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result);
void runChartWeld(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result);
void runArcSpot(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result);
void runCooling(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result);
void runDropletPressure(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result);
void runDropletOscillation(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result);
void runSessileDrop(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result);
void runHydrostatic(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result);
void runDamBreak(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result);
void runPoiseuille(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result);

/// Returns the heads of the table's columns.
std::string validationHeads();

/// Returns the table that `meltpool validate` prints for one case: a line a number.
std::string validationText(const ValidationResult& result);

} // namespace meltpool
