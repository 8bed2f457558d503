// `meltpool validate`: the error of the metal against exact solutions and experiments.
#include "app/commands/commands.hpp"
#include "app/platform/lock_notice.hpp"
#include "app/platform/result_head.hpp"
#include "app/platform/say.hpp"
#include "app/platform/stop_signals.hpp"
#include "core/base/error.hpp"
#include "core/base/file_lock.hpp"
#include "core/base/output_file.hpp"
#include "core/base/resources.hpp"
#include "core/base/text.hpp"
#include "core/gl/context.hpp"
#include "core/training/judging/estimates.hpp"
#include "core/training/judging/verdict.hpp"
#include "core/validation/mean_errors.hpp"
#include "core/validation/validation.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <new>
#include <optional>

namespace meltpool {

namespace {

using Json = nlohmann::ordered_json;

/// Finite number, or null: JSON has no other numbers.
Json finite(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json numberJson(const ValidationNumber& number) {
    Json json{{"name", number.name}, {"origin", number.origin}, {"ours", finite(number.ours)}};
    if (number.origin != "ours") json["reference"] = number.reference;
    if (number.origin == "exact" || number.origin == "measured") {
        json["error_percent"] = finite(number.errorPercent);
        json["tolerance_percent"] = number.tolerancePercent;
    }
    if (!number.moment.empty()) json["at"] = number.moment;
    json["passed"] = number.passed;
    return json;
}

Json resultJson(const ValidationResult& result) {
    Json json{{"name", result.name},
              {"kind", result.kind},
              {"file", result.file.string()},
              {"spacing_mm", result.spacing * 1e3},
              {"particles", result.particles},
              {"steps", result.steps},
              {"wall_seconds", result.wallSeconds},
              {"passed", result.passed()}};
    if (!result.error.empty()) json["error"] = result.error;
    if (!result.faults.empty()) json["faults"] = result.faults;
    json["numbers"] = Json::array();
    for (const ValidationNumber& number : result.numbers)
        json["numbers"].push_back(numberJson(number));
    return json;
}

Json meanErrorJson(const MeanError& error) {
    return {{"name", error.name},
            {"count", error.count},
            {"percent", error.percent},
            {"bias_percent", error.bias},
            {"difference", error.difference},
            {"worst_percent", error.worstPercent},
            {"worst_difference", error.worstDifference},
            {"worst_case", error.worstCase}};
}

/// File of --json. It is written again after every case, so that a stopped run leaves its results.
class NumbersFile {
  public:
    NumbersFile(std::filesystem::path file, const std::string& set, const gl::HeadlessContext& context)
        : file_(std::move(file)), json_(resultHead(context.info())) {
        if (!file_.empty() && isPlainFile(file_)) tellUnlocked(lock_.emplace(lockName(file_), file_));
        json_["set"] = set;
        json_["complete"] = false;
        json_["passed"] = false;
        json_["cases"] = Json::array();
        keep();
    }

    void add(const ValidationResult& result) {
        json_["cases"].push_back(resultJson(result));
        keep();
    }

    void finish(bool passed, std::span<const MeanError> errors) {
        json_["mean_errors"] = Json::array();
        for (const MeanError& error : errors)
            json_["mean_errors"].push_back(meanErrorJson(error));
        json_["complete"] = true;
        json_["passed"] = passed;
        if (!file_.empty())
            writeTextFileAtomically(file_, json_.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
    }

  private:
    void keep() const {
        // A pipe or device gets the whole once, at the end.
        if (lock_) writeTextFileAtomically(file_, json_.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
    }

    static std::filesystem::path lockName(std::filesystem::path file) { return file += ".lock"; }

    std::filesystem::path file_;
    std::optional<FileLock> lock_;
    Json json_;
};

/// Named cases, with each folder replaced by the cases in it.
std::vector<std::filesystem::path> withoutFolders(const std::vector<std::filesystem::path>& named) {
    std::vector<std::filesystem::path> files;
    for (const auto& path : named) {
        std::error_code fault;
        if (!std::filesystem::is_directory(path, fault)) {
            files.push_back(path);
            continue;
        }
        const auto inside = validationCaseFiles(path);
        files.insert(files.end(), inside.begin(), inside.end());
    }
    return files;
}

/// Name of the chosen cases in a history: that of the first file or folder; "all" where none is named.
std::string setName(const std::vector<std::filesystem::path>& named) {
    if (named.empty()) return "all";
    const std::filesystem::path path = named.front().has_filename() ? named.front() : named.front().parent_path();
    return path.stem().string();
}

/// Throws if the file of --json is one that is read.
void requireNoSource(const std::filesystem::path& json, const std::vector<std::filesystem::path>& sources) {
    for (const auto& source : sources) {
        std::error_code missing;
        if (!json.empty() && std::filesystem::equivalent(json, source, missing))
            throw InputError(json, 0, "--json names a case that is read; expected another file");
    }
}

/// Level of the verdict on welds at a chart's values: that of a school.
constexpr const char* kChartAcceptance = "iso5817-c";

/// Changes a weld at a chart's values as the request asks. Throws InputError for a value out of range.
void changeChart(ValidationCase& one, const ValidationRequest& request) {
    const auto change = [&](const char* key, const std::optional<double>& value) {
        const auto found = one.numbers.find(key);
        if (!value || found == one.numbers.end()) return;
        const auto& keys = one.kind->keys;
        const auto known = std::find_if(keys.begin(), keys.end(), [&](const CaseKey& each) { return each.key == key; });
        if (*value < known->minimum || *value > known->maximum)
            throw InputError(std::string(key) + " is " + formatNumber(*value) + "; expected a number from " +
                             formatNumber(known->minimum) + " to " + formatNumber(known->maximum));
        found->second = *value;
    };
    if (hasWire(one)) change("voltage_offset_v", request.voltageOffset); // no other machine sets a voltage
    change("speed_factor", request.speedFactor);
}

/// Returns an imperfection that fails, with value and limit.
std::string faultText(const VerdictItem& item) {
    std::string text = item.name;
    if (item.value) text += " " + formatNumber(std::round(*item.value * 100) / 100) + " " + std::string(item.unit);
    if (item.limit)
        text += (item.kind == LimitKind::atLeast ? ", at least " : ", at most ") +
                formatNumber(std::round(*item.limit * 100) / 100) + " " + std::string(item.unit);
    if (item.place) text += ", at " + formatNumber(std::round(*item.place * 1e3) + 0.0) + " mm of the seam";
    return text;
}

/// Returns true if the arc's means let a lesson expect spatter.
bool expectsSpatter(const JudgedWeld& weld) {
    SeamMillimetre mean;
    mean.current = weld.current;
    mean.voltage = weld.voltage;
    const std::vector<Estimate> estimates = estimateImperfections({&mean, 1}, weld.process);
    return std::any_of(estimates.begin(), estimates.end(),
                       [](const Estimate& each) { return each.name == "spatter" && each.value > 0; });
}

/// Judges the weld of a result by ISO 5817 C. A weld at the chart's own values must be accepted; of a changed one the
/// verdict has no reference.
void judgeChart(const ValidationCase& one, ValidationResult& result) {
    if (!result.weld) return;
    const Verdict verdict = judge(result.weld->measures, findAcceptance(kChartAcceptance), result.weld->nominal);
    for (const VerdictItem& item : verdict.items)
        if (item.state == VerdictState::fail) result.faults.push_back(faultText(item));
    const bool changed = one.number("voltage_offset_v") != 0 || one.number("speed_factor") != 1;
    if (changed)
        result.tell("accepted", verdict.accepted ? 1 : 0);
    else
        result.compareExact(one, "accepted", 1, verdict.accepted ? 1 : 0);
    result.tell("spatter_expected", expectsSpatter(*result.weld) ? 1 : 0);
}

/// Reason for a case's early end: the person's input (exit code 2) or the machine (1).
struct Ends {
    std::string input, machine;

    void run(const ValidationCase& one, gl::ShaderLibrary& shaders, ValidationResult& result) {
        try {
            runValidationCase(one, shaders, result);
            judgeChart(one, result);
        } catch (const InputError& error) {
            result.error = error.what();
            if (input.empty()) input = result.error;
        } catch (const std::bad_alloc&) {
            result.error =
                one.file.string() + ": there is not enough memory for this case; expected a larger spacing_mm";
            if (input.empty()) input = result.error;
        } catch (const std::exception& error) {
            result.error = one.file.string() + ": " + error.what();
            if (machine.empty()) machine = result.error;
        }
    }
};

} // namespace

bool runValidation(const ValidationRequest& request) {
    const StopSignals signals("\nmeltpool: stops after this case; Ctrl-C again ends it at once\n");
    const auto files =
        request.cases.empty() ? validationCaseFiles(resourceFolder() / "validation") : withoutFolders(request.cases);
    // Every file is read before the first is run: a fault in the last must not cost the time of the others.
    requireNoSource(request.results.named, files);
    std::vector<ValidationCase> cases;
    for (const auto& file : files)
        changeChart(cases.emplace_back(readValidationCase(file)), request);

    const gl::HeadlessContext context(false);
    gl::ShaderLibrary shaders(resourceFolder() / "shaders");
    const std::string set = setName(request.cases);
    const std::filesystem::path place = request.results.file(context.info(), "validate-" + set);
    NumbersFile numbers(place, set, context);
    Ends ends;
    std::vector<std::string> failed;
    std::vector<ValidationResult> results;
    say("%s", validationHeads().c_str());
    for (const ValidationCase& one : cases) {
        if (StopSignals::asked())
            throw RuntimeFault("the validation was stopped after " + std::to_string(results.size()) + " of " +
                               std::to_string(cases.size()) + " cases");
        ValidationResult result;
        ends.run(one, shaders, result);
        if (!result.passed() || !isQuiet()) std::fputs(validationText(result).c_str(), stdout);
        std::fflush(stdout);
        numbers.add(result);
        if (!result.passed()) failed.push_back(result.name);
        results.push_back(std::move(result));
    }
    const std::vector<MeanError> errors = meanErrors(results);
    say("%s", meanErrorsText(errors).c_str());
    say("%zu of %zu cases passed\n", cases.size() - failed.size(), cases.size());
    for (const std::string& name : failed)
        std::printf("failed: %s\n", name.c_str());
    std::fflush(stdout);
    numbers.finish(failed.empty(), errors);
    if (!place.empty()) sayResult({}, place);
    if (!ends.input.empty()) throw InputError(ends.input);
    if (!ends.machine.empty()) throw RuntimeFault(ends.machine);
    return failed.empty();
}

} // namespace meltpool
