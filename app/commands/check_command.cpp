// `meltpool check`: welds lessons without a screen and compares score, verdict and measured weld with the expected
// ones.
#include "app/commands/commands.hpp"
#include "app/commands/headless_runner.hpp"
#include "app/commands/junit_file.hpp"
#include "app/commands/named_lesson.hpp"
#include "app/platform/progress_bar.hpp"
#include "app/platform/say.hpp"
#include "app/platform/stop_signals.hpp"
#include "core/base/error.hpp"
#include "core/base/output_file.hpp"
#include "core/base/resources.hpp"
#include "core/base/text.hpp"
#include "core/base/words.hpp"
#include "core/gl/context.hpp"
#include "core/gl/software_driver/software_driver.hpp"
#include "core/training/lesson/lesson_check.hpp"
#include "core/training/trainer/trainer.hpp"
#include "core/weld/process/shielding_gas.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace meltpool {

namespace {

namespace fs = std::filesystem;

/// Checks of a folder and its subfolders, in order of their names, without files that have no [expect].
std::vector<fs::path> checksIn(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code fault;
    for (const auto& entry : fs::recursive_directory_iterator(folder, fault))
        if (entry.path().extension() == ".toml" && isLessonCheck(entry.path())) files.push_back(entry.path());
    if (fault) throw InputError(folder, 0, "cannot be read; expected a folder with read permission");
    if (files.empty()) throw InputError(folder, 0, "holds no check; expected a .toml file with a table [expect]");
    std::sort(files.begin(), files.end());
    return files;
}

/// File of a named check: a path, or the name of a lesson that has its own [expect].
fs::path checkNamed(const fs::path& path, const LessonFolders& folders) {
    std::error_code missing;
    if (path.has_parent_path() || lowerExtension(path) == ".toml" || fs::exists(path, missing)) return path;
    return namedLesson(path.string(), folders).file;
}

std::vector<LessonCheck> readChecks(const std::vector<fs::path>& named) {
    const LessonFolders lessons = LessonFolders::ofUser();
    std::vector<LessonCheck> checks;
    for (const fs::path& path : named) {
        std::error_code fault;
        const bool folder = fs::is_directory(path, fault);
        for (const fs::path& file : folder ? checksIn(path) : std::vector{checkNamed(path, lessons)})
            checks.push_back(readLessonCheck(file, lessons));
    }
    return checks;
}

/// Welds a check's lesson to its end.
Judgement weld(const LessonCheck& check, gl::ShaderLibrary& shaders) {
    Trainer trainer(shaders, check.lesson);
    const Seam seam = seamOf(check.lesson.workpiece);
    const PerturbedPath path(check.lesson.torch, seam, check.bend);
    const double seconds = static_cast<double>(check.lesson.run.seconds) * check.bend.time;
    const size_t whole = stepsFor(seconds, trainer.timeStep());
    ProgressBar bar(check.name);
    for (size_t step = 1; step <= whole; ++step) {
        if (StopSignals::asked()) throw RuntimeFault("the check was stopped before its end");
        trainer.applyRecordedChanges();
        trainer.advance(path.sample(trainer.time() + trainer.timeStep()), nullptr);
        requireFinite(trainer);
        bar.show(static_cast<double>(step), static_cast<double>(whole));
    }
    return trainer.judge();
}

/// Prints the score and the measurements in one line.
/// `gas`: see Equipment::gas.
void printOutcome(const CheckOutcome& outcome, const Judgement& judgement, const ShieldingGas* gas) {
    std::string score = judgement.score && judgement.score->scored
                            ? phrase("run.check.score", {{"points", PhraseNumber(judgement.score->total)}})
                            : phrase("run.check.no_score");
    if (judgement.verdict)
        score += phrase("list.separator") +
                 phrase(judgement.verdict->accepted ? "run.check.accepted" : "run.check.not_accepted");
    if (isQuiet() && outcome.passed()) return;
    const std::string expected =
        gas == nullptr ? phrase(outcome.passed() ? "run.check.as_expected" : "run.check.not_as_expected")
                       : phrase(outcome.passed() ? "run.check.as_expected_in_gas" : "run.check.not_as_expected_in_gas",
                                {{"gas", gasText(*gas)}});
    std::printf("%-32s %-28s %s\n", printable(outcome.name, 80).c_str(), score.c_str(), expected.c_str());
    for (const std::string& fault : outcome.faults())
        std::printf("    %s\n", printable(fault, 1000).c_str());
    std::fflush(stdout);
}

CheckOutcome run(const LessonCheck& check, gl::ShaderLibrary& shaders) {
    CheckOutcome outcome{check.name, check.file, {}, {}, {}, 0};
    Judgement judgement;
    const auto start = std::chrono::steady_clock::now();
    try {
        tellForm(check.lesson.torchFile, check.lesson.torch);
        outcome.warnings = tellWarnings(check.lesson);
        judgement = weld(check, shaders);
        outcome.values = checkJudgement(check, judgement);
    } catch (const std::exception& fault) {
        outcome.error = check.file.string() + ": " + fault.what();
    }
    outcome.wallSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    printOutcome(outcome, judgement, equipmentOf(check.lesson.process).gas);
    return outcome;
}

} // namespace

bool runChecks(const CheckRequest& request) {
    const StopSignals signals("\nmeltpool: stops after this step\n");
    // Every file is read before the first is welded.
    const std::vector<LessonCheck> checks = readChecks(request.checks);
    if (!request.junit.empty()) requireWritable(request.junit);
    gl::runDriverSingleThreaded();
    const gl::HeadlessContext context(false);
    gl::ShaderLibrary shaders(resourceFolder() / "shaders");
    std::vector<CheckOutcome> outcomes;
    for (const LessonCheck& check : checks) {
        outcomes.push_back(run(check, shaders));
        // Written after each, so that a stopped run leaves its results.
        if (!request.junit.empty()) writeJunitFile(request.junit, outcomes);
        if (StopSignals::asked())
            throw RuntimeFault("the checks were stopped after " + std::to_string(outcomes.size()) + " of " +
                               std::to_string(checks.size()));
    }
    const auto passed = std::count_if(outcomes.begin(), outcomes.end(), [](const auto& each) { return each.passed(); });
    say("%s\n",
        phrase("run.check.passed", {{"passed", std::to_string(passed)}, {"checks", std::to_string(outcomes.size())}})
            .c_str());
    if (!request.junit.empty()) sayResult({}, request.junit);
    return passed == static_cast<std::ptrdiff_t>(outcomes.size());
}

} // namespace meltpool
